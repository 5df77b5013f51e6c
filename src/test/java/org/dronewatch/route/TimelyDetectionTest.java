package org.dronewatch.route;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TimelyDetectionTest {
    /** A worksheet with two sensors: its results were computed from the formula with 40 digits. */
    private static final List<PathTask> WORKSHEET = List.of(
            new PathTask(0.0, 10.0, 3.0),
            new PathTask(0.0, 12.0, 3.6),
            new PathTask(0.9, 90.0, 27.0),
            new PathTask(0.0, 10.0, 3.0),
            new PathTask(0.9, 90.0, 27.0),
            new PathTask(0.0, 120.0, 36.0));

    @ParameterizedTest
    @CsvSource({
        "BEGIN, 300, 90, .4760407",
        "MIDDLE, 300, 90, .3194182",
        "END, 300, 90, .1851604",
        "BEGIN, 200, 60, .8305084"
    })
    void theWorksheetIsReproducedToItsDigits(Sensing sensing, double mean, double deviation, double expected) {
        TimelyDetection path = new TimelyDetection(WORKSHEET, sensing, 0.95, new ResponseTime(mean, deviation));

        assertThat(path.interruption()).isCloseTo(expected, within(5e-8));
    }

    /** Some spreadsheets multiply the misses by the communication, too, which gives .4831796 here. */
    @Test
    void communicationDoesNotMakeMisses() {
        TimelyDetection path = new TimelyDetection(WORKSHEET, Sensing.BEGIN, 0.95, new ResponseTime(300.0, 90.0));

        assertThat(path.interruption()).isNotCloseTo(0.4831796, within(1e-3));
    }

    @Test
    void aSingleSensor() {
        PathTask sensed = new PathTask(0.9, 0.0, 0.0);
        PathTask delay = new PathTask(0.0, 120.0, 36.0);
        ResponseTime response = new ResponseTime(90.0, 27.0);

        assertThat(new TimelyDetection(List.of(sensed, delay), Sensing.END, 0.95, response).interruption())
                .isCloseTo(0.6391, within(5e-5));
        assertThat(new TimelyDetection(List.of(new PathTask(1.0, 0.0, 0.0), delay), Sensing.END, 1.0, response)
                        .interruption())
                .isCloseTo(0.7475, within(5e-5));
    }

    /**
     * Six tasks, one of which is detected as it ends; 20 s pass before the detection is assessed. After the third task,
     * 480 s are left then, 180 s more than a response of 300 s takes, and 1320 s less than one of 1800 s. After the
     * fourth, the critical detection point, 440 s are left at its end, and after the fifth 240 s.
     */
    @ParameterizedTest
    @CsvSource({"150, 300, 1", "150, 480, 1", "150, 480.001, 0", "150, 1800, 0", "60, 300, 1", "200, 300, 0"})
    void deterministicTimes(double detected, double response, double expected) {
        List<PathTask> tasks = new ArrayList<>();
        for (double duration : new double[] {20, 40, 150, 60, 200, 240}) {
            tasks.add(new PathTask(duration == detected ? 1.0 : 0.0, duration, 0.0));
        }
        TimelyDetection path = new TimelyDetection(tasks, Sensing.END, 1.0, new ResponseTime(20.0 + response, 0.0));

        assertThat(path.interruption()).isEqualTo(expected);
    }

    /** {@code P_C (1 - exp(-lambda (T - R)))}, of .02/s along 120 s with a response of 60 s: .6988. */
    @Test
    void aConstantRateAlongAFlight() {
        int slices = 12_000;
        double duration = 120.0 / slices;
        PathTask slice = new PathTask(-Math.expm1(-0.02 * duration), duration, 0.0);
        TimelyDetection flight = new TimelyDetection(
                Collections.nCopies(slices, slice), Sensing.MIDDLE, 1.0, new ResponseTime(60.0, 0.0));

        assertThat(flight.interruption()).isCloseTo(-Math.expm1(-1.2), within(2e-4));
    }

    /** Against draws of all durations and detections, within four standard errors. */
    @Test
    void drawnDurationsAgree() {
        long seed = 20;
        SplittableRandom random = new SplittableRandom(seed);
        List<PathTask> tasks =
                List.of(new PathTask(0.3, 40.0, 10.0), new PathTask(0.5, 60.0, 15.0), new PathTask(0.2, 30.0, 9.0));
        ResponseTime response = new ResponseTime(70.0, 20.0);
        int runs = 400_000;
        int inTime = 0;
        for (int run = 0; run < runs; run++) {
            inTime += isInTime(tasks, response, random) ? 1 : 0;
        }
        double expected = new TimelyDetection(tasks, Sensing.END, 1.0, response).interruption();

        assertThat((double) inTime / runs)
                .as("seed %d", seed)
                .isCloseTo(expected, within(4.0 * Math.sqrt(expected * (1.0 - expected) / runs)));
    }

    private static boolean isInTime(List<PathTask> tasks, ResponseTime response, SplittableRandom random) {
        boolean isDetected = false;
        double left = 0.0;
        for (PathTask task : tasks) {
            left += isDetected ? task.mean() + task.deviation() * random.nextGaussian() : 0.0;
            isDetected = isDetected || random.nextDouble() < task.probability();
        }
        return isDetected && left >= response.mean() + response.deviation() * random.nextGaussian();
    }

    @Test
    void effectivenessIsTheProductWithNeutralisation() {
        assertThat(TimelyDetection.effectiveness(0.8, 0.5)).isEqualTo(0.4);
        assertThatThrownBy(() -> TimelyDetection.effectiveness(0.8, 1.1)).hasMessageContaining("neutralisation");
    }

    @Test
    void valuesOutOfRangeAreNamed() {
        ResponseTime response = new ResponseTime(0.0, 0.0);

        assertThatThrownBy(() -> new PathTask(1.1, 1.0, 0.0)).hasMessageContaining("probability 1.1");
        assertThatThrownBy(() -> new ResponseTime(-1.0, 0.0)).hasMessageContaining("mean -1 s");
        assertThatThrownBy(() -> new TimelyDetection(List.of(), Sensing.END, 1.0, response))
                .hasMessageContaining("0 tasks");
        assertThatThrownBy(() -> new TimelyDetection(WORKSHEET, Sensing.END, 2.0, response))
                .hasMessageContaining("communication 2");
    }
}
