package org.dronewatch.viewer;

import java.awt.AWTError;
import java.awt.GraphicsEnvironment;
import java.awt.Toolkit;
import java.lang.reflect.InvocationTargetException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicReference;
import javax.swing.SwingUtilities;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneListener;
import org.dronewatch.scene.SceneRunner;

/**
 * A window in which a scene is looked at while it runs and afterwards. It listens to a run as a report does and changes
 * nothing in it: results are the same with it and without.
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
    private final Recording recording = new Recording();
    private final CountDownLatch closed = new CountDownLatch(1);
    private final Thread runner = Thread.currentThread();
    private ViewerPane pane;
    private ViewerWindow window;
    private volatile boolean closing;

    private Viewer() {}

    /** Why no window can be opened here; empty when one can. */
    public static Optional<String> obstacle() {
        if (GraphicsEnvironment.isHeadless()) {
            return Optional.of("there is no display");
        }
        try {
            Toolkit.getDefaultToolkit().getScreenSize();
            return Optional.empty();
        } catch (AWTError | LinkageError e) {
            return Optional.of("there is a display, but no window can be opened on it: "
                    + String.valueOf(e.getMessage()).replaceFirst("\\.$", ""));
        }
    }

    /**
     * Opens the window, as the user left it the last time. The thread that calls is expected to run the scene: when the
     * window is closed while it is still reading models, it is interrupted.
     *
     * @param runner the one that will run the scene; it also gives what the pictures show
     * @param threads how many trace pictures
     * @throws IllegalStateException when there is no display
     */
    public static Viewer open(Scene scene, SceneRunner runner, int threads) {
        return open(scene, runner, threads, ViewerLayout.ofUser());
    }

    static Viewer open(Scene scene, SceneRunner runner, int threads, Path layoutFile) {
        Optional<String> obstacle = obstacle();
        if (obstacle.isPresent()) {
            throw new IllegalStateException(obstacle.get());
        }
        Viewer viewer = new Viewer();
        ViewerLayout layout = new ViewerLayout(layoutFile);
        // One thing after the other, so that the event thread is never busy for long.
        onEventThread(() -> ViewerWindow.setLook(layout.isDark()));
        onEventThread(() -> viewer.pane = new ViewerPane(scene.name(), viewer.recording, runner::stage, threads));
        onEventThread(() -> viewer.window =
                new ViewerWindow(scene.name(), viewer.pane, layout, viewer::closing, viewer.closed::countDown));
        onEventThread(viewer.window::show);
        onEventThread(viewer.window::divide);
        return viewer;
    }

    /** Whoever reads models for a window that is gone need not go on. */
    private void closing() {
        closing = true;
        if (!recording.hasFrames()) {
            runner.interrupt();
        }
    }

    private static void onEventThread(Runnable work) {
        AtomicReference<RuntimeException> failure = new AtomicReference<>();
        try {
            SwingUtilities.invokeAndWait(() -> {
                try {
                    work.run();
                } catch (RuntimeException e) {
                    failure.set(e);
                }
            });
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (InvocationTargetException e) {
            throw new IllegalStateException(e.getCause());
        }
        if (failure.get() != null) {
            throw failure.get();
        }
    }

    /** What the run has to tell. */
    public SceneListener listener() {
        return recording;
    }

    /** Writes a line into the log of the window. */
    public void note(String line) {
        pane.note(line);
    }

    /**
     * No more comes.
     *
     * @param complete whether all of the scene has been simulated
     */
    public void finished(boolean complete) {
        recording.finish(complete);
    }

    /** Shows in the window what went wrong. */
    public void failed(Throwable problem) {
        recording.finish(false);
        pane.tell(problem);
    }

    /** Whether the user has closed the window: a run is then of no use any more. */
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

    ViewerWindow window() {
        return window;
    }

    /** Closes the window if the user has not. */
    @Override
    public void close() {
        closing = true;
        SwingUtilities.invokeLater(window::close);
        awaitClosed();
    }
}
