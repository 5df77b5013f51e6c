package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Direction;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.run.PairResult;
import org.dronewatch.run.SceneResult;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * A camera cues another that stands 60 m beside it, at a drone 300 m away: the parallax is 11.3 degrees, and the cued
 * camera is zoomed to 4.
 */
class ParallaxTest {
    private static final Position EYE = new Position(60, 0, 52);

    private static final String GROUND =
            """
            v -4000 0 -4000
            v 4000 0 -4000
            v 4000 0 4000
            v -4000 0 4000
            f 1 3 2
            f 1 4 3
            """;

    private static final String SCENE =
            """
            world: {models: [ground.obj]}
            drones:
              intruder:
                model: packaged:quadrotor.obj
                flight: {kind: approach, from: [-120, 300, 52], to: [120, 300, 52]}
                speed: 10 m/s
            sensors:
              wide:
                use: piranha-46-hr
                position: [0, 0, 52]
                fov: 40 deg
                aim: {azimuth: 0 deg, elevation: 0 deg}
                detection: {kind: target-task}
              second:
                use: piranha-46-hr
                position: [-60, 30, 52]
                fov: 40 deg
                aim: {azimuth: 0 deg, elevation: 0 deg}
                detection: {kind: target-task}
              eye:
                use: piranha-46-hr
                fov: 4 deg
                position: [60, 0, 52]
                aim: {azimuth: 40 deg, elevation: 0 deg}
                detection: {kind: target-task, task: identification}
                positioner:
                  use: viper
                  cues: [CUES]
                  lockPixels: 100000
                  zoom: {cued: 4 deg, tracked: 2.2 deg, time: 0 s}
            run: {duration: 24 s}
            """;

    @TempDir
    private Path directory;

    private SceneRunner runner(String cues) throws IOException {
        Files.writeString(directory.resolve("ground.obj"), GROUND);
        Path file = directory.resolve("scene.yaml");
        Files.writeString(file, SCENE.replace("CUES", cues));
        return new SceneRunner(new SceneFile(file)).threads(2);
    }

    /** The seconds that the page about positioners states in a row of its table. */
    private static double page(String row) throws IOException {
        String line = Files.readAllLines(Path.of("src/site/markdown/positioner.md")).stream()
                .filter(one -> one.startsWith("| " + row))
                .findFirst()
                .orElseThrow();
        return Double.parseDouble(line.replaceAll("[^|]*\\|[^|]*\\| ([0-9.]+) s.*", "$1"));
    }

    private static double first(SceneResult result, String sensor) {
        return result.pairs().stream()
                .filter(pair -> pair.sensor().equals(sensor))
                .map(PairResult::firstDetected)
                .filter(OptionalDouble::isPresent)
                .mapToDouble(OptionalDouble::getAsDouble)
                .findFirst()
                .orElse(Double.POSITIVE_INFINITY);
    }

    /**
     * Half a second of delay, then stops of 0.2 s from where the drone would be if it were small; it must identify to
     * lock on.
     */
    @Test
    void theCuedCameraFindsTheDroneWithinFourSeconds() throws IOException {
        SceneResult result = runner("wide").run();

        assertThat(first(result, "eye") - first(result, "wide"))
                .isCloseTo(page("ranges that the drone's apparent size allows"), within(0.06));
    }

    /** Where nothing is known of the drone's size, the search begins at 50 m. */
    @Test
    void alongTheWholeLineItTakesASecondMore() throws IOException {
        SceneResult result = runner("wide")
                .set("sensors.eye.positioner.rangeSearch.minSize", "0.01")
                .set("sensors.eye.positioner.rangeSearch.maxSize", "100")
                .run();

        assertThat(first(result, "eye") - first(result, "wide")).isCloseTo(page("whole line"), within(0.06));
    }

    /** The direction of the line itself, 11 degrees beside the drone, is what the camera had been pointed at. */
    @Test
    void withoutASearchItNeverDoes() throws IOException {
        SceneResult result = runner("wide")
                .set("sensors.eye.positioner.rangeSearch.minRange", "10 km")
                .run();

        assertThat(first(result, "eye")).isInfinite();
    }

    @Test
    void twoCuesFromDifferentPlacesTakeASecond() throws IOException {
        SceneResult result = runner("wide, second").run();

        assertThat(first(result, "eye") - Math.max(first(result, "wide"), first(result, "second")))
                .isCloseTo(page("cued by a second camera"), within(0.06));
    }

    @Test
    void twoCuesFromDifferentPlacesPointItStraightAtTheDrone() throws IOException {
        List<Pointing> pointings = new ArrayList<>();
        SceneResult result = runner("wide, second")
                .set("sensors.wide.fov", "24 deg")
                .set("sensors.second.fov", "24 deg")
                .set("sensors.eye.detection.probability", "99.9999 %")
                .onFrame(frame -> {
                    if (frame.time() > 8.0
                            && frame.time() < 14.0
                            && frame.pointings().containsKey("eye")) {
                        pointings.add(frame.pointings().get("eye"));
                        Position drone = frame.drones().get(0).origin();
                        Direction exact = Direction.of(drone.minus(EYE));
                        Direction found = frame.pointings().get("eye").direction();
                        assertThat(found.azimuth()).isCloseTo(exact.azimuth(), within(Math.toRadians(0.1)));
                    }
                })
                .run();

        assertThat(first(result, "eye")).isInfinite();
        assertThat(pointings).hasSizeGreaterThan(70);
    }
}
