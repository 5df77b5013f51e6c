package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.Wilson;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.HeatSignature;
import org.dronewatch.flight.FlightPathSettings.Approach;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.PairResult;
import org.dronewatch.run.SceneResult;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.thermal.ThermalSettings;
import org.dronewatch.setting.SettingsForm;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Whole runs in which an observer watches a thermal camera, against what its assessments predict without any draw. */
class ObserverRunsTest {
    private static final int DRONES = 300;
    private static final double SPEED = 30.0;
    private static final double START = 420.0;
    private static final double END = 45.0;
    private static final double MIDDLE = 150.0;
    private static final int DRAWS = 64;

    /** Many drones of one path: a thermal camera sees each of them as if it were alone. */
    private static final class Approaching extends FloorScene {
        private static final long serialVersionUID = 1L;

        private final double rate;

        Approaching(double rate) {
            this.rate = rate;
        }

        @Override
        protected void build() {
            loadFloor();
            DroneSettings drone = DroneSettings.of(
                            load("plate.obj"), new Approach(new Position(0, START, 30), new Position(0, END, 30)))
                    .withSpeed(SPEED)
                    .withHeat(HeatSignature.DEFAULT.withExcess(5.0));
            for (int i = 0; i < DRONES; i++) {
                add("drone-" + i, drone);
            }
            add(
                    "heat",
                    // The middle of the default image, so that it is drawn quickly: as many pixels on the drone.
                    SettingsForm.with(
                                    ThermalSettings.at(new Position(0, 0, 30))
                                            .withHorizontalFov(
                                                    2.0 * Math.atan(Math.tan(0.5 * Math.toRadians(24)) / 16.0)),
                                    Map.of("width", 40, "height", 32))
                            .withChance(true)
                            .withRate(rate));
            setRun(RunSettings.DEFAULT.withDuration((START - END) / SPEED));
        }
    }

    /**
     * The fraction of observers who have found the drone by a range: the mean over draws of what their hazards add up
     * to.
     */
    private double predicted(double rate, double range) {
        Approaching scene = new Approaching(rate);
        SceneSettings settings = scene.describe();
        Stage stage = new SceneRunner(scene).stage(settings);
        SensorSettings<?> camera = settings.sensors().get("heat");
        Assessor assessor = new Assessor("heat", camera, stage.world());
        double[] searched = new double[DRAWS];
        for (int look = 1; START - SPEED * look / rate >= range - 1e-9; look++) {
            Drone drone = stage.dronesAt(look / rate).get(0);
            Assessment one = assessor.assess(drone, Optional.empty(), new SplittableRandom(1));
            for (int i = 0; i < DRAWS; i++) {
                searched[i] += one.hazard(camera, (i + 0.5) / DRAWS) / rate;
            }
        }
        double found = 0.0;
        for (double sum : searched) {
            found -= Math.expm1(-sum) / DRAWS;
        }
        return found;
    }

    static DoubleStream rates() {
        return LongForm.IS_ON ? DoubleStream.of(5, 25, 50) : DoubleStream.of(5, 25);
    }

    @Thorough
    @ParameterizedTest
    @MethodSource("rates")
    void asManyAreFoundAsPredictedWhateverTheFrameRate(double rate) {
        SceneResult result = new SceneRunner(new Approaching(rate)).seed(11).run();

        for (double range : new double[] {MIDDLE, END}) {
            int found =
                    (int) ranges(result).filter(first -> first >= range - 1e-6).count();
            double expected = predicted(5.0, range);
            assertThat(expected).isBetween(0.05, 0.9);
            System.out.printf(
                    "seed 11, %.0f Hz, by %.0f m: %d of %d, expected %.3f (by its own rate %.3f)%n",
                    rate, range, found, DRONES, expected, predicted(rate, range));
            double[] interval = Wilson.interval(found, DRONES, 3.3);
            assertThat(expected).isBetween(interval[0], interval[1]);
            assertThat(predicted(rate, range)).isBetween(interval[0], interval[1]);
        }
    }

    private static Stream<Double> ranges(SceneResult result) {
        return result.pairs().stream().map(PairResult::range).flatMap(range -> range.stream()
                .boxed());
    }

    @Thorough
    @Test
    void anyNumberOfThreadsFindsTheSame() {
        SceneResult one =
                new SceneRunner(new Approaching(5)).seed(11).threads(1).run();
        SceneResult four =
                new SceneRunner(new Approaching(5)).seed(11).threads(4).run();

        assertThat(four.pairs()).isEqualTo(one.pairs());
        assertThat(ranges(one)).isNotEmpty();
    }
}
