package org.dronewatch.viewer;

import java.awt.AWTError;
import java.awt.GraphicsEnvironment;
import java.awt.Toolkit;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.function.Function;
import javax.swing.SwingUtilities;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.render.canvas.SiteLines;
import org.dronewatch.run.SceneListener;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.viewer.part.EventWork;
import org.dronewatch.viewer.run.Recording;

/**
 * A window that shows a scene during a run and afterwards. It listens to a run, like a report, and does not affect the
 * results.
 *
 * <pre>{@code
 * SceneRunner runner = new SceneRunner(scene);
 * try (Viewer viewer = Viewer.open(scene, runner, 2)) {
 *     runner.listener(viewer.listener()).cancelWhen(viewer::isClosed).run();
 *     viewer.finished(true);
 *     viewer.awaitClosed();
 * }
 * }</pre>
 */
public final class Viewer implements AutoCloseable {
    private final CountDownLatch closed = new CountDownLatch(1);
    private final Thread runner = Thread.currentThread();
    private final int threads;
    private volatile ViewerWindow window;
    private Optional<SceneOpening> opening = Optional.empty();

    // The window's threads read these.
    private volatile Recording recording = new Recording();
    private volatile Recording running = recording;
    private volatile ViewerPane pane;
    private volatile boolean closing;
    private volatile Subject next;

    /** Whether the thread that runs scenes closes the window itself: it reads nothing then. */
    private volatile boolean ended;

    /**
     * A scene to be shown.
     *
     * @param scene the scene
     * @param runner the runner that will run it; it also provides the settings and the stage of the view
     * @param file the scene's file, which is added to the list of recent scenes; empty if there is none
     */
    public record Subject(Scene scene, SceneRunner runner, Optional<Path> file) {}

    private Viewer(int threads) {
        this.threads = threads;
    }

    /** The reason why no window can be opened; empty if one can. */
    public static Optional<String> obstacle() {
        if (GraphicsEnvironment.isHeadless()) {
            return Optional.of("there is no display");
        }
        try {
            Toolkit.getDefaultToolkit().getScreenSize();
            return Optional.empty();
        } catch (AWTError | LinkageError e) {
            return Optional.of("this display cannot be used: "
                    + String.valueOf(e.getMessage()).replaceFirst("\\.$", ""));
        }
    }

    /**
     * Opens the window, with the layout in which the user last closed it. The calling thread is expected to run the
     * scene, and is interrupted if the window is closed while models are still being read.
     *
     * @param runner the runner that will run the scene; it also provides the settings and the stage of the view
     * @param threads number of threads that render
     * @throws IllegalStateException when there is no display
     */
    public static Viewer open(Scene scene, SceneRunner runner, int threads) {
        return open(scene, runner, threads, ViewerLayout.ofUser());
    }

    /**
     * Opens the window as {@link #open(Scene, SceneRunner, int)}, with a menu that opens other scenes in the same
     * window. The calling thread is expected to run the scenes one after another: {@link #awaitNext} returns the next.
     *
     * @param runners returns the runner of a scene that the user opens
     * @throws IllegalStateException when there is no display
     */
    public static Viewer open(Subject subject, int threads, Function<Scene, SceneRunner> runners) {
        return open(subject, threads, ViewerLayout.ofUser(), Optional.of(runners));
    }

    static Viewer open(Scene scene, SceneRunner runner, int threads, Path layoutFile) {
        return open(new Subject(scene, runner, Optional.empty()), threads, layoutFile, Optional.empty());
    }

    static Viewer open(Subject subject, int threads, Path layoutFile, Optional<Function<Scene, SceneRunner>> runners) {
        Optional<String> obstacle = obstacle();
        if (obstacle.isPresent()) {
            throw new IllegalStateException(obstacle.get());
        }
        Viewer viewer = new Viewer(threads);
        ViewerLayout layout = new ViewerLayout(layoutFile);
        RecentScenes recent = new RecentScenes(layoutFile.resolveSibling("recent-scenes.txt"));
        viewer.opening = runners.map(
                made -> new SceneOpening(recent, made, viewer::choose, problem -> viewer.pane.report(problem)));
        viewer.opening.ifPresent(any -> subject.file().ifPresent(recent::add));
        // One thing after the other, so that the event thread is never busy for long.
        EventWork.await(() -> ViewerWindow.setLook(layout.isDark()));
        EventWork.await(() -> viewer.pane = viewer.paneOf(subject));
        EventWork.await(() -> viewer.window = new ViewerWindow(
                subject, viewer.pane, layout, viewer.opening, viewer::closing, viewer.closed::countDown));
        EventWork.await(viewer.window::show);
        EventWork.await(viewer.window::divide);
        return viewer;
    }

    private ViewerPane paneOf(Subject subject) {
        SceneRunner shown = subject.runner();
        Function<SceneSettings, LayerStore> stores = settings ->
                LayerStore.of(settings, shown.inputs().models(), LayerStore.standard(shown.store(), this::note));
        return new ViewerPane(subject.scene().name(), recording, threads, stores);
    }

    /**
     * Shows the coverage of the scene, computed with the default options of {@code coverage} as soon as the site has
     * been loaded.
     */
    public void showCoverage() {
        SwingUtilities.invokeLater(() -> pane.showCoverage());
    }

    /** Draws lines through the site of the scene, in place of the paths of its drones. */
    public void showLines(SiteLines lines) {
        SwingUtilities.invokeLater(() -> pane.showLines(lines));
    }

    /** Stops the reading of models for a window that has been closed. */
    private void closing() {
        synchronized (this) {
            closing = true;
            interruptReading();
            notifyAll();
        }
    }

    /** The user wants to see another scene: the current run is no longer needed. */
    private void choose(Subject subject) {
        synchronized (this) {
            next = subject;
            // Under the lock: a moment later it would be the reading of the next scene that ends.
            interruptReading();
            notifyAll();
        }
    }

    private void interruptReading() {
        if (!ended && !running.hasFrames() && !running.isFinished()) {
            runner.interrupt();
        }
    }

    /**
     * Waits until the user opens another scene or closes the window. The new scene then replaces the previous one,
     * whose threads have ended; the caller must run the new one.
     *
     * @return the scene that the user has opened; empty if the window is closed or the calling thread is interrupted
     */
    public Optional<Subject> awaitNext() {
        Subject chosen;
        synchronized (this) {
            // What interrupted the reading of models has done its work.
            Thread.interrupted();
            while (!closing && next == null) {
                try {
                    wait();
                } catch (InterruptedException e) {
                    Thread.currentThread().interrupt();
                    return Optional.empty();
                }
            }
            if (closing) {
                return Optional.empty();
            }
            chosen = next;
            next = null;
            recording = new Recording();
            running = recording;
        }
        Runnable[] ending = {() -> {}};
        EventWork.await(() -> {
            // A window that has been closed meanwhile has ended its own pane.
            if (!closing) {
                pane = paneOf(chosen);
                ending[0] = window.replace(chosen, pane);
            }
        });
        ending[0].run();
        return Optional.of(chosen);
    }

    /**
     * Runs another scene for comparison: its first run is shown beside the one in the window, with a table of the
     * differences. Ends early when the user closes the window or opens another scene. To be called by the thread that
     * runs scenes.
     *
     * @param name under which users select the other scene
     * @param other runner of the other scene
     * @throws RuntimeException if the other scene cannot be run
     */
    public void runBeside(String name, SceneRunner other) {
        Recording second = new Recording();
        synchronized (this) {
            if (isLeft()) {
                return;
            }
            running = second;
        }
        ViewerPane shown = pane;
        SwingUtilities.invokeLater(() -> shown.comparing().await(name, second));
        boolean complete = false;
        try {
            complete = other.listener(second).cancelWhen(this::isLeft).run().complete();
        } finally {
            second.finish(complete);
        }
    }

    /** Whether a run is no longer needed: the user has closed the window or opened another scene. */
    public boolean isLeft() {
        return closing || next != null;
    }

    /** The listener through which the window receives the run. */
    public SceneListener listener() {
        return recording;
    }

    /** Writes a line into the log of the window. */
    public void note(String line) {
        pane.note(line);
    }

    /**
     * Records that the runs have ended.
     *
     * @param complete whether all of the scene has been simulated
     */
    public void finished(boolean complete) {
        recording.finish(complete);
    }

    /** Shows an error in the window. */
    public void failed(Throwable problem) {
        recording.finish(false);
        pane.report(problem);
    }

    /** Whether the user has closed the window: a run is then no longer needed. */
    public boolean isClosed() {
        return closing;
    }

    /** Waits until the user closes the window. */
    public void awaitClosed() {
        try {
            closed.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    ViewerPane pane() {
        return pane;
    }

    Optional<SceneOpening> opening() {
        return opening;
    }

    ViewerWindow window() {
        return window;
    }

    /** Closes the window if the user has not done so. */
    @Override
    public void close() {
        ended = Thread.currentThread() == runner;
        closing = true;
        SwingUtilities.invokeLater(window::close);
        awaitClosed();
    }
}
