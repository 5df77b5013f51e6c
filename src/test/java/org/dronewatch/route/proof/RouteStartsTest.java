package org.dronewatch.route.proof;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.flight.RouteFlight;
import org.dronewatch.flight.RouteLeg;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.run.Stage;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A certain radar that scans every 5 s: where a drone begins decides nothing, since it may begin at any moment. */
class RouteStartsTest {
    /** It sees for certain up to 80 m, high above the boxes of the site. */
    private static final String RADAR =
            """
              slow: {kind: radar, position: [0, 0, 100], rate: 0.2, minRange: 1, maxRange: 80, elevationWidth: 90 deg,
                minSpeed: 0 m/s, budget: {range: 5000, crossSection: 0.01}, detection: {kind: chance, pulses: 8}}
            """;

    private static final double SPEED = 20.0;

    @TempDir
    private Path directory;

    private SceneSettings scene(String sensors, double from) throws IOException {
        FieldSite site = FieldSite.in(directory, sensors);
        RouteLeg leg = new RouteLeg(new Position(0, 40, 100), Optional.of(SPEED), true);
        return RouteScene.of(
                site.settings(), FieldSite.DRONE, RouteFlight.of(new Position(0, from, 100), List.of(leg)));
    }

    private FlownRoute flown(SceneSettings scene) {
        return FlownRoute.of(scene, models(scene));
    }

    private ModelCache models(SceneSettings scene) {
        return new SceneRunner(new SceneFile(directory.resolve("site.yaml"))).load(scene);
    }

    /** The drone is in range for 40 m, or 2 s of 5 s, so that two in five are detected, to an eighth. */
    @Test
    void theChanceOfALookDoesNotDependOnTheLengthOfTheRoute() throws IOException {
        for (double from : new double[] {100, 120, 140, 160, 180}) {
            FlownRoute flown = flown(scene(RADAR, from));

            assertThat(flown.detection()).as("from %s m", from).isCloseTo(0.4, within(1.0 / RouteStarts.MOST));
            assertThat(flown.exposure().detection(1000.0)).isCloseTo(flown.detection(), within(1e-5));
            double seconds = (from - 40) / SPEED;
            assertThat(flown.exposure().medianDetection().orElseThrow()).isBetween(seconds - 2.0, seconds);
            double alert = flown.interruption(0.0).orElseThrow();
            assertThat(alert).isCloseTo(flown.detection(), within(1e-3));
        }
    }

    @Test
    void runsBeginAtTheseMomentsInTurn() throws IOException {
        SceneSettings scene = scene(RADAR, 160);
        try (Workers workers = new Workers(2)) {
            RouteProof proof = workers.call(() -> RouteProof.of(scene, models(scene), 161, done -> {}));

            assertThat(proof.predicted() * 161).isCloseTo(proof.detections().count(), within(1e-3));
            assertThat(proof.detections().of()).isEqualTo(161);
            assertThat(proof.plain()).isEqualTo(8);
        }
    }

    /** Before it begins, the drone waits in range: what the radar sees then is not on the route. */
    @Test
    void whatIsSeenBeforeTheRouteStartsDoesNotCount() throws IOException {
        FlownRoute flown = flown(scene(RADAR, 60));

        assertThat(flown.detection()).isCloseTo(1.0 / SPEED * 20 / 5, within(1.0 / RouteStarts.MOST));
    }

    /** A camera sees the drone wait: in a run, its observer has longer to search than one whom the route surprises. */
    @Test
    void observersSearchForTheDroneWhileItWaits() throws IOException {
        String observer =
                """
                  slow: {kind: radar, position: [400, 400, 4], rate: 0.1, minRange: 1, maxRange: 5, elevationWidth: 90 deg,
                    minSpeed: 0 m/s, budget: {range: 5, crossSection: 0.01}}
                  watched: {kind: camera, position: [0, 0, 4], fov: 60 deg, width: 640, height: 480, rate: 2,
                    aim: {azimuth: 45 deg, elevation: 20 deg}, detection: {kind: target-task, task: detection, byChance: true}}
                """;
        FieldSite site = FieldSite.in(directory, observer);
        RouteLeg leg = new RouteLeg(new Position(60, 90, 50), Optional.of(10.0), true);
        FlownRoute flown = flown(RouteScene.of(
                site.settings(), FieldSite.DRONE, RouteFlight.of(new Position(60, 60, 50), List.of(leg))));
        RouteProof proof = flown.prove(400, done -> {});

        assertThat(proof.predicted()).isGreaterThan(1.2 * flown.detection());
        assertThat(proof.agrees()).as("%s", proof).isTrue();
    }

    /** The round of a camera that detects nothing takes a multiple of the radar's scans, such as the eight moments. */
    @Test
    void aLongerPeriodDoesNotFixThePhaseOfAShorterOne() throws IOException {
        for (int scans : new int[] {2, 3, 8, 16, 24}) {
            String round =
                    """
                      round: {kind: camera, position: [300, 300, 4], fov: 5 deg, width: 320, height: 240, rate: 5,
                        detection: {kind: target-task, task: identification}, positioner: {search: {kind: round, speed: %s deg/s}}}
                    """
                            .formatted(360.0 / (5 * scans));
            SceneSettings scene = scene(RADAR + round, 140);

            assertThat(RouteStarts.slowest(scene.enabledSensors())).contains("round");
            assertThat(flown(scene).detection()).as("%d scans", scans).isCloseTo(0.4, within(2.0 / RouteStarts.MOST));
        }
    }

    /** Sound takes a second over 340 m: what is heard in the first second of the route left the drone before. */
    @Test
    void soundOfTheDroneWhileItWaitsDoesNotCount() throws IOException {
        FieldSite site = FieldSite.in(
                directory,
                "  ear: {kind: acoustic, position: [0, 0, 100], rate: 4, propagation: {kind: energy-model, rays: 1}}\n");
        RouteLeg leg = new RouteLeg(new Position(0, 380, 100), Optional.of(SPEED), true);
        SceneSettings scene = RouteScene.of(
                site.settings(), FieldSite.DRONE, RouteFlight.of(new Position(0, 340, 100), List.of(leg)));
        for (double begin : new double[] {0.0, 2.5}) {
            SceneSettings later = RouteScene.later(scene, begin);
            Stage stage = new Stage(later, models(later), 1);
            assertThat(LookSchedule.of(later, stage, 1).looks().get(0).time()).isBetween(begin + 0.95, begin + 1.25);
        }
    }

    @Test
    void unevennessIsTheDiscrepancyOnTheCircle() {
        List<Double> even = IntStream.range(0, 8).mapToObj(i -> i * 5.0 / 8.0).toList();

        assertThat(RouteStarts.unevenness(even, 5.0)).isCloseTo(1.0 / 8.0, within(1e-12));
        // Twice round, two at each of four phases; eight times round, all at one.
        assertThat(RouteStarts.unevenness(even, 2.5)).isCloseTo(1.0 / 4.0, within(1e-12));
        assertThat(RouteStarts.unevenness(even, 5.0 / 8.0)).isCloseTo(1.0, within(1e-12));
    }

    @Test
    void spreadsThemOverTheLongestPeriod() throws IOException {
        String fast = RADAR.replace("rate: 0.2", "rate: 4");
        SceneSettings often = scene(fast, 160);
        SceneSettings both = scene(fast.replace("slow", "fast") + RADAR, 160);

        SceneSettings always = scene(RADAR.replace("rate: 0.2", "rate: 10"), 160);

        assertThat(RouteStarts.of(always.enabledSensors().values())).containsExactly(0.0);
        assertThat(RouteStarts.slowest(always.enabledSensors())).isEmpty();
        assertThat(RouteStarts.of(often.enabledSensors().values())).containsExactly(0.0, 0.0625, 0.125, 0.1875);
        assertThat(RouteStarts.slowest(often.enabledSensors())).contains("slow");
        // Of the slow periods there is one only.
        assertThat(RouteStarts.of(both.enabledSensors().values()))
                .containsExactly(0.0, 0.625, 1.25, 1.875, 2.5, 3.125, 3.75, 4.375);
        assertThat(RouteStarts.slowest(both.enabledSensors())).contains("slow");
    }
}
