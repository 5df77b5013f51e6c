package org.dronewatch.fuzz;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.Observation;
import org.dronewatch.setting.InputException;

/**
 * Whole runs of random scenes: what {@code check} accepts runs to its end, with the same results on any number of
 * threads.
 */
final class RunTarget implements FuzzTarget {
    private static final int LARGE_EVERY = 3;

    /** Most scenes run without a report, which takes many times as long as they do. */
    private static final String WITHOUT_REPORT = "scene by its schema, without a report";

    private static final String RENDER = "render";

    @Override
    public String name() {
        return "run";
    }

    @Override
    public FuzzCase generate(Dice dice, long number) {
        boolean large = number % LARGE_EVERY == 0;
        SchemaScenes scenes = new SchemaScenes(dice, large);
        String scene = scenes.scene();
        String camera = scenes.largeSensor();
        if (!camera.isEmpty()) {
            return SampleSite.scene(
                    "large picture",
                    scene,
                    RENDER,
                    "{}/" + SampleSite.SCENE,
                    "--camera",
                    camera,
                    "--out",
                    "{}/view.png");
        }
        return SampleSite.scene(
                dice.oneIn(6) ? "scene by its schema" : WITHOUT_REPORT,
                scene,
                "run",
                "{}/" + SampleSite.SCENE,
                "--observations");
    }

    @Override
    public Duration longest() {
        return Duration.ofSeconds(30);
    }

    @Override
    public void judge(FuzzCase input, Path directory) throws IOException {
        String[] arguments = input.argumentsIn(directory);
        CommandRun check = Judge.run(directory, "check", arguments[1]);
        if (check.code() != 0) {
            return;
        }
        if (arguments[0].equals(RENDER)) {
            judge(CommandRun.of(arguments), directory);
            return;
        }
        if (input.what().equals(WITHOUT_REPORT)) {
            Path scene = Path.of(arguments[1]);
            if (!observations(scene, 1).equals(observations(scene, 3))) {
                throw new Failure("the same observations for any number of threads", "they differ");
            }
            return;
        }
        for (int threads = 1; threads <= 3; threads += 2) {
            List<String> command = new ArrayList<>(List.of(arguments));
            Path out = directory.resolve("threads-" + threads);
            command.addAll(List.of("--threads", Integer.toString(threads), "--out", out.toString()));
            CommandRun run = CommandRun.of(command.toArray(String[]::new));
            if (!judge(run, directory)) {
                return;
            }
            ResultFiles.check(out, run.out());
        }
        ResultFiles.same(directory.resolve("threads-1"), directory.resolve("threads-3"));
    }

    private static List<Observation> observations(Path scene, int threads) {
        List<Observation> all = new ArrayList<>();
        try {
            new SceneRunner(new SceneFile(scene))
                    .threads(threads)
                    .onFrame(frame -> all.addAll(frame.observations()))
                    .run();
        } catch (InputException e) {
            throw new Failure("what check takes, run can do", e.getMessage());
        }
        return all;
    }

    /** Whether a command came to its end; false if it reported that there is not enough memory for it. */
    private static boolean judge(CommandRun run, Path directory) {
        if (run.code() != 0 && isTooLarge(run, directory)) {
            return false;
        }
        Judge.check(run, directory);
        if (run.code() != 0) {
            throw new Failure(
                    "what check takes, run can do", "exit code " + run.code() + ": " + Messages.firstLine(run.err()));
        }
        return true;
    }

    /** Whether a run reported in one plain line that there is not enough memory for it. */
    private static boolean isTooLarge(CommandRun run, Path directory) {
        List<String> mistakes = Messages.mistakes(run.err());
        return mistakes.size() == 1
                && mistakes.get(0).toLowerCase(Locale.ROOT).contains("memory")
                && Messages.fault(run.err(), directory).isEmpty();
    }
}
