package org.dronewatch.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dronewatch.viewer.EventThread.await;
import static org.dronewatch.viewer.EventThread.onEventThread;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.Toolkit;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import javax.swing.JTable;
import javax.swing.JTextField;
import org.dronewatch.render.Yard;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.viewer.settings.SettingsPanel;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The settings of a sensor in the real window: edited, refused, undone, run again and saved. */
class SettingsWindowTest {
    private static final double LONGEST = 0.05;

    @TempDir
    private Path directory;

    private final CompletableFuture<SceneResult> second = new CompletableFuture<>();
    private Viewer viewer;
    private Thread watching;

    @BeforeEach
    void open() throws Exception {
        assumeTrue(
                Viewer.obstacle().isEmpty(),
                () -> "no window: " + Viewer.obstacle().orElse(""));
        Yard yard = new Yard(directory);
        SceneRunner runner = runner(yard).set("run.duration", "1 s");
        Viewer.Subject first = new Viewer.Subject(yard, runner, Optional.empty());
        CompletableFuture<Viewer> opened = new CompletableFuture<>();
        watching = new Thread(() -> {
            Viewer own = Viewer.open(
                    first, 1, directory.resolve("viewer.properties"), Optional.of(SettingsWindowTest::runner));
            run(own, runner);
            opened.complete(own);
            own.awaitNext().ifPresent(next -> second.complete(run(own, next.runner())));
            own.awaitNext();
        });
        watching.start();
        viewer = opened.get(30, TimeUnit.SECONDS);
        await(
                "the site",
                () -> viewer.pane().viewed().isPresent() && viewer.pane().isIdle());
        onEventThread(() -> {
            viewer.pane().playback().pause();
            viewer.pane().select("camera");
            viewer.pane().tabs().setSelectedComponent(settings());
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

    private static SceneResult run(Viewer viewer, SceneRunner runner) {
        SceneResult result =
                runner.listener(viewer.listener()).cancelWhen(viewer::isLeft).run();
        viewer.finished(true);
        return result;
    }

    private SettingsPanel settings() {
        return viewer.pane().tabs().settings();
    }

    private CameraSettings camera() throws Exception {
        return onEventThread(() ->
                (CameraSettings) viewer.pane().placing().settings().sensors().get("camera"));
    }

    private int row(String path) throws Exception {
        return onEventThread(() -> {
            JTable table = settings().table();
            for (int row = 0; row < table.getRowCount(); row++) {
                if (table.getValueAt(row, 0).equals(path)) {
                    return row;
                }
            }
            throw new AssertionError("no setting " + path);
        });
    }

    private void type(String path, String text) throws Exception {
        int row = row(path);
        onEventThread(() -> {
            JTable table = settings().table();
            assertThat(table.editCellAt(row, 1)).isTrue();
            JTextField field = (JTextField) table.getEditorComponent();
            field.setText(text);
            field.postActionEvent();
            return null;
        });
    }

    private String shown(String path, int column) throws Exception {
        int row = row(path);
        return onEventThread(() -> (String) settings().table().getValueAt(row, column));
    }

    private void keep(String name) throws Exception {
        await("the picture", () -> viewer.pane().isIdle());
        KeptPicture.of(viewer.window().frame(), name);
    }

    @Test
    void aValueIsEditedWithItsUnitUndoneAndRedoneWithoutHoldingUpTheEventThread() throws Exception {
        double before = camera().fov();
        BusyTimes times = new BusyTimes();
        Toolkit.getDefaultToolkit().getSystemEventQueue().push(times);
        try {
            type("fov", "45");
            assertThat(camera().fov()).isEqualTo(Math.toRadians(45));
            assertThat(shown("fov", 1)).isEqualTo("45 deg");
            assertThat(settings().said()).contains("'camera': fov is now 45 deg instead of ");
            type("fov", "1 rad");
            assertThat(camera().fov()).isEqualTo(1.0);
            onEventThread(() -> {
                viewer.pane().placing().undo();
                return null;
            });
            assertThat(camera().fov()).isEqualTo(Math.toRadians(45));
            assertThat(shown("fov", 1)).isEqualTo("45 deg");
            onEventThread(() -> {
                viewer.pane().placing().undo();
                return null;
            });
            assertThat(camera().fov()).isEqualTo(before);
            onEventThread(() -> {
                viewer.pane().placing().redo();
                return null;
            });
            assertThat(camera().fov()).isEqualTo(Math.toRadians(45));
        } finally {
            times.end();
        }
        assertThat(times.longest()).as("processor time of the longest event, s").isLessThan(LONGEST);
    }

    @Test
    void aValueThatDoesNotFitIsRefusedBesideTheFieldAndChangesNothing() throws Exception {
        CameraSettings before = camera();
        String limits = shown("fov", 2);
        type("fov", "200");

        assertThat(camera()).isEqualTo(before);
        assertThat(shown("fov", 1)).isEqualTo("200");
        assertThat(shown("fov", 2)).contains("200 deg must be 0.01 to 179 deg");
        assertThat(shown("rate", 2)).doesNotContain("must be 0.01");
        keep("settings-refused");
        type("rate", "fast");
        assertThat(shown("rate", 2)).contains("'fast' is not a number");
        type("fov", "50 deg");
        assertThat(camera().fov()).isEqualTo(Math.toRadians(50));
        assertThat(shown("fov", 2)).isEqualTo(limits);
        assertThat(onEventThread(() -> settings().table().getAccessibleContext().getAccessibleName()))
                .isEqualTo("settings of the selected sensor");
    }

    /** The results in the window are those of the saved file without a window; until then, they count as not saved. */
    @Test
    void theSceneRunsAgainWithTheEditedSettingsAndIsSaved() throws Exception {
        assertThat(onEventThread(() -> settings().again().isEnabled())).isFalse();
        type("fov", "12");
        assertThat(onEventThread(() -> settings().again().isEnabled())).isTrue();
        ViewerPane before = viewer.pane();
        onEventThread(() -> {
            settings().again().doClick(0);
            return null;
        });
        SceneResult inWindow = second.get(30, TimeUnit.SECONDS);
        await(
                "the second run",
                () -> viewer.pane() != before && viewer.pane().viewed().isPresent());
        assertThat(camera().fov()).isEqualTo(Math.toRadians(12));
        assertThat(onEventThread(() -> viewer.pane().placing().layoutOfSensors().unsaved()))
                .as("what is in no file after the run, either")
                .containsExactly("camera");
        assertThat(onEventThread(() -> viewer.window().frame().getTitle())).startsWith("yard");

        Path file = directory.resolve("edited.yaml");
        onEventThread(() -> {
            new SceneSaving(viewer.pane(), "yard", new SceneRunner(new Yard(directory))::text).write(file.toString());
            return null;
        });
        assertThat(onEventThread(() -> viewer.pane().placing().layoutOfSensors().unsaved()))
                .isEmpty();
        assertThat(new SceneRunner(new SceneFile(file)).run().runs()).isEqualTo(inWindow.runs());
    }
}
