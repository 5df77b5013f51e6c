package org.dronewatch.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dronewatch.viewer.EventThread.await;
import static org.dronewatch.viewer.EventThread.onEventThread;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.Toolkit;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.nio.file.Path;
import java.util.List;
import javax.accessibility.AccessibleContext;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import javax.swing.JTextField;
import org.dronewatch.geometry.Position;
import org.dronewatch.render.Orbit;
import org.dronewatch.render.Yard;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.viewer.coverage.CoverageLegend;
import org.dronewatch.viewer.coverage.CoveragePanel;
import org.jogamp.vecmath.Point2d;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The coverage in the real window, on a display. Its picture is kept in target/viewer. */
class CoverageWindowTest {

    @TempDir
    private Path directory;

    private Viewer viewer;
    private CoveragePanel panel;

    @BeforeEach
    void open() throws Exception {
        assumeTrue(
                Viewer.obstacle().isEmpty(),
                () -> "no window: " + Viewer.obstacle().orElse(""));
        Yard yard = new Yard(directory);
        // Few rays of sound: what matters here is the number of cells, not their levels.
        SceneRunner runner =
                new SceneRunner(yard).set("run.duration", "1 s").set("sensors.microphone.propagation.maxOrder", "1");
        viewer = Viewer.open(yard, runner, 2, directory.resolve("viewer.properties"));
        panel = viewer.pane().coverage();
        onEventThread(() -> {
            panel.form().set("2, 6", "50", "2");
            return null;
        });
        viewer.showCoverage();
        runner.listener(viewer.listener()).cancelWhen(viewer::isClosed).run();
        viewer.finished(true);
        await("the coverage", () -> panel.shown().isPresent() && viewer.pane().isIdle());
    }

    @AfterEach
    void close() {
        if (viewer != null) {
            viewer.close();
        }
    }

    private static void key(Component part, int code, char typed) throws Exception {
        onEventThread(() -> {
            long now = System.currentTimeMillis();
            part.dispatchEvent(new KeyEvent(part, KeyEvent.KEY_PRESSED, now, 0, code, typed));
            part.dispatchEvent(new KeyEvent(part, KeyEvent.KEY_TYPED, now, 0, KeyEvent.VK_UNDEFINED, typed));
            part.dispatchEvent(new KeyEvent(part, KeyEvent.KEY_RELEASED, now, 0, code, typed));
            return null;
        });
    }

    private void focus(Component part) throws Exception {
        onEventThread(part::requestFocusInWindow);
        await("the focus", part::isFocusOwner);
    }

    @Test
    void itIsUsedByKeysAloneAndEverythingHasAName() throws Exception {
        List<JTextField> fields = onEventThread(() -> Parts.in(panel)
                .filter(JTextField.class::isInstance)
                .map(JTextField.class::cast)
                .toList());
        assertThat(fields).hasSize(3);
        // The keys 1 to 3 change the view, but not while one is typing.
        Orbit before = onEventThread(() -> viewer.pane().world().orbit());
        JTextField side = fields.get(1);
        focus(side);
        onEventThread(() -> {
            side.setText("");
            return null;
        });
        key(side, KeyEvent.VK_3, '3');
        key(side, KeyEvent.VK_2, '2');
        String typed = onEventThread(() -> side.getText());
        assertThat(typed).isEqualTo("32");
        assertThat(onEventThread(() -> viewer.pane().world().orbit())).isEqualTo(before);
        key(side, KeyEvent.VK_ENTER, '\n');
        await(
                "Enter computes",
                () -> panel.shown().isPresent()
                        && panel.shown().get().coverage().grid().side() == 32.0
                        && viewer.pane().isIdle());

        // Space switches the sensor, and does not start the run.
        JCheckBox microphone = onEventThread(() -> panel.switches().boxes().get(1));
        boolean isPlaying = onEventThread(() -> viewer.pane().playback().isPlaying());
        focus(microphone);
        key(microphone, KeyEvent.VK_SPACE, ' ');
        await("the switch", () -> panel.shown().orElseThrow().off().contains("microphone"));
        assertThat(onEventThread(() -> viewer.pane().playback().isPlaying())).isEqualTo(isPlaying);
        await("the picture", () -> viewer.pane().isIdle());
        KeptPicture.of(viewer.window().frame(), "coverage");

        assertThat(skinShown()).isTrue();
        focus(viewer.pane().world());
        key(viewer.pane().world(), KeyEvent.VK_K, 'k');
        assertThat(skinShown()).isFalse();
        key(viewer.pane().world(), KeyEvent.VK_K, 'k');
        assertThat(skinShown()).isTrue();

        List<String> unnamed = onEventThread(() -> Parts.in(panel)
                .filter(part -> part.isFocusable() && part.isShowing() && part.isEnabled())
                .filter(part -> part instanceof JTextField
                        || part instanceof javax.swing.AbstractButton
                        || part instanceof javax.swing.JSlider
                        || part instanceof javax.swing.JComboBox<?>)
                // The arrow of a box belongs to the box.
                .filter(part -> !(part.getParent() instanceof javax.swing.JComboBox<?>))
                .filter(part -> {
                    AccessibleContext context = part.getAccessibleContext();
                    return context.getAccessibleName() == null
                            || context.getAccessibleName().isBlank();
                })
                .map(part -> part.getClass().getName())
                .toList());
        assertThat(unnamed).isEmpty();
    }

    @Test
    void theLegendCanBeReadAsSoonAsItIsThere() throws Exception {
        List<JLabel> meanings = onEventThread(() -> Parts.in(panel)
                .filter(CoverageLegend.class::isInstance)
                .flatMap(legend -> Parts.in((Container) legend))
                .filter(JLabel.class::isInstance)
                .map(JLabel.class::cast)
                .toList());
        assertThat(meanings).isNotEmpty().allSatisfy(meaning -> assertThat(meaning.getVisibleRect().width)
                .as(meaning.getText())
                .isGreaterThanOrEqualTo(meaning.getPreferredSize().width));
    }

    /** Heights, switches and the pointer: nothing keeps the event thread busy for 50 ms of processor time. */
    @Test
    void theEventThreadIsNeverBusyForLong() throws Exception {
        BusyTimes times = new BusyTimes();
        Toolkit.getDefaultToolkit().getSystemEventQueue().push(times);
        try {
            onEventThread(() -> {
                panel.compute();
                return null;
            });
            await("the coverage", () -> panel.isIdle() && viewer.pane().isIdle());
            for (JCheckBox box : onEventThread(() -> panel.switches().boxes())) {
                onEventThread(() -> {
                    box.doClick();
                    return null;
                });
                await("the switch", () -> viewer.pane().isIdle());
            }
            WorldPanel world = viewer.pane().world();
            for (int x = 0; x < world.getWidth(); x += 20) {
                MouseEvent moved = new MouseEvent(
                        world,
                        MouseEvent.MOUSE_MOVED,
                        System.currentTimeMillis(),
                        0,
                        x,
                        world.getHeight() / 2,
                        0,
                        false);
                onEventThread(() -> {
                    world.dispatchEvent(moved);
                    return null;
                });
            }
            await("the pointer", () -> viewer.pane().isIdle());
        } finally {
            times.end();
        }
        assertThat(times.count()).isGreaterThan(100);
        assertThat(times.longest()).as("s").isLessThan(0.05);
    }

    private boolean skinShown() throws Exception {
        return onEventThread(() -> viewer.pane().world().style().skin().isPresent());
    }

    @Test
    void thePointerNamesWhatHidesTheDrone() throws Exception {
        WorldPanel world = viewer.pane().world();
        // Behind the wall, seen from above.
        onEventThread(() -> {
            viewer.pane().views().get(1).actionPerformed(null);
            return null;
        });
        await("the plan", () -> viewer.pane().isIdle());
        Point2d at = onEventThread(() -> world.orbit()
                .camera(world.getWidth(), world.getHeight())
                .pixelOf(new Position(0.0, 6.0, 0.0).toPoint3d())
                .orElseThrow());
        onEventThread(() -> {
            world.dispatchEvent(new MouseEvent(
                    world, MouseEvent.MOUSE_MOVED, System.currentTimeMillis(), 0, (int) at.x, (int) at.y, 0, false, 0));
            return null;
        });
        // What the field keeps is shown at once; the building is found by a look afterwards.
        await("the building", () -> panel.switches().reasons().contains("hidden by a building (yard.obj)"));
        String cell = onEventThread(() -> panel.cell());
        assertThat(cell).startsWith("At 2 m above the ground: ").contains("determines the cause");
    }
}
