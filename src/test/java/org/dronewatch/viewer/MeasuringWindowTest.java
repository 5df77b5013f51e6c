package org.dronewatch.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dronewatch.viewer.EventThread.await;
import static org.dronewatch.viewer.EventThread.onEventThread;

import java.awt.Toolkit;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.nio.file.Path;
import org.dronewatch.geometry.Position;
import org.dronewatch.render.Yard;
import org.dronewatch.viewer.tape.TapeReading;
import org.jogamp.vecmath.Point2d;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The tape in the real window: by mouse and by keys. */
class MeasuringWindowTest {
    private static final double LONGEST = 0.05;

    @TempDir
    private Path directory;

    private Viewer viewer;
    private WorldPanel world;
    private Measuring measuring;

    @BeforeEach
    void open() throws Exception {
        viewer = YardWindow.open(directory);
        world = viewer.pane().world();
        measuring = viewer.pane().measuring();
        onEventThread(() -> {
            viewer.pane().playback().pause();
            viewer.pane().playback().jump(0.0);
            return null;
        });
        await("the picture", () -> viewer.pane().isIdle());
    }

    @AfterEach
    void close() {
        if (viewer != null) {
            viewer.close();
        }
    }

    private void key(int code, int modifiers) throws Exception {
        onEventThread(() -> {
            for (int id : new int[] {KeyEvent.KEY_PRESSED, KeyEvent.KEY_RELEASED}) {
                world.dispatchEvent(
                        new KeyEvent(world, id, System.currentTimeMillis(), modifiers, code, KeyEvent.CHAR_UNDEFINED));
            }
            return null;
        });
    }

    private void mouse(int id, Position place) throws Exception {
        onEventThread(() -> {
            Point2d at = world.pixelOf(place).orElseThrow();
            world.dispatchEvent(new MouseEvent(
                    world,
                    id,
                    System.currentTimeMillis(),
                    0,
                    (int) Math.round(at.x),
                    (int) Math.round(at.y),
                    1,
                    false,
                    id == MouseEvent.MOUSE_MOVED ? MouseEvent.NOBUTTON : MouseEvent.BUTTON1));
            return null;
        });
    }

    private TapeReading read() throws Exception {
        await("the reading", () -> measuring.reading().isPresent() && measuring.isIdle());
        return onEventThread(() -> measuring.reading().orElseThrow());
    }

    private void plan() throws Exception {
        onEventThread(() -> {
            viewer.pane().views().get(1).actionPerformed(null);
            return null;
        });
        await("the plan", () -> viewer.pane().isIdle());
    }

    private void keep(String name) throws Exception {
        await("the picture", () -> viewer.pane().isIdle());
        KeptPicture.of(viewer.window().frame(), name);
    }

    /** Two points of the lawn, whose coordinates are known to a pixel. */
    @Test
    void twoClicksMeasureBetweenPointsOfTheSiteWithoutHoldingUpTheEventThread() throws Exception {
        Position west = new Position(-9, -8, 0);
        Position east = new Position(9, -8, 0);
        plan();
        String selected = onEventThread(() -> viewer.pane().selected().orElse("nothing"));
        BusyTimes times = new BusyTimes();
        Toolkit.getDefaultToolkit().getSystemEventQueue().push(times);
        try {
            key(KeyEvent.VK_M, 0);
            mouse(MouseEvent.MOUSE_CLICKED, west);
            mouse(MouseEvent.MOUSE_MOVED, new Position(0, -8, 0));
            mouse(MouseEvent.MOUSE_CLICKED, east);
            TapeReading reading = read();

            double pixel = 3.0 * onEventThread(() -> world.orbit().metresPerPixel(world.getHeight()));
            assertThat(reading.tape().distance()).isCloseTo(18.0, within(pixel));
            assertThat(reading.tape().bearingDeg()).isCloseTo(90.0, within(2.0));
            assertThat(reading.tape().height()).isCloseTo(0.0, within(0.02));
            assertThat(reading.blocked()).isEmpty();
        } finally {
            times.end();
        }
        assertThat(times.longest()).as("processor time of the longest event, s").isLessThan(LONGEST);
        assertThat(onEventThread(() -> viewer.pane().selected().orElse("nothing")))
                .as("a click that measures selects nothing")
                .isEqualTo(selected);
        assertThat(onEventThread(() -> world.getAccessibleContext().getAccessibleDescription()))
                .startsWith("From a point to a point: 1");
    }

    /** The camera is behind the wall for the drone, or above it. */
    @Test
    void theSelectionIsMeasuredByKeysAndEscapeEndsIt() throws Exception {
        key(KeyEvent.VK_M, InputEvent.SHIFT_DOWN_MASK);
        assertThat(onEventThread(() -> measuring.reading())).isEmpty();
        onEventThread(() -> {
            viewer.pane().select("camera");
            return null;
        });
        key(KeyEvent.VK_M, InputEvent.SHIFT_DOWN_MASK);
        onEventThread(() -> {
            viewer.pane().select("quadrotor");
            return null;
        });
        key(KeyEvent.VK_M, InputEvent.SHIFT_DOWN_MASK);
        TapeReading reading = read();

        Position drone = viewer.pane()
                .viewed()
                .orElseThrow()
                .stage()
                .dronesAt(0.0)
                .get(0)
                .origin();
        assertThat(reading.words()).startsWith("From 'camera' to 'quadrotor': ");
        assertThat(reading.tape().distance())
                .isEqualTo(drone.minus(Yard.SENSORS).length());
        assertThat(onEventThread(() -> viewer.pane().log().text())).contains(reading.words());
        keep("tape");

        key(KeyEvent.VK_ESCAPE, 0);
        assertThat(onEventThread(() -> measuring.isOn())).isFalse();
        assertThat(onEventThread(() -> measuring.reading())).isEmpty();
    }

    @Test
    void aWallBetweenTwoPointsIsNamedAndMarked() throws Exception {
        onEventThread(() -> {
            viewer.pane().select("camera");
            return null;
        });
        key(KeyEvent.VK_M, InputEvent.SHIFT_DOWN_MASK);
        plan();
        mouse(MouseEvent.MOUSE_CLICKED, new Position(2, 18, 0));

        assertThat(read().words()).contains("blocked after 15.").contains(" by yard.obj at east ");
        keep("tape-blocked");
    }
}
