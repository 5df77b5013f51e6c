package org.dronewatch.app;

import java.io.PrintWriter;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.dronewatch.analysis.survey.MountingHeight;
import org.dronewatch.app.console.Notes;
import org.dronewatch.app.option.JsonOption;
import org.dronewatch.app.option.SceneChoice;
import org.dronewatch.drone.ThreatLabel;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.report.html.BlockerWords;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.setting.Counted;
import org.dronewatch.world.WorldSettings;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** Reads and validates a scene and runs nothing. */
@Command(
        name = "check",
        mixinStandardHelpOptions = true,
        description = "Reads and validates a scene with its models; runs nothing.",
        footer = {"", "Example:", "  dronewatch check camera-range --set sensors.camera.width=1280"})
final class CheckCommand implements Callable<Integer> {
    /** Maximum number of sensors whose heights are printed. */
    private static final int MOST_SENSORS = 30;

    @Mixin
    private SceneChoice choice;

    @Mixin
    private JsonOption json = new JsonOption();

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        Scene scene = choice.create();
        SceneRunner runner = choice.runner(scene);
        runner.notes(Notes.of(spec));
        List<SceneSettings> runs = runner.settingsOfRuns();
        runs.forEach(runner::checkPilot);
        runner.adviseOnConditions();
        Map<String, Optional<MountingHeight>> heights = heights(runs.get(0), runner.stage(runs.get(0)));
        runs.stream().skip(1).forEach(runner::stage);
        json.print(() -> toJson(scene, runs, heights), out -> print(scene, runs, heights, out));
        return 0;
    }

    private static Map<String, Optional<MountingHeight>> heights(SceneSettings run, Stage stage) {
        Map<String, Optional<MountingHeight>> heights = new LinkedHashMap<>();
        run.sensors().forEach((name, sensor) -> heights.put(name, MountingHeight.at(sensor.position(), stage)));
        return heights;
    }

    private static void print(
            Scene scene, List<SceneSettings> runs, Map<String, Optional<MountingHeight>> heights, PrintWriter out) {
        SceneSettings first = runs.get(0);
        out.printf(
                "%s is valid: %s, %s, %s, %s of %s s%n",
                scene.name(),
                site(first.world()),
                drones(first),
                sensors(first),
                Counted.of(runs.size(), "run"),
                first.run().duration());
        labels(first).forEach((id, label) -> out.printf("drone '%s' is labelled %s%n", id, label));
        heights.entrySet().stream()
                .limit(MOST_SENSORS)
                .forEach(sensor -> out.printf(
                        Locale.ROOT,
                        "sensor '%s' is %s%s%s%n",
                        sensor.getKey(),
                        sensor.getValue().map(CheckCommand::inWords).orElse("not above any surface"),
                        runs.size() == 1 ? "" : " in the first run",
                        first.disabled().contains(sensor.getKey()) ? " (switched off)" : ""));
        if (heights.size() > MOST_SENSORS) {
            out.printf("... and %s%n", Counted.of(heights.size() - MOST_SENSORS, "more sensor"));
        }
    }

    private static String inWords(MountingHeight height) {
        return String.format(Locale.ROOT, "%.1f m above %s", height.metres(), BlockerWords.footing(height.surface()));
    }

    /** The labels of the drones that have one, in words. */
    private static Map<String, String> labels(SceneSettings run) {
        Map<String, String> labels = new LinkedHashMap<>();
        run.drones().forEach((id, drone) -> {
            if (!drone.label().equals(ThreatLabel.DEFAULT)) {
                labels.put(id, drone.label().inWords());
            }
        });
        return labels;
    }

    private static ObjectNode toJson(
            Scene scene, List<SceneSettings> runs, Map<String, Optional<MountingHeight>> heights) {
        SceneSettings first = runs.get(0);
        ObjectNode root = JsonNodeFactory.instance.objectNode();
        root.put("scene", scene.name());
        root.put("terrain", first.world().terrain().isPresent());
        root.put("buildings", first.world().buildings().isPresent());
        root.put("models", first.world().models().size());
        root.put("drones", first.individualDrones().size() - first.birds().size());
        root.put("birds", first.birds().size());
        root.put("sensors", first.sensors().size());
        root.put("switched_off", first.disabled().size());
        root.put("runs", runs.size());
        root.put("duration_s", Numbers.rounded(first.run().duration()));
        ObjectNode labels = root.putObject("labels");
        labels(first).forEach(labels::put);
        ObjectNode above = root.putObject("heights");
        heights.forEach((name, height) -> {
            ObjectNode one = above.putObject(name);
            one.put("above_m", height.map(its -> Numbers.rounded(its.metres())).orElse(null));
            one.put(
                    "surface",
                    height.map(its -> BlockerWords.footing(its.surface())).orElse(null));
        });
        return root;
    }

    private static String site(WorldSettings world) {
        return (world.terrain().isPresent() ? "terrain, " : "")
                + (world.buildings().isPresent() ? "buildings, " : "")
                + Counted.of(world.models().size(), "model");
    }

    /** All sensors of a run, and how many of them are switched off, if any. */
    private static String sensors(SceneSettings run) {
        int off = run.disabled().size();
        return Counted.of(run.sensors().size(), "sensor") + (off == 0 ? "" : " (" + off + " switched off)");
    }

    private static String drones(SceneSettings scene) {
        int birds = scene.birds().size();
        String drones = Counted.of(scene.individualDrones().size() - birds, "drone");
        return birds == 0 ? drones : drones + ", " + Counted.of(birds, "bird");
    }
}
