package org.dronewatch.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dronewatch.viewer.EventThread.await;
import static org.dronewatch.viewer.EventThread.onEventThread;

import java.awt.Component;
import java.awt.Toolkit;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JTextField;
import org.dronewatch.geometry.Position;
import org.dronewatch.render.Orbit;
import org.dronewatch.render.Yard;
import org.dronewatch.report.coverage.table.MoveWords;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.viewer.coverage.CoveragePanel;
import org.dronewatch.viewer.coverage.CoverageSkinning;
import org.jogamp.vecmath.Point2d;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A sensor in the real window: dragged by the mouse, moved by keys and fields, put back, and saved. */
class PlacingWindowTest {
    @TempDir
    private Path directory;

    private Viewer viewer;
    private WorldPanel world;
    private PlacingPanel placing;
    private CoveragePanel coverage;

    @BeforeEach
    void open() throws Exception {
        viewer = YardWindow.open(directory);
        world = viewer.pane().world();
        placing = viewer.pane().placing();
        coverage = viewer.pane().coverage();
        onEventThread(() -> {
            viewer.pane().views().get(1).actionPerformed(null);
            return null;
        });
        await("the plan", () -> viewer.pane().isIdle());
    }

    @AfterEach
    void close() {
        if (viewer != null) {
            viewer.close();
        }
    }

    private Point2d pixel(Position place) throws Exception {
        return onEventThread(() -> world.pixelOf(place).orElseThrow());
    }

    private void mouse(int id, Point2d at) throws Exception {
        onEventThread(() -> {
            boolean isHeld = id != MouseEvent.MOUSE_RELEASED && id != MouseEvent.MOUSE_CLICKED;
            world.dispatchEvent(new MouseEvent(
                    world,
                    id,
                    System.currentTimeMillis(),
                    isHeld ? InputEvent.BUTTON1_DOWN_MASK : 0,
                    (int) Math.round(at.x),
                    (int) Math.round(at.y),
                    1,
                    false,
                    MouseEvent.BUTTON1));
            return null;
        });
    }

    private void click(Position place) throws Exception {
        Point2d at = pixel(place);
        mouse(MouseEvent.MOUSE_PRESSED, at);
        mouse(MouseEvent.MOUSE_RELEASED, at);
        mouse(MouseEvent.MOUSE_CLICKED, at);
        await("the selection", () -> viewer.pane().isIdle());
    }

    private void drag(Position from, Position to) throws Exception {
        Point2d first = pixel(from);
        Point2d last = pixel(to);
        mouse(MouseEvent.MOUSE_PRESSED, first);
        for (int part = 1; part <= 5; part++) {
            Point2d at = new Point2d();
            at.interpolate(first, last, part / 5.0);
            mouse(MouseEvent.MOUSE_DRAGGED, at);
        }
        mouse(MouseEvent.MOUSE_RELEASED, last);
    }

    private void key(int code, int modifiers) throws Exception {
        onEventThread(() -> {
            world.requestFocusInWindow();
            long now = System.currentTimeMillis();
            for (int id : new int[] {KeyEvent.KEY_PRESSED, KeyEvent.KEY_RELEASED}) {
                world.dispatchEvent(new KeyEvent(world, id, now, modifiers, code, KeyEvent.CHAR_UNDEFINED));
            }
            return null;
        });
    }

    private Position camera() throws Exception {
        return onEventThread(() -> placing.settings().sensors().get("camera").position());
    }

    private void compute() throws Exception {
        onEventThread(() -> {
            coverage.form().set("2", "50", "2");
            coverage.compute();
            return null;
        });
        await("the coverage", () -> coverage.isIdle() && coverage.shown().isPresent());
        // It hears the drone everywhere.
        onEventThread(() -> {
            coverage.switches().boxes().get(1).doClick();
            return null;
        });
        await(
                "the switch",
                () -> coverage.shown().orElseThrow().off().contains("microphone")
                        && viewer.pane().isIdle());
    }

    private int covered() throws Exception {
        return onEventThread(() -> coverage.shown().orElseThrow().remaining().remaining());
    }

    private void complete() throws Exception {
        await(
                "the whole draft",
                () -> coverage.shown()
                                .flatMap(CoverageSkinning.Shown::fineness)
                                .filter(MoveWords.Fineness.COMPLETE::equals)
                                .isPresent()
                        && viewer.pane().isIdle());
    }

    /** What is then shown is what is computed for the scene with the sensor at its new place. */
    @Test
    void aDraggedSensorTakesItsCoverageAlong() throws Exception {
        compute();
        int before = covered();
        click(Yard.SENSORS);
        Orbit view = onEventThread(() -> world.orbit());
        BusyTimes times = new BusyTimes();
        Toolkit.getDefaultToolkit().getSystemEventQueue().push(times);
        Position aside = new Position(14, -15, 2);
        try {
            drag(Yard.SENSORS, aside);
            complete();
        } finally {
            times.end();
        }
        assertThat(times.longest()).as("s").isLessThan(0.05);
        assertThat(onEventThread(() -> world.orbit())).isEqualTo(view);
        double pixel = view.metresPerPixel(world.getHeight());
        assertThat(camera().x()).isEqualTo(14.0, within(3.0 * pixel));
        assertThat(camera().z()).isEqualTo(2.0, within(0.02));
        assertThat(placing.said()).startsWith("'camera' is at east 1").endsWith("2.0 m above the surface below it.");
        assertThat(placing.covered()).startsWith("At 2 m, ").contains("; before 'camera' was moved, it was ");
        int drawn = covered();
        assertThat(drawn).isNotEqualTo(before);

        compute();
        assertThat(coverage.shown().orElseThrow().fineness()).isEmpty();
        assertThat(covered()).isEqualTo(drawn);

        key(KeyEvent.VK_Z, Toolkit.getDefaultToolkit().getMenuShortcutKeyMaskEx());
        assertThat(camera()).isEqualTo(Yard.SENSORS);
        complete();
        assertThat(covered()).isEqualTo(before);
    }

    @Test
    void withoutASelectionTheViewTurns() throws Exception {
        Orbit view = onEventThread(() -> world.orbit());
        drag(Yard.SENSORS, new Position(14, -15, 2));
        assertThat(onEventThread(() -> world.orbit())).isNotEqualTo(view);
        assertThat(camera()).isEqualTo(Yard.SENSORS);
    }

    @Test
    void keysAndFieldsMoveAndTurnItAndItIsSaved() throws Exception {
        key(KeyEvent.VK_RIGHT, InputEvent.ALT_DOWN_MASK);
        assertThat(placing.said()).isEqualTo("Select a sensor first: click on its symbol.");
        click(Yard.SENSORS);
        key(KeyEvent.VK_RIGHT, InputEvent.ALT_DOWN_MASK);
        key(KeyEvent.VK_DOWN, InputEvent.ALT_DOWN_MASK);
        key(KeyEvent.VK_UP, InputEvent.ALT_DOWN_MASK | InputEvent.SHIFT_DOWN_MASK);
        key(KeyEvent.VK_PAGE_UP, InputEvent.ALT_DOWN_MASK);
        assertThat(camera()).isEqualTo(new Position(1, -6, 3));
        assertThat(placing.covered()).startsWith("Compute the coverage");
        assertThat(onEventThread(() -> viewer.pane().world().image() != null)).isTrue();

        onEventThread(() -> {
            viewer.pane().tabs().setSelectedComponent(placing);
            return null;
        });
        List<JTextField> fields = onEventThread(() -> Parts.in(placing)
                .filter(JTextField.class::isInstance)
                .map(JTextField.class::cast)
                .toList());
        assertThat(onEventThread(() -> fields.stream().map(JTextField::getText).toList()))
                .startsWith("1", "-6", "3");
        enter(fields.get(0), "0.012 km");
        enter(fields.get(2), "2.5");
        enter(fields.get(3), "45");
        enter(fields.get(4), "-0.1 rad");
        assertThat(camera()).isEqualTo(new Position(12, -6, 2.5));
        assertThat(placing.said()).isEqualTo("'camera' has an azimuth of 45.0 degrees and a tilt of -5.7 degrees.");
        enter(fields.get(1), "far");
        assertThat(placing.said()).startsWith("north far: 'far' is not a number");
        enter(fields.get(1), "5000");
        assertThat(placing.said()).isEqualTo("'camera' stays where it is: there is no ground.");
        assertThat(Parts.in(placing).filter(JTextField.class::isInstance).map(Component::getAccessibleContext))
                .allSatisfy(context -> assertThat(context.getAccessibleName()).isNotBlank());

        Path file = directory.resolve("moved.yaml");
        onEventThread(() -> {
            new SceneSaving(viewer.pane(), "yard", new SceneRunner(new Yard(directory))::text).write(file.toString());
            return null;
        });
        assertThat(Files.readString(file)).contains("[12, -6, 2.5]");
        SceneRunner again = new SceneRunner(new SceneFile(file));
        assertThat(again.settings().sensors())
                .isEqualTo(onEventThread(() -> placing.settings().sensors()));
        assertThat(again.run().runs()).hasSize(1);
    }

    private static void enter(JTextField field, String text) throws Exception {
        onEventThread(() -> {
            field.setText(text);
            field.postActionEvent();
            return null;
        });
    }
}
