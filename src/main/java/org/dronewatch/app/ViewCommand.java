package org.dronewatch.app;

import java.util.Optional;
import java.util.concurrent.Callable;
import org.dronewatch.scene.Scene;
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
            "Opens a window: the site in 3D, what every camera sees, rays of sound, a time line of detections, tables.",
            "Needs a display; 'render' draws the same pictures without one."
        },
        footer = {"", "Example: dronewatch view multi-sensor --set drones.quadrotor.flight.bearing=45deg"})
final class ViewCommand implements Callable<Integer> {
    @Mixin
    private SceneChoice choice;

    @Option(names = "--seed", paramLabel = "N", description = "Seed of all random numbers.")
    private Long seed;

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
        try (Viewer viewer = Viewer.open(scene, runner, threads.number())) {
            show(viewer, runner, spec);
        }
        return 0;
    }

    /** One line for a person. */
    static String noWindow(String obstacle) {
        return "cannot open a window: " + obstacle + "; 'render' draws pictures without one";
    }

    private static void show(Viewer viewer, SceneRunner runner, CommandSpec spec) {
        runner.notes(line -> {
                    spec.commandLine().getErr().println(line);
                    viewer.note(line);
                })
                .listener(viewer.listener())
                .cancelWhen(viewer::isClosed);
        try {
            viewer.finished(runner.run().complete());
        } catch (RuntimeException e) {
            if (viewer.isClosed()) {
                return;
            }
            viewer.failed(e);
            viewer.awaitClosed();
            throw e;
        }
        viewer.awaitClosed();
    }
}
