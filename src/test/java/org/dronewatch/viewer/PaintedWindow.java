package org.dronewatch.viewer;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import javax.swing.AbstractButton;
import javax.swing.JSplitPane;
import javax.swing.JTable;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.viewer.beside.OtherRun;
import org.dronewatch.viewer.gallery.SceneGallery;
import org.dronewatch.viewer.gallery.ScenePictures;
import org.dronewatch.viewer.run.Recording;

/** What the window shows of a run at one time, below its menus, painted without a display. */
public final class PaintedWindow {
    private static final long PATIENCE_NANOS = 300_000_000_000L;

    private PaintedWindow() {}

    /** Runs a scene and paints the window at a time of its run, s; in the light look, whatever was set before. */
    public static BufferedImage at(double time, Scene scene, int width, int height) throws Exception {
        return at(time, new SceneRunner(scene), scene.name(), width, height, List.of());
    }

    /**
     * Computes the coverage of a scene, which runs for a moment only, and paints the window with it.
     *
     * @param form the heights, the side and the cell, as the user writes them
     * @param height number of the height that is shown
     * @param off the sensor that is switched off; empty for none
     */
    public static BufferedImage coverage(
            Scene scene, List<String> form, int height, Optional<String> off, int width, int paintedHeight)
            throws Exception {
        Step compute = pane -> {
            pane.coverage().form().set(form.get(0), form.get(1), form.get(2));
            pane.showCoverage();
        };
        Step choose = pane -> {
            pane.coverage().heights().choose(height);
            pane.coverage().switches().boxes().stream()
                    .filter(box -> off.filter(box.getText()::equals).isPresent())
                    .forEach(AbstractButton::doClick);
        };
        // A cell north-east of the middle.
        Step point = pane -> pane.world().describe((int) (0.56 * pane.world().getWidth()), (int)
                (0.44 * pane.world().getHeight()));
        SceneRunner runner = new SceneRunner(scene).set("run.duration", "0.2 s");
        return at(0.0, runner, scene.name(), width, paintedHeight, List.of(compute, choose, point));
    }

    /**
     * Computes the coverage of a scene, which runs for a moment only, moves a sensor, and paints the window with the
     * coverage that was drawn anew.
     *
     * @param form the heights, the side and the cell, as the user writes them
     * @param to where the sensor is moved: east, north, above what is below it, m
     */
    public static BufferedImage placing(
            SceneRunner runner, String title, List<String> form, String sensor, List<Double> to, int width, int height)
            throws Exception {
        Step compute = pane -> {
            pane.coverage().form().set(form.get(0), form.get(1), form.get(2));
            pane.showCoverage();
        };
        Step move = pane -> {
            pane.tabs().setSelectedComponent(pane.placing());
            pane.select(sensor);
            pane.placing().mover().place(to.get(0), to.get(1), to.get(2));
        };
        return at(0.0, runner.set("run.duration", "0.2 s"), title, width, height, List.of(compute, move));
    }

    /**
     * Measures from a sensor to a point of the site, in a scene that runs for a moment only, and paints the window with
     * the tape.
     *
     * @param to the point, as fractions of the width and height of the view
     */
    public static BufferedImage measuring(
            SceneRunner runner, String title, String sensor, List<Double> to, int width, int height) throws Exception {
        Step from = pane -> pane.measuring().put(Optional.of(sensor));
        Step click =
                pane -> pane.measuring().click((int) (to.get(0) * pane.world().getWidth()), (int)
                        (to.get(1) * pane.world().getHeight()));
        return at(0.0, runner, title, width, height, List.of(from, click));
    }

    /**
     * Edits settings of a sensor, in a scene that runs for a moment only, and paints the window with them.
     *
     * @param typed values by the names of settings; the last is shown in the middle
     */
    public static BufferedImage settings(
            SceneRunner runner, String title, String sensor, Map<String, String> typed, int width, int height)
            throws Exception {
        Step edit = pane -> {
            pane.tabs().setSelectedComponent(pane.tabs().settings());
            pane.tabs().settings().onRun(() -> {});
            JSplitPane down = pane.dividers().get(1);
            down.setDividerLocation((int) (0.3 * down.getHeight()));
            pane.select(sensor);
            pane.validate();
            JTable table = pane.tabs().settings().table();
            for (int row = 0; row < table.getRowCount(); row++) {
                String value = typed.get((String) table.getValueAt(row, 0));
                if (value != null) {
                    table.setValueAt(value, row, 1);
                    table.scrollRectToVisible(table.getCellRect(row + 2, 1, true));
                }
            }
        };
        return at(0.0, runner, title, width, height, List.of(edit));
    }

    /**
     * Compares a run with another, which is shown beside it, and paints the window at a time of both, s.
     *
     * @param other the run from which the first was changed
     */
    public static BufferedImage comparing(
            double time, SceneRunner runner, SceneRunner other, String title, int width, int height) throws Exception {
        Recording before = new Recording();
        other.listener(before).run();
        before.finish(true);
        Step compare = pane -> {
            pane.tabs().setSelectedComponent(pane.tabs().comparison());
            JSplitPane down = pane.dividers().get(1);
            down.setDividerLocation((int) (0.45 * down.getHeight()));
            pane.comparing()
                    .compareWith(
                            List.of(new OtherRun(Comparing.BEFORE, before.runs().get(0))));
            pane.tabs().comparison().setBeside(true);
        };
        return at(time, runner, title, width, height, List.of(compare));
    }

    /** The packaged scenes to choose from; in the light look, whatever was set before. */
    public static BufferedImage gallery() throws Exception {
        Object before = UIManager.getLookAndFeel();
        onEventThread(() -> {
            ViewerWindow.setLook(false);
            return null;
        });
        try {
            ScenePictures pictures = ScenePictures.read();
            return onEventThread(() -> {
                SceneGallery gallery = new SceneGallery(pictures, scene -> {}, () -> {});
                gallery.addNotify();
                gallery.setSize(gallery.getPreferredSize());
                gallery.validate();
                return Exports.picture(gallery);
            });
        } finally {
            onEventThread(() -> {
                UIManager.setLookAndFeel((javax.swing.LookAndFeel) before);
                return null;
            });
        }
    }

    /** What a user does, on the event thread. */
    private interface Step {
        void on(ViewerPane pane);
    }

    private static BufferedImage at(
            double time, SceneRunner runner, String title, int width, int height, List<Step> steps) throws Exception {
        Object before = UIManager.getLookAndFeel();
        onEventThread(() -> {
            ViewerWindow.setLook(false);
            return null;
        });
        try {
            Recording recording = new Recording();
            runner.listener(recording).run();
            recording.finish(true);
            ViewerPane pane = onEventThread(() -> new ViewerPane(title, recording, 2, settings -> LayerStore.NONE));
            try {
                return painted(pane, time, width, height, steps);
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

    private static BufferedImage painted(ViewerPane pane, double time, int width, int height, List<Step> steps)
            throws Exception {
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
        for (Step step : steps) {
            onEventThread(() -> {
                step.on(pane);
                return null;
            });
            settle(pane);
        }
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
