package org.dronewatch.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.dronewatch.viewer.EventThread.onEventThread;

import java.awt.Color;
import java.awt.Container;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.swing.JTable;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.render.Films;
import org.dronewatch.render.Yard;
import org.dronewatch.render.film.Film;
import org.dronewatch.render.film.FilmMaker;
import org.dronewatch.run.DetectionEvent;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.scenes.CameraRange;
import org.dronewatch.scenes.ClosedSpace;
import org.dronewatch.setting.InputException;
import org.dronewatch.viewer.run.Events;
import org.dronewatch.viewer.run.RecordedRun;
import org.dronewatch.viewer.run.Recording;
import org.dronewatch.viewer.run.ViewedRun;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** All of the window's content, painted without a window. */
class ViewerPaneTest {
    private static final long PATIENCE_NANOS = 60_000_000_000L;

    @TempDir
    private Path directory;

    private ViewerPane pane;

    private void open(Scene scene, String... overrides) throws Exception {
        SceneRunner runner = new SceneRunner(scene);
        for (String override : overrides) {
            runner.set(override.split("=")[0], override.split("=")[1]);
        }
        Recording recording = new Recording();
        runner.listener(recording).run();
        recording.finish(true);
        pane = onEventThread(() -> new ViewerPane(scene.name(), recording, 2, settings -> LayerStore.NONE));
        onEventThread(() -> {
            pane.setSize(1280, 740);
            Parts.layOut(pane);
            return null;
        });
        settle(() -> pane.viewed().isPresent());
    }

    @AfterEach
    void close() {
        if (pane != null) {
            pane.close();
        }
    }

    /** Lets the pane work until a condition holds and all is drawn. */
    private void settle(BooleanSupplier condition) throws Exception {
        long end = System.nanoTime() + PATIENCE_NANOS;
        boolean done = false;
        while (!done) {
            assertThat(System.nanoTime()).as("end of patience").isLessThan(end);
            Thread.sleep(30);
            done = onEventThread(() -> {
                pane.tick(0.2);
                Parts.layOut(pane);
                return condition.getAsBoolean() && pane.isIdle();
            });
        }
        // What the threads have sent is taken in.
        onEventThread(() -> null);
    }

    private void at(double time) throws Exception {
        onEventThread(() -> {
            pane.playback().pause();
            pane.playback().jump(time);
            return null;
        });
        settle(() -> true);
    }

    private BufferedImage picture(String name) throws Exception {
        BufferedImage image = onEventThread(() -> Exports.picture(pane));
        Path kept = Files.createDirectories(Path.of("target", "viewer"));
        ImageIO.write(image, "png", kept.resolve(name + ".png").toFile());
        return image;
    }

    @Test
    void showsSiteCamerasTimeLineAndTables() throws Exception {
        open(new Yard(directory));
        at(8.0);
        BufferedImage image = picture("pane");

        assertThat(pane.notice().isVisible()).isFalse();
        assertThat(pane.cameras().shown()).hasSize(1);
        assertThat(colours(image)).as("a picture, not a grey area").isGreaterThan(500);
        ViewedRun viewed = pane.viewed().orElseThrow();
        assertThat(viewed.isDetecting("camera", 8.0)).isTrue();
        JTable table = find(pane, JTable.class).get(0);
        assertThat(table.getValueAt(0, 0)).isEqualTo("camera");
        assertThat(table.getValueAt(0, 3)).isEqualTo("detects");
        assertThat((String) table.getValueAt(0, 6)).isEqualTo("12 px");
        assertThat(pane.log().text()).contains("camera detects quadrotor at");
    }

    @Test
    void theSceneOfTheRunIsSavedAndWhatIsWrongIsShown() throws Exception {
        CameraRange scene = new CameraRange();
        open(scene, "run.duration=0.5");
        SceneSettings shown = pane.viewed().orElseThrow().settings();
        assertThat(pane.notice().isVisible()).isFalse();
        SceneSaving saving = new SceneSaving(pane, "camera-range", new SceneRunner(scene)::text);
        Path file = directory.resolve("first.yaml");
        onEventThread(() -> {
            saving.write(file.toString());
            return null;
        });
        assertThat(new SceneRunner(new SceneFile(file)).settings()).isEqualTo(shown);

        onEventThread(() -> {
            saving.write(directory.resolve("none").resolve("first.yaml").toString());
            return null;
        });
        settle(() -> pane.notice().isVisible());
        assertThat(pane.log().text()).contains("there is no directory");

        Path own = Files.writeString(directory.resolve("own.yaml"), "# mine\n");
        onEventThread(() -> {
            saving.write(own.toString());
            return null;
        });
        settle(() -> pane.log().text().contains("'save' did not write it"));
        assertThat(own).hasContent("# mine");
    }

    private static long colours(BufferedImage image) {
        return java.util.Arrays.stream(
                        image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth()))
                .distinct()
                .count();
    }

    private static <T> List<T> find(Container container, Class<T> type) {
        return Stream.of(container.getComponents())
                .flatMap(part -> Stream.concat(
                        type.isInstance(part) ? Stream.of(type.cast(part)) : Stream.of(),
                        part instanceof Container inside ? find(inside, type).stream() : Stream.of()))
                .toList();
    }

    @Test
    void theTimeLineMarksEveryDetectionGainedAndLost() throws Exception {
        open(new Yard(directory));
        at(0.0);
        TimeLine line = pane.timeLine();
        BufferedImage image = onEventThread(() -> Exports.picture(line));
        List<DetectionEvent> events = pane.viewed().orElseThrow().run().eventsFrom(0);
        List<String> sensors = List.of("camera", "microphone");

        assertThat(events).isNotEmpty();
        for (DetectionEvent event : events) {
            int row = sensors.indexOf(event.observation().sensor());
            double x = line.xOf(event.observation().arrival());
            int y = (int) (0.5 * (line.yOf(row) + line.yOf(row + 1)));
            Color mark = new Color(image.getRGB((int) Math.round(x) + (event.gained() ? 2 : 0), y));
            Color empty = new Color(image.getRGB((int) line.xOf(0.05), y));
            int difference = Math.abs(mark.getRed() - empty.getRed())
                    + Math.abs(mark.getGreen() - empty.getGreen())
                    + Math.abs(mark.getBlue() - empty.getBlue());
            assertThat(difference).as("mark of %s", Events.text(event)).isGreaterThan(150);
        }
    }

    @Test
    void raysAreTracedCountedFilteredAndDrawn() throws Exception {
        open(new Yard(directory));
        at(8.0);
        BufferedImage before = onEventThread(() -> pane.world().image());
        onEventThread(() -> {
            pane.rayPanel().trace();
            return null;
        });
        settle(() -> pane.rays().isPresent());
        int all = pane.rays().orElseThrow().count();
        String heard = pane.rayPanel().count();
        assertThat(heard)
                .startsWith("Traced at 8.00 s: ")
                .contains(String.format(" of %,d ray segments drawn", all))
                .doesNotContain(String.format("%,d of %,d", all, all))
                .doesNotContain("now");
        BufferedImage only = onEventThread(() -> pane.world().image());
        assertThat(different(before, only)).as("the paths that are heard").isGreaterThan(200);

        onEventThread(() -> {
            pane.rayPanel().setHeardOnly(false);
            return null;
        });
        settle(() -> true);
        assertThat(pane.rayPanel().count()).contains(String.format("%,d of %,d ray segments drawn", all, all));
        assertThat(different(only, onEventThread(() -> pane.world().image()))).isGreaterThan(2000);
        picture("rays");
    }

    @Test
    void aSensorThatShowsItsRaysNeedsNotBeAsked() throws Exception {
        open(new ClosedSpace());
        settle(() -> pane.rays().isPresent());
        assertThat(pane.rays().orElseThrow().sensor()).isEqualTo("microphone");
        assertThat(pane.rays().orElseThrow().count()).isGreaterThan(5_000);
    }

    @Test
    void raysSayForWhichTimeTheyWereTracedOnceTimeHasMovedOn() throws Exception {
        open(new Yard(directory));
        at(2.0);
        onEventThread(() -> {
            pane.rayPanel().trace();
            return null;
        });
        settle(() -> pane.rays().isPresent());
        assertThat(pane.rays().orElseThrow().time()).isEqualTo(2.0);

        at(8.5);
        assertThat(pane.rayPanel().count())
                .startsWith("Traced at 2.00 s: ")
                .endsWith("The displayed time is now 8.50 s.");
        picture("rays-old");
        at(2.0);
        assertThat(pane.rayPanel().count()).doesNotContain("now");
    }

    @Thorough
    @Test
    void filmsOfSiteAndCameraPlayBack() throws Exception {
        open(new Yard(directory));
        at(0.0);
        ViewedRun viewed = pane.viewed().orElseThrow();
        FilmExport films = new FilmExport(pane, new Exports(pane, pane::report), pane::report);
        Film film = FilmExport.film(viewed, "7", "9", "2", "1");
        FilmMaker site = onEventThread(() -> films.site(viewed, film));
        Path file = directory.resolve("site.mp4");
        FilmExport.write(site, file.toString(), done -> {}, () -> false);
        at(9.0);
        List<BufferedImage> frames = Films.frames(file);
        assertThat(frames).hasSize(5);
        BufferedImage last = onEventThread(() -> pane.world().image());
        assertThat(Films.difference(last, frames.get(4))).isLessThan(6.0);

        Path camera = directory.resolve("camera.mp4");
        FilmExport.write(FilmExport.camera(viewed, "camera", film), camera.toString(), done -> {}, () -> false);
        List<BufferedImage> looks = Films.frames(camera);
        assertThat(looks).hasSize(5);
        assertThat(looks.get(0).getWidth()).isEqualTo(320);
        assertThat(Films.difference(looks.get(0), looks.get(4)))
                .as("the drone comes")
                .isGreaterThan(0.2);
    }

    @Test
    void aFilmThatIsCancelledLeavesNothingAndItsThreadEnds() throws Exception {
        open(new Yard(directory));
        ViewedRun viewed = pane.viewed().orElseThrow();
        List<Path> before = files();
        FilmMaker film = FilmExport.camera(viewed, "camera", new Film(0.0, 9.0, 60, 0.1));
        int[] frames = {0};
        assertThatExceptionOfType(CancellationException.class)
                .isThrownBy(() -> FilmExport.write(
                        film,
                        directory.resolve("half.mp4").toString(),
                        done -> frames[0] = done,
                        () -> frames[0] == 4));
        assertThat(files()).isEqualTo(before);

        assertThatIllegalArgumentException()
                .isThrownBy(() -> FilmExport.film(viewed, "0", "9.5", "25", "1"))
                .withMessageContaining("only 9.00 s have been simulated");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> FilmExport.film(viewed, "0", "soon", "25", "1"))
                .withMessage("end time 'soon': must be a number");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> FilmExport.film(viewed, "0", "9", "2.5", "1"))
                .withMessage("frames per second '2.5': must be a whole number");
    }

    private List<Path> files() throws IOException {
        try (Stream<Path> all = Files.list(directory)) {
            return all.sorted().toList();
        }
    }

    private static int different(BufferedImage one, BufferedImage other) {
        int count = 0;
        for (int row = 0; row < one.getHeight(); row++) {
            for (int column = 0; column < one.getWidth(); column++) {
                count += one.getRGB(column, row) == other.getRGB(column, row) ? 0 : 1;
            }
        }
        return count;
    }

    @Test
    void aSweepShowsEachOfItsRuns() throws Exception {
        open(new CameraRange(), "run.duration=2");
        assertThat(pane.viewed().orElseThrow().run().info().run()).isZero();
        List<RecordedRun> runs = onEventThread(() -> {
            pane.tick(0.2);
            return pane.recording().runs();
        });
        assertThat(runs).hasSize(5);
        onEventThread(() -> {
            pane.show(runs.get(3));
            return null;
        });
        settle(() -> pane.viewed().orElseThrow().run() == runs.get(3));
        assertThat(pane.cameras().shown().get(0).eye().settings().fov()).isEqualTo(Math.PI / 3);
    }

    @Test
    void whatGoesWrongIsToldInTheWindow() throws Exception {
        open(new Yard(directory));
        onEventThread(() -> {
            pane.report(new InputException("site.obj:7: not a number: x"));
            return null;
        });
        onEventThread(() -> null);
        assertThat(pane.notice().isVisible()).isTrue();
        assertThat(pane.notice().text()).isEqualTo("site.obj:7: not a number: x");
        assertThat(pane.log().text()).contains("site.obj:7");
    }

    @Test
    void aRunIsKeptAsNumberedPictures() throws Exception {
        open(new Yard(directory));
        at(0.0);
        Path target = Files.createDirectories(directory.resolve("frames"));
        FrameExport export = onEventThread(
                () -> new Exports(pane, pane::report).export(pane.viewed().orElseThrow(), target, 2.0));
        int[] told = {0};

        assertThat(export.count()).isEqualTo(19);
        assertThat(export.write(done -> told[0] = done, () -> told[0] == 7)).isEqualTo(7);

        try (Stream<Path> files = Files.list(target)) {
            assertThat(files.map(file -> file.getFileName().toString()).sorted())
                    .hasSize(7)
                    .startsWith("frame-00000.png")
                    .endsWith("frame-00006.png");
        }
        BufferedImage first = ImageIO.read(target.resolve("frame-00000.png").toFile());
        BufferedImage last = ImageIO.read(target.resolve("frame-00006.png").toFile());
        assertThat(first.getWidth()).isEqualTo(pane.world().getWidth());
        assertThat(different(first, last)).as("the drone has moved").isGreaterThan(100);
    }

    @Test
    void theUsersLayoutIsRememberedAndABrokenFileIsNoHarm() throws Exception {
        Path file = directory.resolve("deep").resolve("viewer.properties");
        ViewerLayout layout = new ViewerLayout(file);
        assertThat(layout.bounds()).isEmpty();
        layout.setBounds(new java.awt.Rectangle(10, 20, 900, 700));
        layout.setDark(true);
        layout.setDivider("across", 432);
        assertThat(layout.save()).isTrue();

        ViewerLayout again = new ViewerLayout(file);
        assertThat(again.bounds()).contains(new java.awt.Rectangle(10, 20, 900, 700));
        assertThat(again.isDark()).isTrue();
        assertThat(again.divider("across")).contains(432);

        Files.writeString(file, "x=many\nwidth=\\u00zz\n");
        assertThat(new ViewerLayout(file).bounds()).isEmpty();
    }
}
