package org.dronewatch.app;

import java.io.PrintWriter;
import java.util.Optional;
import java.util.function.Consumer;
import org.dronewatch.run.store.StorePlace;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.viewer.Viewer;

/** A window in which a scene runs, then others that the user opens in it, until it is closed. */
final class SceneWindow {
    private final int threads;
    private final PrintWriter err;
    private final Consumer<String> notes;

    /**
     * A window that is not open yet.
     *
     * @param threads number of threads that run scenes and draw
     * @param err receives the reason why there is no window
     * @param notes receives the notes of all runs
     */
    SceneWindow(int threads, PrintWriter err, Consumer<String> notes) {
        this.threads = threads;
        this.err = err;
        this.notes = notes;
    }

    /** Whether a window can be opened; if not, says why. */
    boolean canOpen() {
        Optional<String> obstacle = Viewer.obstacle();
        obstacle.ifPresent(reason -> err.println(noWindow(reason)));
        return obstacle.isEmpty();
    }

    /** One line that states why there is no window. */
    static String noWindow(String obstacle) {
        return "cannot open a window: " + obstacle + "; 'render' draws pictures without one";
    }

    /**
     * Opens the window and returns when it is closed.
     *
     * @param first what is shown first
     * @param begun is called when the window is open
     * @throws RuntimeException the error with which the last run ended, unless the window was closed meanwhile
     */
    void show(Viewer.Subject first, Consumer<Viewer> begun) {
        show(first, begun, Optional.empty());
    }

    /**
     * Opens the window as {@link #show(Viewer.Subject, Consumer)} does, and runs a second scene for comparison after
     * the first.
     *
     * @param beside the second scene; empty for none
     */
    void show(Viewer.Subject first, Consumer<Viewer> begun, Optional<Viewer.Subject> beside) {
        Optional<RuntimeException> failure = Optional.empty();
        try (Viewer viewer = Viewer.open(
                first, threads, scene -> runner(scene, first.runner().store()))) {
            begun.accept(viewer);
            Optional<Viewer.Subject> second = beside;
            for (Optional<Viewer.Subject> shown = Optional.of(first); shown.isPresent(); shown = viewer.awaitNext()) {
                failure = run(viewer, shown.get().runner());
                if (second.isPresent() && failure.isEmpty()) {
                    failure = runBeside(viewer, second.get());
                }
                second = Optional.empty();
            }
        }
        if (failure.isPresent()) {
            throw failure.get();
        }
    }

    /**
     * The runner of another scene that the user opens: the scene as it is described, without the overrides of the
     * first.
     */
    private SceneRunner runner(Scene scene, StorePlace store) {
        return new SceneRunner(scene).store(store).threads(threads);
    }

    /** Runs a scene for a window; returns the error, unless the window is closed. */
    private Optional<RuntimeException> run(Viewer viewer, SceneRunner runner) {
        takeNotes(viewer, runner).listener(viewer.listener()).cancelWhen(viewer::isLeft);
        return run(viewer, () -> viewer.finished(runner.run().complete()));
    }

    /** Runs another scene beside the one that is shown; returns the error, unless the window is closed. */
    private Optional<RuntimeException> runBeside(Viewer viewer, Viewer.Subject other) {
        SceneRunner runner = takeNotes(viewer, other.runner());
        return run(viewer, () -> viewer.runBeside(other.scene().name(), runner));
    }

    private SceneRunner takeNotes(Viewer viewer, SceneRunner runner) {
        return runner.notes(line -> {
            notes.accept(line);
            viewer.note(line);
        });
    }

    private static Optional<RuntimeException> run(Viewer viewer, Runnable running) {
        try {
            running.run();
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
