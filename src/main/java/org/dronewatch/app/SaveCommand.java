package org.dronewatch.app;

import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.dronewatch.app.console.Notes;
import org.dronewatch.app.option.SceneChoice;
import org.dronewatch.app.option.SeedOption;
import org.dronewatch.flight.Steered;
import org.dronewatch.flight.mission.PlanWriter;
import org.dronewatch.report.file.WholeFile;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scenario.SceneWriter;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.setting.Counted;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Writes a scene with its overrides, or one run of its sweep, as a scene file. */
@Command(
        name = "save",
        mixinStandardHelpOptions = true,
        description = "Writes a scene with its overrides, or one run of its sweep, as a scene file that gives the same"
                + " results; or a flight as a QGroundControl mission.",
        footer = {
            "",
            "Examples:",
            "  dronewatch save camera-range --run 2 --set run.duration=30s --out third.yaml",
            "  dronewatch save site.yaml --flight intruder --out intruder.plan"
        })
final class SaveCommand implements Callable<Integer> {
    @Mixin
    private SceneChoice choice;

    @Option(
            names = "--run",
            paramLabel = "N",
            description = "Index of the run in a sweep, counted from 0, to save with its own seed; by default the whole"
                    + " sweep or, with --flight, run 0.")
    private Integer run;

    @Mixin
    private SeedOption seed = new SeedOption();

    @Option(
            names = "--flight",
            paramLabel = "DRONE",
            description = "Writes the flight of this drone as a QGroundControl plan instead of the scene;"
                    + " the scene's world.origin must be set.")
    private String flight;

    @Option(
            names = "--out",
            required = true,
            paramLabel = "FILE",
            description =
                    "File to write, .yaml or .yml, or .plan with --flight; the scene's own models must be in the directory of this file or below it. An existing file"
                            + " is replaced only if 'save' wrote it.")
    private String out;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        if (flight != null) {
            return saveFlight();
        }
        if (!SceneFile.isFileName(out)) {
            throw new InputException("--out " + PlainText.value(out) + ": must end in .yaml or .yml");
        }
        WholeFile target = new WholeFile("--out", out);
        if (choice.isSceneFile(target.path())) {
            throw new InputException(
                    "--out " + PlainText.value(out) + ": is the scene file itself; choose another file");
        }
        target = target.replacingOnly(SceneWriter.FIRST_LINE, "'save'");
        Scene scene = choice.create();
        SceneRunner runner = choice.runner(scene);
        runner.notes(Notes.of(spec));
        seed.apply(runner);
        SceneSettings settings = run == null ? runner.settings() : SceneChoice.settingsOfRun(runner, run);
        byte[] text = runner.text(settings, target.path()).getBytes(StandardCharsets.UTF_8);
        target.write(stream -> stream.write(text));
        Notes.of(spec).accept("scene in " + PlainText.value(out));
        noteSteeredDrones(settings);
        return 0;
    }

    private void noteSteeredDrones(SceneSettings settings) {
        settings.drones().forEach((name, drone) -> {
            if (drone.flight() instanceof Steered) {
                Notes.of(spec)
                        .accept("drones." + name + ".flight: is steered by a program, which a scene file"
                                + " cannot contain: use another kind of flight before you run the file");
            }
        });
    }

    private int saveFlight() {
        if (!out.toLowerCase(Locale.ROOT).endsWith(".plan")) {
            throw new InputException("--out " + PlainText.value(out) + ": must end in .plan for a flight");
        }
        WholeFile target = new WholeFile("--out", out).replacingOnly(PlanWriter.FIRST_LINE, "'save'");
        SceneRunner runner = choice.runner(choice.create());
        runner.notes(Notes.of(spec));
        SceneSettings settings = SceneChoice.settingsOfRun(runner, run == null ? 0 : run);
        PlanWriter.Written plan = SavedFlight.of(settings, flight, runner);
        target.write(stream -> stream.write(plan.text().getBytes(StandardCharsets.UTF_8)));
        Notes.of(spec)
                .accept(String.format(
                        Locale.ROOT,
                        "mission of %s in %s: the flight deviates from the straight legs of the mission"
                                + " by at most %.1f m",
                        Counted.of(plan.items(), "item"),
                        PlainText.value(out),
                        plan.tolerance()));
        return 0;
    }
}
