package org.dronewatch.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dronewatch.viewer.EventThread.await;
import static org.dronewatch.viewer.EventThread.onEventThread;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.Toolkit;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import javax.swing.JTable;
import org.dronewatch.render.Yard;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.setting.SettingsPath;
import org.dronewatch.viewer.beside.ComparisonPanel;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Two runs in the real window: before and after a change, and of two scenes. */
class ComparingWindowTest {
    private static final double LONGEST = 0.05;

    @TempDir
    private Path directory;

    private Viewer viewer;
    private Thread watching;

    /** Opens the yard; runs a second scene beside it if there is one, then whatever the user opens. */
    private void open(Optional<Scene> beside) throws Exception {
        assumeTrue(
                Viewer.obstacle().isEmpty(),
                () -> "no window: " + Viewer.obstacle().orElse(""));
        Yard yard = new Yard(directory);
        SceneRunner runner = runner(yard);
        Viewer.Subject first = new Viewer.Subject(yard, runner, Optional.empty());
        CompletableFuture<Viewer> opened = new CompletableFuture<>();
        watching = new Thread(() -> {
            Viewer own = Viewer.open(
                    first, 1, directory.resolve("viewer.properties"), Optional.of(ComparingWindowTest::runner));
            opened.complete(own);
            run(own, runner);
            beside.ifPresent(scene -> own.runBeside(scene.name(), runner(scene).set("sensors.camera.fov", "5 deg")));
            for (Optional<Viewer.Subject> next = own.awaitNext(); next.isPresent(); next = own.awaitNext()) {
                run(own, next.get().runner());
            }
        });
        watching.start();
        viewer = opened.get(30, TimeUnit.SECONDS);
        settle();
        onEventThread(() -> {
            viewer.pane().playback().pause();
            return null;
        });
    }

    @AfterEach
    void close() throws Exception {
        if (viewer != null) {
            viewer.close();
            watching.join(TimeUnit.SECONDS.toMillis(20));
        }
    }

    private static SceneRunner runner(Scene scene) {
        return new SceneRunner(scene).threads(1);
    }

    private static void run(Viewer viewer, SceneRunner runner) {
        runner.listener(viewer.listener()).cancelWhen(viewer::isLeft).run();
        viewer.finished(true);
    }

    private void settle() throws Exception {
        await(
                "the run and its picture",
                () -> viewer.pane().viewed().isPresent()
                        && viewer.pane().recording().isFinished()
                        && viewer.pane().isIdle());
    }

    private ComparisonPanel panel() {
        return viewer.pane().tabs().comparison();
    }

    private void changeAndRunAgain(double degrees) throws Exception {
        ViewerPane before = viewer.pane();
        onEventThread(() -> {
            CameraSettings camera =
                    (CameraSettings) before.placing().settings().sensors().get("camera");
            before.placing().layoutOfSensors().set("camera", new SettingsPath("fov").write(camera, degrees + " deg"));
            before.tabs().settings().again().doClick(0);
            return null;
        });
        await("the second run", () -> viewer.pane() != before);
        settle();
        onEventThread(() -> {
            viewer.pane().playback().pause();
            viewer.pane().tabs().setSelectedComponent(panel());
            return null;
        });
        await("the comparison", () -> panel().table().getRowCount() > 0);
    }

    private String cell(int row, int column) throws Exception {
        return onEventThread(() -> (String) panel().table().getValueAt(row, column));
    }

    private void press(int code) throws Exception {
        onEventThread(() -> {
            WorldPanel world = viewer.pane().world();
            world.dispatchEvent(new KeyEvent(
                    world, KeyEvent.KEY_PRESSED, System.currentTimeMillis(), 0, code, KeyEvent.CHAR_UNDEFINED));
            return null;
        });
    }

    @Test
    void aChangedSceneIsComparedWithTheRunBefore() throws Exception {
        open(Optional.empty());
        assertThat(onEventThread(() -> panel().said())).startsWith("There is no other run yet.");
        changeAndRunAgain(5);
        BusyTimes times = new BusyTimes();
        Toolkit.getDefaultToolkit().getSystemEventQueue().push(times);
        try {
            assertThat(onEventThread(() -> panel().chosen().orElseThrow().name()))
                    .isEqualTo(Comparing.BEFORE);
            assertThat(onEventThread(() -> viewer.pane().comparing().viewed()))
                    .as("the other site, before it is asked for")
                    .isEmpty();
            press(KeyEvent.VK_B);
            await("the other site", () -> viewer.pane().comparing().viewed().isPresent());
            onEventThread(() -> {
                viewer.pane().playback().jump(4.5);
                return null;
            });
            settle();
            KeptPicture.of(viewer.window().frame(), "comparing");
            theOtherViewFollows();
        } finally {
            times.end();
        }
        assertThat(times.longest()).as("processor time of the longest event, s").isLessThan(LONGEST);

        JTable table = panel().table();
        assertThat(onEventThread(table::getRowCount))
                .as("any sensor, camera, microphone")
                .isEqualTo(3);
        assertThat(cell(0, 1)).isEqualTo("any");
        assertThat(cell(1, 1)).isEqualTo("camera");
        assertThat(cell(2, 1)).isEqualTo("microphone");
        assertThat(cell(1, 4)).as("what the change has done").isEqualTo("0.80 s later");
        assertThat(cell(2, 4)).isEqualTo("same");
        assertThat(onEventThread(() -> panel().said()))
                .startsWith("Sensors that differ: 'camera' fov 5 deg (other run: 39.64 deg).")
                .contains("First detection of 'quadrotor': ");
        assertThat(onEventThread(() -> table.getAccessibleContext().getAccessibleName()))
                .isEqualTo("first detections in both runs");
        press(KeyEvent.VK_B);
        await("one site", () -> viewer.pane().comparing().viewed().isEmpty());
    }

    /** Whichever of both is turned. */
    private void theOtherViewFollows() throws Exception {
        WorldPanel own = viewer.pane().world();
        WorldPanel other = viewer.pane().comparing().other();
        onEventThread(() -> {
            assertThat(other.getSize()).isEqualTo(own.getSize());
            own.move(own.orbit().zoomed(0.5));
            assertThat(other.orbit()).isEqualTo(own.orbit());
            other.move(other.orbit().walked(3.0, 1.0));
            assertThat(own.orbit()).isEqualTo(other.orbit());
            other.setCut(Optional.empty());
            assertThat(own.cut()).isEmpty();
            return null;
        });
        settle();
        assertThat(onEventThread(() -> other.image() != null)).isTrue();
    }

    /** Running again compares with the last run, and the scene beside is kept. */
    @Test
    void anotherSceneIsShownBesideAsSoonAsItRuns() throws Exception {
        open(Optional.of(new Yard(directory)));
        await(
                "the other run",
                () -> viewer.pane().comparing().viewed().isPresent()
                        && viewer.pane().comparing().viewed().get().run().isFinished());
        settle();
        assertThat(onEventThread(() -> panel().chosen().orElseThrow().name())).isEqualTo("yard");
        assertThat(onEventThread(() -> panel().isBeside())).isTrue();
        changeAndRunAgain(20);
        changeAndRunAgain(30);
        assertThat(onEventThread(() -> panel().offered().toString())).isEqualTo("[yard, before the change]");
    }
}
