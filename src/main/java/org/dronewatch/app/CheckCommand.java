package org.dronewatch.app;

import java.io.PrintWriter;
import java.util.List;
import java.util.concurrent.Callable;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.ThreatLabel;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.world.WorldSettings;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** Reads and validates a scene and runs nothing. */
@Command(
        name = "check",
        mixinStandardHelpOptions = true,
        description = "Reads and validates a scene with its models; runs nothing.",
        footer = {"", "Example:", "  dronewatch check camera-range --set sensors.camera.width=1280"})
final class CheckCommand implements Callable<Integer> {
    @Mixin
    private SceneChoice choice;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        Scene scene = choice.create();
        SceneRunner runner = choice.runner(scene);
        PrintWriter err = spec.commandLine().getErr();
        runner.notes(err::println);
        List<SceneSettings> runs = runner.settingsOfRuns();
        runs.forEach(runner::checkPilot);
        runner.adviseOnConditions();
        runs.forEach(runner::stage);
        SceneSettings first = runs.get(0);
        spec.commandLine()
                .getOut()
                .printf(
                        "%s is valid: %s, %s, %s, %s of %s s%n",
                        scene.name(),
                        site(first.world()),
                        drones(first),
                        sensors(first),
                        counted(runs.size(), "run"),
                        first.run().duration());
        first.drones().forEach(this::printLabel);
        return 0;
    }

    private void printLabel(String id, DroneSettings drone) {
        if (!drone.label().equals(ThreatLabel.DEFAULT)) {
            spec.commandLine()
                    .getOut()
                    .printf("drone '%s' is labelled %s%n", id, drone.label().inWords());
        }
    }

    private static String site(WorldSettings world) {
        return (world.terrain().isPresent() ? "terrain, " : "")
                + (world.buildings().isPresent() ? "buildings, " : "")
                + counted(world.models().size(), "model");
    }

    /** All sensors of a run, and how many of them are switched off, if any. */
    private static String sensors(SceneSettings run) {
        int off = run.disabled().size();
        return counted(run.sensors().size(), "sensor") + (off == 0 ? "" : " (" + off + " switched off)");
    }

    private static String drones(SceneSettings scene) {
        int birds = scene.birds().size();
        String drones = counted(scene.individualDrones().size() - birds, "drone");
        return birds == 0 ? drones : drones + ", " + counted(birds, "bird");
    }

    private static String counted(int count, String noun) {
        return count + " " + noun + (count == 1 ? "" : "s");
    }
}
