package org.dronewatch.app;

import java.util.Optional;
import java.util.concurrent.Callable;
import org.dronewatch.app.console.ExitCode;
import org.dronewatch.app.console.Notes;
import org.dronewatch.app.option.BesideOption;
import org.dronewatch.app.option.OptionalSceneChoice;
import org.dronewatch.app.option.SeedOption;
import org.dronewatch.app.option.ThreadsOption;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.viewer.GalleryWindow;
import org.dronewatch.viewer.Viewer;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Opens a window that shows a scene while it runs and afterwards. */
@Command(
        name = "view",
        mixinStandardHelpOptions = true,
        description = {
            "Opens a window with the site in 3D, all cameras' pictures, sound rays, a timeline of detections and tables.",
            "Without a scene, shows the packaged ones to choose from.",
            "Needs a display; 'render' draws the same pictures without one."
        },
        footer = {
            "",
            "Examples:",
            "  dronewatch view",
            "  dronewatch view multi-sensor --set drones.quadrotor.flight.bearing=45deg",
            "  dronewatch view scenes/hill-radar.yaml --coverage",
            "  dronewatch view multi-sensor --set sensors.microphone.enabled=false --beside multi-sensor"
        })
final class ViewCommand implements Callable<Integer> {
    @Mixin
    private OptionalSceneChoice choice;

    @Mixin
    private SeedOption seed = new SeedOption();

    @Option(
            names = "--coverage",
            description = "Also computes the coverage, with the defaults of 'coverage', and shows it over the site.")
    private boolean coverage;

    @Mixin
    private BesideOption beside = new BesideOption();

    @Mixin
    private ThreadsOption threads = new ThreadsOption();

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        Optional<Viewer.Subject> named = choice.isNamed() ? Optional.of(named()) : Optional.empty();
        Optional<Viewer.Subject> other = beside.scene(choice).map(this::other);
        SceneWindow window =
                new SceneWindow(threads.number(), spec.commandLine().getErr(), Notes.of(spec));
        if (!window.canOpen()) {
            return ExitCode.NO_DISPLAY;
        }
        named.or(() -> GalleryWindow.choose(this::runner))
                .ifPresent(first -> window.show(
                        first,
                        viewer -> {
                            if (coverage) {
                                viewer.showCoverage();
                            }
                        },
                        other));
        return 0;
    }

    private Viewer.Subject named() {
        Scene scene = choice.create();
        SceneRunner runner = runner(scene);
        runner.settings();
        return new Viewer.Subject(scene, runner, choice.sceneFile());
    }

    /** The scene that is shown beside the first, without the overrides of the first. */
    private Viewer.Subject other(Scene scene) {
        SceneRunner runner =
                new SceneRunner(scene).store(choice.runner(scene).store()).threads(threads.number());
        seed.apply(runner);
        runner.settings();
        return new Viewer.Subject(scene, runner, Optional.empty());
    }

    private SceneRunner runner(Scene scene) {
        SceneRunner runner = choice.runner(scene).threads(threads.number());
        seed.apply(runner);
        return runner;
    }
}
