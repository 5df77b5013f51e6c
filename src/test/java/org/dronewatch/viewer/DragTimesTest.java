package org.dronewatch.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dronewatch.viewer.EventThread.await;
import static org.dronewatch.viewer.EventThread.onEventThread;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.Toolkit;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import org.dronewatch.LongForm;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.coverage.table.MoveWords;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.viewer.coverage.CoveragePanel;
import org.dronewatch.viewer.coverage.CoverageSkinning;
import org.jogamp.vecmath.Point2d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Drags sensors through the real window and prints how long the first and the fine picture of what is covered took,
 * from the event of the mouse until the site is painted: in the long form, on a display. The times are those of this
 * machine, so that only what does not depend on it is asserted.
 */
class DragTimesTest {
    private static final double MILLI = 1e-6;
    private static final int WARM = 4;
    private static final int MOVES = 11;

    @TempDir
    private Path directory;

    private Viewer viewer;
    private WorldPanel world;
    private CoveragePanel coverage;
    private Point2d pointer;

    /** Opens a scene and computes its coverage: without its microphone unless that is dragged, since it takes long. */
    private void open(String scene, boolean hears) throws Exception {
        SceneFile file = new SceneFile(Path.of("scenes", scene));
        SceneRunner runner = new SceneRunner(file)
                .set("run.duration", "0.5 s")
                .set("sensors.microphone.enabled", String.valueOf(hears));
        viewer = Viewer.open(file, runner, 2, directory.resolve("viewer.properties"));
        world = viewer.pane().world();
        coverage = viewer.pane().coverage();
        runner.listener(viewer.listener()).cancelWhen(viewer::isClosed).run();
        viewer.finished(true);
        await("the site", () -> viewer.pane().viewed().isPresent() && world.image() != null);
        onEventThread(() -> {
            viewer.pane().playback().pause();
            viewer.pane().views().get(1).actionPerformed(null);
            coverage.form().set("30", "500", "5");
            coverage.compute();
            return null;
        });
        await(
                "the coverage",
                () -> coverage.shown().isPresent() && viewer.pane().isIdle());
    }

    private void mouse(int id) throws Exception {
        onEventThread(() -> {
            world.dispatchEvent(new MouseEvent(
                    world,
                    id,
                    System.currentTimeMillis(),
                    id == MouseEvent.MOUSE_RELEASED ? 0 : InputEvent.BUTTON1_DOWN_MASK,
                    (int) Math.round(pointer.x),
                    (int) Math.round(pointer.y),
                    1,
                    false,
                    MouseEvent.BUTTON1));
            return null;
        });
    }

    /** The time until a picture of the layout as it is now, of a fineness, has been painted, ms. */
    private double until(long start, Predicate<MoveWords.Fineness> fineness) throws Exception {
        SceneSettings now = onEventThread(() -> viewer.pane().placing().settings());
        while (!onEventThread(() -> coverage.shown()
                        .filter(shown -> shown.coverage().request().settings() == now)
                        .flatMap(CoverageSkinning.Shown::fineness)
                        .filter(fineness)
                        .isPresent()
                && world.isIdle())) {
            Thread.sleep(1);
        }
        // The picture is handed to the event thread.
        onEventThread(() -> null);
        return MILLI * (System.nanoTime() - start);
    }

    private void measure(String scene, String sensor) throws Exception {
        onEventThread(() -> {
            viewer.pane().select(sensor);
            return null;
        });
        Position at = onEventThread(
                () -> viewer.pane().placing().settings().sensors().get(sensor).position());
        onEventThread(() -> {
            world.move(world.orbit().at(at).showing(150.0));
            return null;
        });
        await("the view", () -> viewer.pane().isIdle());
        pointer = onEventThread(() -> world.pixelOf(at).orElseThrow());
        BusyTimes times = new BusyTimes();
        List<Double> first = new ArrayList<>();
        List<Double> fine = new ArrayList<>();
        mouse(MouseEvent.MOUSE_PRESSED);
        for (int move = 0; move < WARM + MOVES; move++) {
            if (move == WARM) {
                Toolkit.getDefaultToolkit().getSystemEventQueue().push(times);
            }
            // To and fro, so that it stays near where it is.
            pointer.x += move / 4 % 2 == 0 ? 6 : -6;
            pointer.y += move % 2 == 0 ? 4 : -3;
            SceneSettings before = onEventThread(() -> viewer.pane().placing().settings());
            long start = System.nanoTime();
            mouse(MouseEvent.MOUSE_DRAGGED);
            assertThat(onEventThread(() -> viewer.pane().placing().settings())).isNotSameAs(before);
            double picture = until(start, any -> true);
            double whole = until(start, its -> its != MoveWords.Fineness.COARSE);
            if (move >= WARM) {
                first.add(picture);
                fine.add(whole);
            }
        }
        mouse(MouseEvent.MOUSE_RELEASED);
        times.end();
        Collections.sort(first);
        Collections.sort(fine);
        System.out.printf(
                Locale.ROOT,
                "%s, %s: first picture %.0f ms (median; worst %.0f), fine picture %.0f ms (worst %.0f),"
                        + " event thread at most %.0f ms%n",
                scene,
                sensor,
                first.get(MOVES / 2),
                first.get(MOVES - 1),
                fine.get(MOVES / 2),
                fine.get(MOVES - 1),
                1e3 * times.longest());
        assertThat(times.longest()).as("s").isLessThan(0.05);
    }

    private void drag(String scene, String sensor) throws Exception {
        assumeTrue(LongForm.IS_ON, "only in the long form");
        Optional<String> obstacle = Viewer.obstacle();
        assumeTrue(obstacle.isEmpty(), () -> "no window: " + obstacle.orElse(""));
        open(scene, sensor.equals("microphone"));
        try {
            measure(scene, sensor);
        } finally {
            viewer.close();
        }
    }

    @Test
    void aRadarOverMonaco() throws Exception {
        drag("monaco.yaml", "radar-mountain");
    }

    @Test
    void aCameraOverMonaco() throws Exception {
        drag("monaco.yaml", "camera");
    }

    @Test
    void aThermalCameraOverMonaco() throws Exception {
        drag("monaco.yaml", "thermal");
    }

    @Test
    void aCameraOverMultiSensor() throws Exception {
        drag("multi-sensor.yaml", "north-east-2");
    }

    @Test
    void aMicrophoneOverMultiSensor() throws Exception {
        drag("multi-sensor.yaml", "microphone");
    }
}
