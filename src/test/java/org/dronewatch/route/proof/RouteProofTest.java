package org.dronewatch.route.proof;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.SplittableRandom;
import org.apache.commons.numbers.gamma.Erfc;
import org.dronewatch.LongForm;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightState;
import org.dronewatch.flight.RouteFlight;
import org.dronewatch.flight.RouteLeg;
import org.dronewatch.fusion.AlertRule;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.fusion.ProtectedZone;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.route.FlownExposure;
import org.dronewatch.route.ResponseTime;
import org.dronewatch.route.search.RouteMode;
import org.dronewatch.route.search.RoutePath;
import org.dronewatch.run.RunSession;
import org.dronewatch.run.Stage;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.Draws;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.setting.SettingsForm;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Random flights among four boxes, past sensors whose looks are left to chance in every way that the library has:
 * fluctuating echoes, rays, observers on fixed and on searching mounts. Over many runs, the
 * predictions lie in the 99 % intervals.
 */
class RouteProofTest {
    private static final String SENSORS =
            """
              fluctuating: {kind: radar, position: [-60, 40, 6], minRange: 1, maxRange: 400, elevationWidth: 90 deg, rate: 1,
                budget: {range: 60, crossSection: 0.01}, minSpeed: 3 m/s, detection: {kind: chance, pulses: 8}}
              notched: {kind: radar, position: [60, -40, 6], minRange: 1, maxRange: 400, elevationWidth: 90 deg, rate: 0.7,
                budget: {range: 85, crossSection: 0.01}, notch: {kind: high-pass, halfPowerSpeed: 4 m/s},
                detection: {kind: chance, pulses: 8}}
              watched: {kind: camera, position: [0, 0, 4], fov: 60 deg, width: 640, height: 480, rate: 1,
                aim: {azimuth: 20 deg, elevation: 10 deg}, detection: {kind: target-task, task: detection, byChance: true}}
              searching: {kind: camera, position: [30, 30, 4], fov: 20 deg, width: 640, height: 480, rate: 2,
                detection: {kind: target-task, task: detection, byChance: true}, aim: {azimuth: 60 deg, elevation: 12 deg},
                positioner: {cues: [fluctuating], search: {kind: sweep, width: 200 deg, speed: 60 deg/s}}}
              heat: {kind: thermal, position: [-30, -30, 4], fov: 40 deg, rate: 2, aim: {azimuth: 90 deg, elevation: 10 deg}, byChance: true}
              ear: {kind: acoustic, position: [0, 56, 2], rate: 0.3, propagation: {kind: level-model, initialRays: 6, reflectionsPerHit: 1, maxOrder: 1}}
            """;

    private static final int FLIGHTS = LongForm.count(7, 210);
    private static final int RUNS = LongForm.count(60, 1000);

    @TempDir
    private Path directory;

    private FieldSite site;
    private ModelCache models;

    @BeforeEach
    void load() throws IOException {
        site = FieldSite.in(directory, SENSORS);
        models = new SceneRunner(new SceneFile(directory.resolve("site.yaml"))).load(site.settings());
    }

    private static Position anywhere(SplittableRandom random) {
        return new Position(
                300 * (random.nextDouble() - 0.5), 300 * (random.nextDouble() - 0.5), 35 + 40 * random.nextDouble());
    }

    private SceneSettings randomFlight(SplittableRandom random) {
        List<RouteLeg> legs = new ArrayList<>();
        for (int leg = 0; leg < 3; leg++) {
            legs.add(new RouteLeg(anywhere(random), Optional.of(6.0 + 10.0 * random.nextDouble()), true));
        }
        return RouteScene.of(site.settings(), FieldSite.DRONE, RouteFlight.of(anywhere(random), legs));
    }

    /** Flights with seeds of their own differ from their predictions independently of each other. */
    private static SceneSettings withSeed(SceneSettings scene, long seed) {
        return SettingsForm.with(scene, "run", scene.run().withSeed(seed));
    }

    private RouteProof proof(SceneSettings scene, int runs) {
        try (Workers workers = new Workers(2)) {
            return workers.call(() -> RouteProof.of(scene, models, runs, done -> {}));
        }
    }

    /**
     * On every flight, one of the sensors is alone, in turn, or none. For an alert, a sensor must detect the drone
     * once, or in two of three looks.
     */
    @Test
    void runsDetectAsOftenAsPredicted() {
        // The short form has a fixed seed: by chance, one in a hundred lies outside.
        long seed = LongForm.seed(11);
        System.out.println("RouteProofTest: seed " + seed);
        SplittableRandom random = new SplittableRandom(seed);
        List<String> sensors = List.copyOf(site.settings().sensors().keySet());
        int outside = 0;
        int undecided = 0;
        int alerts = 0;
        for (int flight = 0; flight < FLIGHTS; flight++) {
            SceneSettings scene = withSeed(randomFlight(random), Draws.derivedSeed(seed, "flight", flight));
            int alone = flight % (sensors.size() + 1);
            for (int other = 0; alone < sensors.size() && other < sensors.size(); other++) {
                scene = scene.withEnabled(sensors.get(other), other == alone);
            }
            AlertSettings alert = scene.alert()
                    .withProtectedZone(ProtectedZone.at(new Position(0, 0, 0)), 6.0)
                    .withConfirmation(1 + flight % 2, 1 + 2 * (flight % 2));
            RouteProof proof = proof(SettingsForm.with(scene, "alert", alert), RUNS);
            outside += proof.agrees() ? 0 : 1;
            undecided += proof.predicted() > 0.02 && proof.predicted() < 0.98 ? 1 : 0;
            alerts += proof.alertInTime()
                            .filter(one -> one.predicted() > 0.02 && one.predicted() < 0.98)
                            .isPresent()
                    ? 1
                    : 0;
        }
        System.out.printf(
                "RouteProofTest: %d flights, %d of them left to chance, and %d alerts, %d outside%n",
                FLIGHTS, undecided, alerts, outside);
        assertThat(alerts).isPositive();
        assertThat(undecided).isGreaterThanOrEqualTo(FLIGHTS / 7);
        assertThat(outside).as("outside, seed %d", seed).isLessThanOrEqualTo(FLIGHTS * 3 / 100);
    }

    /** Levels of few rays scatter: near the threshold, a run hears what another does not, and so do its looks alone. */
    @Test
    void levelsNearTheThresholdAreLeftToTheRays(@TempDir Path other) throws IOException {
        site = FieldSite.in(
                other,
                "  ear: {kind: acoustic, position: [0, 0, 4], rate: 2, propagation: {kind: energy-model, rays: 100}}\n");
        models = new SceneRunner(new SceneFile(other.resolve("site.yaml"))).load(site.settings());
        AcousticSettings ear =
                (AcousticSettings) site.settings().enabledSensors().get("ear");
        Assessor assessor = new Assessor("ear", ear, site.stage().world());
        SplittableRandom random = new SplittableRandom(12);
        int flights = LongForm.count(5, 100);
        int outside = 0;
        int undecided = 0;
        for (int flight = 0; flight < flights; flight++) {
            Position at = anywhere(random);
            Drone there = site.stage().dronesAt(0.0).get(0).at(new FlightState(at, new Position(0.0, 0.0, 0.0), 0.0));
            double margin =
                    assessor.assess(there, Optional.empty(), new Random(flight)).margin();
            RouteLeg hop = new RouteLeg(at.plus(new Position(0.1, 0.0, 0.0)), Optional.of(0.2), true);
            SceneSettings scene = RouteScene.of(
                            withSeed(site.settings(), flight), FieldSite.DRONE, RouteFlight.of(at, List.of(hop)))
                    .withSensor("ear", SettingsForm.with(ear, "threshold", ear.threshold() + margin));
            RouteProof proof = proof(scene, 60);
            outside += proof.agrees() ? 0 : 1;
            undecided += proof.predicted() > 0.02 && proof.predicted() < 0.98 ? 1 : 0;
        }
        System.out.printf(
                "RouteProofTest: %d levels, %d of them near the threshold, %d outside%n", flights, undecided, outside);
        assertThat(undecided).isPositive();
        assertThat(outside).isLessThanOrEqualTo(flights * 3 / 100);
    }

    /** Of all looks, those of observers among them, at any time, by sensor, and at its end. */
    @Test
    void exposureIsThatOfTheLooks() {
        SceneSettings scene = RouteScene.withoutCues(randomFlight(new SplittableRandom(8)));
        FlownRoute flown = FlownRoute.of(scene, models);
        List<Double> begins = RouteStarts.of(scene.enabledSensors().values());
        List<LookSchedule> looks = begins.stream()
                .map(begin -> RouteScene.later(scene, begin))
                .map(later -> LookSchedule.of(
                        later, new Stage(later, models, later.run().seed()), 2))
                .toList();
        FlownExposure exposure = flown.exposure();

        assertThat(begins).hasSize(RouteStarts.MOST);
        for (double time : new double[] {3.0, 10.0, 17.5, 1000.0}) {
            double missed = looks.stream()
                    .mapToDouble(one -> one.missed(one.begin() + time, MissedLooks.Wait.UNSEEN))
                    .average()
                    .orElseThrow();
            assertThat(exposure.detection(time)).isCloseTo(1.0 - missed, within(1e-5));
        }
        exposure.bySensor().forEach((sensor, sum) -> assertThat(-Math.expm1(-sum))
                .as(sensor)
                .isCloseTo(flown.bySensor().get(sensor), within(1e-5)));
        double median = exposure.medianDetection().orElseThrow();
        double half = 0.5 * flown.detection();
        assertThat(exposure.detection(median)).isGreaterThanOrEqualTo(half - 1e-5);
        assertThat(exposure.detection(Math.nextDown(median))).isLessThan(half);
    }

    @Test
    void theSameForAnyNumberOfThreads() {
        SceneSettings scene = randomFlight(new SplittableRandom(3));
        RouteProof two = proof(scene, 30);
        RouteProof alone = RouteProof.of(scene, models, 30, done -> {});

        assertThat(alone).isEqualTo(two);
        assertThat(two.plain()).isEqualTo(2);
    }

    /** What a fixed radar does is not changed by cues, and a camera that is cued to the drone sees it longer. */
    @Test
    void cuesMakeADifferenceToWhatIsOnAPositioner() {
        SceneSettings all = randomFlight(new SplittableRandom(5));
        SceneSettings fixed = all.withEnabled("searching", false);

        assertThat(RouteProof.hasCues(fixed)).isFalse();
        assertThat(RouteProof.hasCues(all)).isTrue();
        assertThat(RouteProof.withCues(fixed, models, 20, done -> {}))
                .isEqualTo(proof(fixed, 20).detections());
    }

    /** The probability of an alert in time on a flight that begins at once. */
    private double alertInTime(SceneSettings scene, double response) {
        Stage stage = new Stage(scene, models, scene.run().seed());
        return AlertChances.of(LookSchedule.of(scene, stage, 1), scene.alert(), MissedLooks.Wait.UNSEEN)
                .orElseThrow()
                .inTime(scene.run().duration(), new ResponseTime(response, FlownRoute.SPREAD * response));
    }

    @Test
    void theChanceOfAnAlertIsTheMeanOfAllMoments() {
        SceneSettings scene =
                RouteScene.withoutCues(randomFlight(new SplittableRandom(9))).withEnabled("ear", false);
        List<Double> begins = RouteStarts.of(scene.enabledSensors().values());
        double mean = begins.stream()
                .mapToDouble(begin -> alertInTime(RouteScene.later(scene, begin), 6.0))
                .average()
                .orElseThrow();

        assertThat(begins).hasSize(RouteStarts.MOST);
        assertThat(mean).isPositive();
        assertThat(FlownRoute.of(scene, models).interruption(6.0).orElseThrow()).isCloseTo(mean, within(1e-12));
    }

    /** Two radars, of which each must detect the drone in two of three looks: alerts of plain runs, and their time. */
    @Test
    void alertsAreRaisedAndInTimeAsOftenAsPredicted() {
        double response = 6.0;
        SplittableRandom random = new SplittableRandom(4);
        int runs = LongForm.count(40, 2000);
        int undecided = 0;
        while (undecided < 2) {
            SceneSettings scene = randomFlight(random);
            for (String other : List.of("watched", "searching", "heat", "ear")) {
                scene = scene.withEnabled(other, false);
            }
            scene = SettingsForm.with(scene, "alert", scene.alert().withConfirmation(2, 3));
            double predicted = alertInTime(scene, response);
            if (predicted < 0.1 || predicted > 0.9) {
                continue;
            }
            undecided++;
            double sum = 0.0;
            double squares = 0.0;
            for (int run = 0; run < runs; run++) {
                OptionalDouble alert = RunSession.run(scene, RouteProof.seed(scene, run), models)
                        .alerts()
                        .get(0)
                        .time();
                double left = alert.isPresent() ? scene.run().duration() - alert.getAsDouble() : 0.0;
                double spread = FlownRoute.SPREAD * Math.hypot(left, response);
                double inTime =
                        alert.isPresent() ? 1.0 - 0.5 * Erfc.value((left - response) / spread / Math.sqrt(2)) : 0.0;
                sum += inTime;
                squares += inTime * inTime;
            }
            double mean = sum / runs;
            double error = Math.sqrt((squares / runs - mean * mean) / runs);
            assertThat(predicted).isCloseTo(mean, within(4.0 * error));
        }
    }

    @Test
    void saysWhereAnAlertCannotBeComputed() {
        SceneSettings observers = randomFlight(new SplittableRandom(6));
        SceneSettings twice =
                SettingsForm.with(observers, "alert", observers.alert().withConfirmation(2, 3));
        SceneSettings two =
                SettingsForm.with(observers, "alert", observers.alert().withRule(AlertRule.SeveralSensors.of(2)));

        FlownRoute any = FlownRoute.of(observers, models);
        assertThat(any.interruption(5.0)).isPresent();
        assertThat(FlownRoute.of(twice, models).interruption(5.0)).isEmpty();
        assertThat(FlownRoute.of(two, models).interruption(5.0)).isEmpty();
    }

    @Test
    void aFlightIsThatOfTheSearch() {
        RouteMode powered = new RouteMode("powered", 12.0, 3.0, 1.5, Double.POSITIVE_INFINITY);
        RouteMode glide = new RouteMode("glide", 10.0, 99.0, 99.0, -0.1);
        RoutePath path = new RoutePath(
                List.of(
                        new Position(0, 0, 50),
                        new Position(0, 120, 50),
                        new Position(0, 120, 80),
                        new Position(0, 420, 20)),
                List.of(0, 0, 1));
        RouteFlight flight = path.flight(List.of(powered, glide)).orElseThrow();

        double gliding = Math.hypot(300, 60) / 10.0;
        assertThat(flight.duration(99.0)).isCloseTo(10.0 + 30.0 / 3.0 + gliding, within(1e-9));
        assertThat(flight.legs().get(1).speed().orElseThrow()).isCloseTo(3.0, within(1e-12));
        assertThat(flight.legs().get(2).powered()).isFalse();
        assertThat(new RoutePath(List.of(new Position(0, 0, 0)), List.of()).flight(List.of(powered)))
                .isEmpty();
    }

    /** Rounding errors of the search are not written into scene files, and the legs take as long as in the search. */
    @Test
    void aFlightHasShortDecimals() {
        RouteMode powered = new RouteMode("powered", 15.0, 3.0, 1.5, Double.POSITIVE_INFINITY);
        RoutePath path = new RoutePath(
                List.of(
                        new Position(549.4499999999999, -105.44999999999993, 0.1 + 0.2),
                        new Position(100.0 / 3.0, 7.0, 0.3),
                        new Position(30.0, 7.0, 20.0 / 3.0)),
                List.of(0, 0));
        RouteFlight flight = path.flight(List.of(powered)).orElseThrow();

        assertThat(flight.from()).isEqualTo(new Position(549.45, -105.45, 0.3));
        assertThat(flight.legs())
                .extracting(RouteLeg::to)
                .containsExactly(new Position(33.333333, 7.0, 0.3), new Position(30.0, 7.0, 6.666667));
        assertThat(flight.legs().get(0).speed()).hasValue(15.0);
        assertThat(flight.legs().get(1).speed().orElseThrow())
                .isCloseTo(3.0 * Math.hypot(1.0, 3.3333333 / 6.3666667), within(1e-6));
        assertThat(Double.toString(flight.legs().get(1).speed().orElseThrow())).hasSizeLessThanOrEqualTo(11);
        double time = path.points().get(0).distance(path.points().get(1)) / 15.0 + (20.0 / 3.0 - 0.3) / 3.0;
        assertThat(flight.duration(99.0)).isCloseTo(time, within(1e-6));
    }
}
