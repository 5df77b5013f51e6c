package org.dronewatch.app;

import java.io.PrintWriter;
import java.util.List;
import java.util.concurrent.Callable;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** Reads and validates a scene and runs nothing. */
@Command(
        name = "check",
        mixinStandardHelpOptions = true,
        description = "Reads and validates a scene with its models; runs nothing.",
        footer = {"", "Example: dronewatch check camera-range --set sensors.camera.width=1280"})
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
        runs.forEach(runner::stage);
        spec.commandLine()
                .getOut()
                .printf(
                        "%s is valid: %d model(s), %d drone(s), %d sensor(s), %d run(s) of %s s%n",
                        scene.name(),
                        runs.get(0).world().models().size(),
                        runs.get(0).fliers().size(),
                        runs.get(0).enabledSensors().size(),
                        runs.size(),
                        runs.get(0).run().duration());
        return 0;
    }
}
