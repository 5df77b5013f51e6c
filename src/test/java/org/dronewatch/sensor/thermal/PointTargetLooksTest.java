package org.dronewatch.sensor.thermal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.dronewatch.Wilson;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.HeatSignature;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.Discrimination;
import org.dronewatch.sensor.Draws;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Walls;
import org.dronewatch.sensor.alarm.FalseAlarmRate;
import org.dronewatch.sensor.alarm.FalseAlarms;
import org.dronewatch.world.Light;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A thermal camera whose program finds drones as spots. */
class PointTargetLooksTest {
    /** A quadrotor's area from the front, m2, as that of a square plate. */
    private static final double QUADROTOR = 0.0528;

    /** 8,454 false alarms an hour in single frames: at 25 Hz, a threshold of 5. */
    private static final PointTargets FIVE_SIGMA = new PointTargets(8454.0, 1, 1, 1, 25.0);

    private static final ThermalSettings CAMERA = ThermalSettings.at(new Position(0, 0, 0));
    private static final ThermalSettings BY_CHANCE = CAMERA.withChance(true);

    private static Drone at(double range) {
        float half = (float) (0.5 * Math.sqrt(QUADROTOR));
        TriangleMesh plate = new TriangleMesh(
                new float[] {-half, 0, -half, half, 0, -half, half, 0, half, -half, 0, half},
                new int[] {0, 1, 2, 0, 2, 3},
                new int[2],
                new int[] {0, 1},
                List.of("plate"));
        DroneSettings settings = DroneSettings.of(ModelSettings.of("plate.obj"), Hover.at(new Position(0, range, 0)))
                .withHeat(HeatSignature.DEFAULT.withExcess(5.0));
        return new Drone("drone", settings, KDTree.of(plate))
                .at(new FlightState(new Position(0, range, 0), new Position(0, 0, 0), 0.0));
    }

    private static Observation look(ThermalSettings settings, World world, Drone drone, long seed, long index) {
        return settings.create()
                .observe(world, List.of(drone), Look.of(seed, "heat", index, index / settings.rate()))
                .get(0);
    }

    /**
     * 5 K, 0.85 a kilometre, 50 mK, 0.0528 m2, 24 degrees over 640 pixels: SNR 5 at 1383 m, where t = 5 is an even
     * chance.
     */
    @Test
    void aQuadrotorIsASpotAtWellOverAKilometre() {
        Observation seen = look(CAMERA.withPointTargets(FIVE_SIGMA), Walls.open(), at(1383), 1, 100);

        assertThat(seen.figures().get("signal_to_noise")).isCloseTo(5.0, within(0.1));
        assertThat(seen.figures().get("snr_threshold")).isCloseTo(5.0, within(1e-4));
        assertThat(seen.probability()).isCloseTo(0.5, within(0.04));
        assertThat(seen.figures().get("pixels")).isCloseTo(0.0626, within(0.002));
        // By Johnson's criteria, a spot is nothing.
        assertThat(look(CAMERA, Walls.open(), at(1383), 1, 100).probability()).isLessThan(0.01);
    }

    @ParameterizedTest
    @CsvSource({"1, 1, 1150", "1, 1, 1383", "3, 5, 1700", "3, 5, 1850", "5, 5, 1850"})
    void looksDetectAsOftenAsTheFormulaStates(int hits, int frames, double range) {
        ThermalSettings settings = BY_CHANCE.withPointTargets(new PointTargets(8454.0, hits, frames, 1, 25.0));
        World world = Walls.open();
        Drone drone = at(range);
        Assessment one = Walls.assess(settings, world, drone);
        ThermalSensor sensor = settings.create();
        int count = 4000;
        int detected = 0;
        for (int i = 0; i < count; i++) {
            Look look = Look.of(Draws.mix(11, i), "heat", 40, 1.6);
            detected += sensor.observe(world, List.of(drone), look).get(0).isDetected() ? 1 : 0;
        }
        double[] interval = Wilson.interval(detected, count, 3.9);

        assertThat(one.probability()).as("seed 11, %d of %d", detected, count).isBetween(interval[0], interval[1]);
        assertThat(one.probability()).isBetween(0.02, 0.999);
    }

    /** Five frames between two looks: any of them may confirm the drone. */
    @ParameterizedTest
    @CsvSource({"1, 1, 1500", "3, 5, 1900", "5, 5, 1850", "8, 10, 1950"})
    void looksThatSpanFramesDetectAsOftenAsTheirSequences(int hits, int frames, double range) {
        PointTargets rule = new PointTargets(8454.0, hits, frames, 1, 25.0);
        ThermalSettings settings = BY_CHANCE.withRate(5.0).withPointTargets(rule);
        World world = Walls.open();
        Drone drone = at(range);
        Assessment one = Walls.assess(settings, world, drone);
        ThermalSensor sensor = settings.create();
        int count = 4000;
        int detected = 0;
        for (int i = 0; i < count; i++) {
            Look look = Look.of(Draws.mix(12, i), "heat", 8, 1.6);
            Observation seen = sensor.observe(world, List.of(drone), look).get(0);
            assertThat(seen.probability()).isEqualTo(one.probability());
            detected += seen.isDetected() ? 1 : 0;
        }
        double[] interval = Wilson.interval(detected, count, 3.9);

        assertThat(one.probability()).as("seed 12, %d of %d", detected, count).isBetween(interval[0], interval[1]);
        // More often than if a look were a frame.
        assertThat(one.probability())
                .isBetween(0.1, 0.95)
                .isGreaterThan(1.1
                        * Walls.assess(settings.withRate(25.0), world, drone).probability());
    }

    /** Frame by frame: which marks a program sees, and when it has seen three in five frames. */
    @Test
    void aDetectionIsThreeMarksInFiveFrames() {
        PointTargets rule = PointTargets.DEFAULT;
        ThermalSettings settings = BY_CHANCE.withPointTargets(rule);
        World world = Walls.open();
        Drone drone = at(1540);
        ThermalSensor sensor = settings.create();
        ThermalSensor single = BY_CHANCE
                .withPointTargets(new PointTargets(singleRate(rule, settings), 1, 1, 1, 25.0))
                .create();
        List<Boolean> marks = new ArrayList<>();
        int detections = 0;
        for (int index = 0; index < 2000; index++) {
            Look look = Look.of(20261124, "heat", index, index / settings.rate());
            marks.add(single.observe(world, List.of(drone), look).get(0).isDetected());
            int last = Collections.frequency(marks.subList(Math.max(0, index - 4), index + 1), true);
            boolean detected =
                    sensor.observe(world, List.of(drone), look).get(0).isDetected();
            assertThat(detected).as("seed 20261124, frame %d", index).isEqualTo(last >= 3);
            detections += detected ? 1 : 0;
        }
        assertThat(detections).isBetween(500, 1500);
    }

    /** The false alarms of single frames with the threshold of another rule. */
    private static double singleRate(PointTargets rule, ThermalSettings settings) {
        double threshold = rule.threshold(settings.pixels());
        return new PointTargets(1.0, 1, 1, 1, 25.0).falseAlarmsPerHour(threshold, settings.pixels());
    }

    /** A billion sigmas do not help before three frames have been taken. */
    @Test
    void noDetectionBeforeEnoughFrames() {
        ThermalSettings settings = BY_CHANCE.withPointTargets(PointTargets.DEFAULT);

        assertThat(look(settings, Walls.open(), at(50), 1, 1).isDetected()).isFalse();
        assertThat(look(settings, Walls.open(), at(50), 1, 2).isDetected()).isTrue();
    }

    /**
     * The range of an even chance by three of five frames, which the page states: a higher frame rate raises the
     * threshold.
     */
    @ParameterizedTest
    @CsvSource({"5, 3.807, 1562", "25, 3.937, 1539", "50, 3.993, 1530"})
    void theRangeOfAnEvenChanceShrinksWithTheFrameRate(double rate, double stated, double range) {
        PointTargets rule = PointTargets.DEFAULT.withFrameRate(rate);
        ThermalSettings settings = CAMERA.withPointTargets(rule);
        double low = 500;
        double high = 3000;
        while (high - low > 0.5) {
            double middle = 0.5 * (low + high);
            if (Walls.assess(settings, Walls.open(), at(middle)).probability() >= 0.5) {
                low = middle;
            } else {
                high = middle;
            }
        }
        double threshold = rule.threshold(settings.pixels());
        double focal = settings.focalLength();
        double ratio = 100 * Math.pow(0.85, low / 1000) * QUADROTOR * focal * focal / (low * low);

        assertThat(threshold).isCloseTo(stated, within(0.001));
        assertThat(low).isCloseTo(range, within(2.0));
        // Three of five are an even chance where one is: where the ratio is the threshold.
        assertThat(ratio).isCloseTo(threshold, within(0.03 * threshold));
    }

    @Test
    void noiseDoesNotShowWhatIsHidden() {
        ThermalSettings settings = CAMERA.withPointTargets(PointTargets.DEFAULT.withFalseAlarmsPerHour(1e7));
        World world = Walls.behind(Walls.wall(50, -99, 99), ModelRole.BUILDING);
        Assessment hidden = Walls.assess(settings, world, at(600));

        assertThat(hidden.probability()).isZero();
        assertThat(hidden.cause()).isEqualTo(Cause.HIDDEN_BY_BUILDING);
        assertThat(Walls.assess(settings, Walls.open(), at(600)).cause()).isEqualTo(Cause.DETECTED);
        assertThat(Walls.assess(CAMERA.withPointTargets(PointTargets.DEFAULT), Walls.open(), at(2500))
                        .cause())
                .isEqualTo(Cause.TOO_WEAK);
    }

    /** 76 mm at 4 um over pixels of 49 urad: the pixel in the middle receives less than half of a spot's heat. */
    @Test
    void blurSpreadsASpot() {
        ThermalSettings tele = CAMERA.withHorizontalFov(Math.toRadians(1.8)).withPointTargets(PointTargets.DEFAULT);
        Drone far = at(9000);
        double sharp = look(tele, Walls.open(), far, 1, 100).figures().get("signal_to_noise");
        double diffracted = look(tele.withAperture(0.076), Walls.open(), far, 1, 100)
                .figures()
                .get("signal_to_noise");
        World turbulent = Walls.open().withLight(Light.DAY.withCn2(1e-14));
        double blurred =
                look(tele.withAperture(0.076), turbulent, far, 1, 100).figures().get("signal_to_noise");

        assertThat(diffracted / sharp).isBetween(0.35, 0.5);
        assertThat(blurred / diffracted).isBetween(0.5, 0.95);
    }

    /** Detail is lost to the lens and the air as for cameras of light, at a longer wavelength. */
    @Test
    void blurCostsAnObserverDetail() {
        ThermalSettings tele = CAMERA.withHorizontalFov(Math.toRadians(1.8)).withTask(Discrimination.RECOGNITION);
        Drone drone = at(500);
        double sharp = look(tele, Walls.open(), drone, 1, 100).probability();
        double diffracted =
                look(tele.withAperture(0.076), Walls.open(), drone, 1, 100).probability();
        World turbulent = Walls.open().withLight(Light.DAY.withCn2(1e-12));

        assertThat(diffracted).isLessThan(0.99 * sharp);
        assertThat(look(tele.withAperture(0.076), turbulent, drone, 1, 100).probability())
                .isLessThan(0.9 * diffracted);
        assertThat(look(tele, Walls.open().withLight(Light.DAY), drone, 1, 100).probability())
                .isEqualTo(sharp);
    }

    @Test
    void aSpotIsDetectedButNotRecognised() {
        ThermalSettings settings = CAMERA.withPointTargets(PointTargets.DEFAULT);

        assertThatThrownBy(() -> settings.withTask(Discrimination.RECOGNITION))
                .hasMessage(
                        "task recognition with pointTargets: a spot can be detected, but has no shape by which it could"
                                + " be recognised");
        assertThat(settings.withChance(true).chance()).isEqualTo(Chance.PER_LOOK);
        assertThat(BY_CHANCE.chance()).isEqualTo(Chance.PER_ENCOUNTER);
    }

    /** One notion of a rate: what noise is allowed to cause is what a run raises and an alert rule is priced by. */
    @Test
    void theAcceptedFalseAlarmsAreItsRate() {
        ThermalSettings settings = CAMERA.withPointTargets(PointTargets.DEFAULT.withFalseAlarmsPerHour(40.0));
        FalseAlarmRate rate = settings.falseAlarmRate().orElseThrow();

        assertThat(rate.perHour()).isCloseTo(40.0, within(1e-6));
        assertThat(rate.cells()).isEqualTo(640 * 512 / 9);
        assertThat(rate.looks()).isEqualTo(3);
        // Three frames are less than a look at 5 Hz, and six looks at 50 Hz.
        assertThat(settings.withRate(5.0).falseAlarmRate().orElseThrow().looks())
                .isOne();
        assertThat(settings.withRate(50.0).falseAlarmRate().orElseThrow().looks())
                .isEqualTo(6);
        assertThat(settings.withRate(5.0).falseAlarmRate().orElseThrow().perHour())
                .isCloseTo(40.0, within(1e-6));
        assertThatThrownBy(() -> settings.withRate(0.02))
                .hasMessage("pointTargets.frameRate 25 Hz with a rate of 0.02 Hz must be at most 20 Hz: 1000 frames"
                        + " in a look");
        FalseAlarms counted = new FalseAlarms(70.0, 5, 1.0);
        assertThat(settings.withFalseAlarms(counted).falseAlarmRate()).contains(counted.rate(25));
        assertThat(CAMERA.falseAlarmRate()).isEmpty();
        assertThatThrownBy(() -> CAMERA.withPointTargets(PointTargets.DEFAULT.withFalseAlarmsPerHour(1e9)))
                .hasMessage("pointTargets.falseAlarmsPerHour 1e9 at 25 looks a second must be at most 3e7: 1000 at the"
                        + " same time");
        assertThat(CAMERA.withFalseAlarms(counted)
                        .withPointTargets(PointTargets.DEFAULT.withFalseAlarmsPerHour(1e9))
                        .falseAlarmRate())
                .contains(counted.rate(25));
    }
}
