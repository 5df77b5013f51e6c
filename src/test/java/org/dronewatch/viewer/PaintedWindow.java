package org.dronewatch.viewer;

import com.formdev.flatlaf.FlatLightLaf;
import java.awt.image.BufferedImage;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import javax.swing.JSplitPane;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;

/** What the window shows of a run at one time, below its menus, painted without a display. */
public final class PaintedWindow {
    private static final long PATIENCE_NANOS = 300_000_000_000L;

    private PaintedWindow() {}

    /** Runs a scene and paints the window at a time of its run, s; in the light look, whatever was set before. */
    public static BufferedImage at(double time, Scene scene, int width, int height) throws Exception {
        Object before = UIManager.getLookAndFeel();
        onEventThread(FlatLightLaf::setup);
        try {
            SceneRunner runner = new SceneRunner(scene);
            Recording recording = new Recording();
            runner.listener(recording).run();
            recording.finish(true);
            ViewerPane pane = onEventThread(() -> new ViewerPane(scene.name(), recording, 2));
            try {
                return painted(pane, time, width, height);
            } finally {
                pane.close();
            }
        } finally {
            onEventThread(() -> {
                UIManager.setLookAndFeel((javax.swing.LookAndFeel) before);
                return null;
            });
        }
    }

    private static BufferedImage painted(ViewerPane pane, double time, int width, int height) throws Exception {
        onEventThread(() -> {
            // As if it were in a window: tables get their headers, and all is laid out anew when it changes.
            pane.addNotify();
            pane.setSize(width, height);
            pane.validate();
            // As the window divides itself when it is opened for the first time.
            JSplitPane across = pane.dividers().get(0);
            across.setDividerLocation((int) (0.6 * across.getWidth()));
            pane.validate();
            JSplitPane down = pane.dividers().get(1);
            down.setDividerLocation((int) (0.58 * down.getHeight()));
            pane.validate();
            return null;
        });
        settle(pane);
        onEventThread(() -> {
            pane.playback().pause();
            pane.playback().jump(time);
            return null;
        });
        settle(pane);
        // Once more: tables and legends take in what the threads have sent.
        settle(pane);
        return onEventThread(() -> {
            pane.validate();
            return Exports.picture(pane);
        });
    }

    private static <T> T onEventThread(Callable<T> work) throws Exception {
        FutureTask<T> task = new FutureTask<>(work);
        SwingUtilities.invokeAndWait(task);
        try {
            return task.get();
        } catch (ExecutionException e) {
            throw e.getCause() instanceof Exception cause ? cause : e;
        }
    }

    /** Lets the pane work until all is drawn. */
    private static void settle(ViewerPane pane) throws Exception {
        long end = System.nanoTime() + PATIENCE_NANOS;
        boolean done = false;
        while (!done) {
            if (System.nanoTime() > end) {
                throw new IllegalStateException("the window is still drawing");
            }
            Thread.sleep(30);
            done = onEventThread(() -> {
                pane.tick(0.2);
                pane.validate();
                return pane.viewed().isPresent() && pane.isIdle();
            });
        }
        onEventThread(() -> null);
    }
}
