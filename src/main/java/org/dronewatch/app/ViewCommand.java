package org.dronewatch.app;

import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.viewer.Viewer;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Opens a window in which a scene is looked at while it runs and afterwards. */
@Command(
        name = "view",
        mixinStandardHelpOptions = true,
        description = {
            "Opens a window with the site in 3D, all cameras' pictures, sound rays, a timeline of detections and tables.",
            "Needs a display; 'render' draws the same pictures without one."
        },
        footer = {
            "",
            "Examples:",
            "  dronewatch view multi-sensor --set drones.quadrotor.flight.bearing=45deg",
            "  dronewatch view scenes/hill-radar.yaml --coverage"
        })
final class ViewCommand implements Callable<Integer> {
    @Mixin
    private SceneChoice choice;

    @Option(names = "--seed", paramLabel = "N", description = "Seed of all random numbers.")
    private Long seed;

    @Option(
            names = "--coverage",
            description = "Also computes the coverage, with the defaults of 'coverage', and shows it over the site.")
    private boolean coverage;

    @Mixin
    private ThreadsOption threads = new ThreadsOption();

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        Scene scene = choice.create();
        SceneRunner runner = choice.runner(scene).threads(threads.number());
        if (seed != null) {
            runner.seed(seed);
        }
        runner.settings();
        Optional<String> obstacle = Viewer.obstacle();
        if (obstacle.isPresent()) {
            spec.commandLine().getErr().println(noWindow(obstacle.get()));
            return Main.NO_DISPLAY;
        }
        Viewer.Subject first = new Viewer.Subject(scene, runner, choice.sceneFile());
        Optional<RuntimeException> failure = Optional.empty();
        try (Viewer viewer = Viewer.open(first, threads.number(), this::read)) {
            if (coverage) {
                viewer.showCoverage();
            }
            for (Optional<Viewer.Subject> shown = Optional.of(first); shown.isPresent(); shown = viewer.awaitNext()) {
                failure = show(viewer, shown.get().runner());
            }
        }
        if (failure.isPresent()) {
            throw failure.get();
        }
        return 0;
    }

    /** Another scene that the user opens in the window: as it is described, without the overrides of the first. */
    private Viewer.Subject read(Path file) {
        Scene scene = new SceneFile(file);
        SceneRunner runner = new SceneRunner(scene).threads(threads.number());
        runner.settings();
        return new Viewer.Subject(scene, runner, Optional.of(file));
    }

    /** One line for a person. */
    static String noWindow(String obstacle) {
        return "cannot open a window: " + obstacle + "; 'render' draws pictures without one";
    }

    /** Runs a scene for a window; returns the error, unless the window is closed. */
    private Optional<RuntimeException> show(Viewer viewer, SceneRunner runner) {
        runner.notes(line -> {
                    spec.commandLine().getErr().println(line);
                    viewer.note(line);
                })
                .listener(viewer.listener())
                .cancelWhen(viewer::isLeft);
        try {
            viewer.finished(runner.run().complete());
            return Optional.empty();
        } catch (RuntimeException e) {
            if (viewer.isLeft()) {
                return Optional.empty();
            }
            viewer.failed(e);
            return Optional.of(e);
        }
    }
}
