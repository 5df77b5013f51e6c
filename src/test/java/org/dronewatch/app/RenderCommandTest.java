package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.dronewatch.Thorough;
import org.dronewatch.render.Fineness;
import org.dronewatch.render.Orbit;
import org.dronewatch.render.RayFilter;
import org.dronewatch.render.SitePicture;
import org.dronewatch.render.SiteStyle;
import org.dronewatch.run.Pointings;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.sensor.optics.DepthImage;
import org.dronewatch.sensor.optics.DronePicture;
import org.dronewatch.sensor.optics.PictureSettings;
import org.junit.jupiter.api.Test;

/** Pictures of a run at one time: a camera on a positioner sees what it saw in the run. */
class RenderCommandTest extends CuedCamera {
    @Test
    void onlyCamerasAreOfferedForOneThatIsNotThere() {
        Program.Outcome outcome = Program.run(
                "render",
                scene.toString(),
                "--camera",
                "radar",
                "--out",
                directory.resolve("x.png").toString());
        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.err())
                .contains("--camera radar: takes no pictures (radar); cameras in the scene: fixed, cued");
    }

    private record Row(String run, String time, String value) {}

    /** What the cued camera observed, by the table that a user gets. */
    private List<Row> observed(String... options) throws IOException {
        Path results = directory.resolve("results");
        command(Stream.concat(
                        Stream.of("run", scene.toString(), "--observations", "--out", results.toString()),
                        Stream.of(options))
                .toArray(String[]::new));
        List<String> lines = Files.readAllLines(results.resolve("observations.csv"));
        List<String> head = List.of(lines.get(0).split(","));
        return lines.stream()
                .skip(1)
                .map(line -> line.split(",", -1))
                .filter(cells -> cells[head.indexOf("sensor")].equals("cued"))
                .map(cells -> new Row(
                        cells[head.indexOf("run")], cells[head.indexOf("time_s")], cells[head.indexOf("value")]))
                .toList();
    }

    private void assertCounted(Row row, String time, String... options) {
        String said = render(
                Stream.concat(Stream.of("--camera", "cued", "--time", time, "--run", row.run), Stream.of(options))
                        .toArray(String[]::new));
        assertThat(said)
                .as("run %s at %s s", row.run, time)
                .contains(String.format(", %.0f of them on drones", Double.parseDouble(row.value)));
    }

    @Thorough
    @Test
    void aCuedCameraShowsTheDroneWithThePixelsThatItReportedInTheRun() throws IOException {
        String picture = directory.resolve("cued.png").toString();
        List<Row> rows = observed();
        List<Row> seeing =
                rows.stream().filter(row -> Double.parseDouble(row.value) > 12).toList();

        assertThat(seeing).hasSizeGreaterThan(20);
        assertCounted(rows.get(0), "0", "--out", picture);
        for (int i = 0; i < seeing.size(); i += seeing.size() / 4) {
            assertCounted(seeing.get(i), seeing.get(i).time, "--out", picture);
        }
        // Between two looks it is the earlier one.
        Row last = seeing.get(seeing.size() - 2);
        assertCounted(last, Double.toString(Double.parseDouble(last.time) + 0.01), "--out", picture);
        assertThat(ImageIO.read(Path.of(picture).toFile()).getWidth()).isEqualTo(1920);
    }

    @Thorough
    @Test
    void seedAndRunOfASweepAreThoseOfTheRun() throws IOException {
        Files.writeString(
                scene,
                Files.readString(scene)
                                .replace("blighter-a400-m10s,", "blighter-a400-m10s, accuracy: {azimuth: 0.3 deg},")
                        + "\nsweep: {parameter: sensors.cued.positioner.zoom.tracked, values: [2.2 deg, 3 deg]}\n");
        String picture = directory.resolve("cued.pfm").toString();
        List<Row> rows = observed("--seed", "77");
        List<Row> second = rows.stream()
                .filter(row -> row.run.equals("1") && Double.parseDouble(row.value) > 12)
                .toList();

        Row one = second.get(0);
        Row two = second.get(second.size() - 1);
        assertCounted(one, one.time, "--out", picture, "--seed", "77");
        byte[] seeded = Files.readAllBytes(Path.of(picture));
        assertCounted(two, two.time, "--out", picture, "--seed", "77");
        render("--camera", "cued", "--time", one.time, "--run", "1", "--out", picture, "--seed", "78");
        assertThat(Files.readAllBytes(Path.of(picture)))
                .as("another seed points it slightly elsewhere")
                .isNotEqualTo(seeded);
    }

    /** The pointings of a run, by a run of the scene that pictures know nothing of. */
    private static Pointings pointings(SceneRunner runner) {
        Pointings pointings = new Pointings();
        runner.onFrame(pointings::add).run();
        return pointings;
    }

    private SceneRunner runner(String... overrides) {
        SceneRunner runner = new SceneRunner(new SceneFile(scene)).threads(2);
        for (String override : overrides) {
            runner.set(override.split("=")[0], override.split("=")[1]);
        }
        return runner;
    }

    private static byte[] pfm(SensorSettings<?> camera, Stage stage, double time) throws IOException {
        DepthImage image = new DronePicture(
                        new CameraObject(camera.as(PictureSettings.class).orElseThrow()))
                .depthImage(stage.world(), stage.dronesAt(time));
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        image.writePfm(bytes);
        return bytes.toByteArray();
    }

    @Test
    void thermalCamerasAndCuesFromOtherCamerasPointAsInTheRun() throws IOException {
        String[] overrides = {
            "sensors.cued=cooled-thermal-camera",
            "sensors.cued.positioner.zoom.tracked=1.8 deg",
            "sensors.cued.positioner.zoom.cued=1.8 deg",
            "sensors.cued.positioner.cues=fixed",
            "sensors.fixed.fov=12 deg",
            "sensors.fixed.aim.azimuth=42 deg"
        };
        Path picture = directory.resolve("thermal.pfm");
        render(Stream.concat(
                        Stream.of("--camera", "cued", "--time", "12", "--out", picture.toString()),
                        Stream.of(overrides).flatMap(set -> Stream.of("--set", set)))
                .toArray(String[]::new));

        SceneRunner runner = runner(overrides);
        SceneSettings settings = runner.settings();
        Pointings pointings = pointings(runner);
        SensorSettings<?> camera = settings.sensors().get("cued");
        assertThat(pointings.at("cued", 12.0).orElseThrow().contact())
                .as("cued by the other camera")
                .isPresent();
        assertThat(Files.readAllBytes(picture))
                .isEqualTo(pfm(Mounted.pointed(camera, pointings.at("cued", 12.0)), runner.stage(settings), 12.0));
    }

    @Test
    void aCameraOnAFixedMountIsDrawnAtAnyTimeWithoutASimulation() throws IOException {
        Path picture = directory.resolve("fixed.pfm");
        String[] endless = {"run.duration=1000000 s", "sensors.cued.rate=60 Hz"};
        assertTimeoutPreemptively(
                Duration.ofSeconds(60),
                () -> render(
                        "--camera",
                        "fixed",
                        "--time",
                        "13.337",
                        "--out",
                        picture.toString(),
                        "--set",
                        endless[0],
                        "--set",
                        endless[1]));
        assertTimeoutPreemptively(
                Duration.ofSeconds(60),
                () -> render(
                        "--camera",
                        "fixed",
                        "--time",
                        "900000",
                        "--out",
                        directory.resolve("late.png").toString(),
                        "--set",
                        endless[0],
                        "--set",
                        endless[1]));

        SceneRunner runner = runner();
        SceneSettings settings = runner.settings();
        assertThat(Files.readAllBytes(picture))
                .isEqualTo(pfm(settings.sensors().get("fixed"), runner.stage(settings), 13.337));
    }

    @Test
    void theSiteShowsWhereTheMountPointsThen() throws IOException {
        Path picture = directory.resolve("site.png");
        render("--view", "top", "--time", "12.02", "--size", "400x300", "--out", picture.toString());

        SceneRunner runner = runner();
        SceneSettings settings = runner.settings();
        Pointings pointings = pointings(runner);
        Stage stage = runner.stage(settings);
        SitePicture site = new SitePicture(settings, stage);
        var image = site.draw(
                site.backdrop(
                        Orbit.top(site.frame(), 4.0 / 3.0), 400, 300, site.openRoof(12.02), Fineness.FINE, () -> false),
                site.state(
                        "counted",
                        12.02,
                        (sensor, drone) -> false,
                        sensor -> pointings.at(sensor, 12.02),
                        Optional.empty(),
                        Optional.empty()),
                SiteStyle.DEFAULT.withFilter(RayFilter.ALL));
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ImageIO.write(image, "png", bytes);
        assertThat(pointings.at("cued", 12.02).orElseThrow().contact()).hasValue(1);
        assertThat(Files.readAllBytes(picture)).isEqualTo(bytes.toByteArray());
    }
}
