package org.dronewatch.sensor.thermal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Look;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * At what range a program first finds a quadrotor of 5 K that comes at 15 m/s: how far its range depends on its frame
 * rate, and that it does not depend on how often a run looks. The exact distribution follows from the chances of all
 * sequences of the last marks.
 */
class PointTargetRangeTest {
    private static final double START = 2600.0;
    private static final double SPEED = 15.0;

    private static ThermalSettings camera(double rate) {
        return camera(rate, rate);
    }

    private static ThermalSettings camera(double looks, double frameRate) {
        return ThermalSettings.at(new Position(0, 0, 0))
                .withRate(looks)
                .withPointTargets(PointTargets.DEFAULT.withFrameRate(frameRate));
    }

    /** 0.0528 m2, 50 mK, 0.85 a kilometre, at a focal length of 1505 pixels. */
    private static double signalToNoise(ThermalSettings camera, double range) {
        double fill = Math.min(1.0, 0.0528 * Math.pow(camera.focalLength() / range, 2));
        return camera.create().signalToNoise(5.0, range, fill);
    }

    private static double range(double start, double rate, int frame) {
        return start - SPEED * frame / rate;
    }

    /** The probability that three of five frames in a row have marked the drone by each frame. */
    private static double[] detectedBy(double rate) {
        return detectedBy(camera(rate), START);
    }

    private static double[] detectedBy(ThermalSettings camera, double start) {
        double rate = camera.rate();
        double threshold = PointTargets.DEFAULT.withFrameRate(rate).threshold(camera.pixels());
        int states = 16;
        double[] chance = new double[states];
        chance[0] = 1.0;
        double[] detected = new double[(int) (rate * (start - 950) / SPEED)];
        double sum = 0.0;
        for (int frame = 0; frame < detected.length; frame++) {
            double mark = PointTargets.markProbability(signalToNoise(camera, range(start, rate, frame)), threshold);
            double[] next = new double[states];
            for (int state = 0; state < states; state++) {
                if (Integer.bitCount(state) >= 2) {
                    sum += chance[state] * mark;
                } else {
                    next[(state << 1 | 1) & states - 1] += chance[state] * mark;
                }
                next[state << 1 & states - 1] += chance[state] * (1.0 - mark);
            }
            chance = next;
            detected[frame] = sum;
        }
        return detected;
    }

    private static double quantile(double rate, double probability) {
        double[] detected = detectedBy(rate);
        int frame = 0;
        while (detected[frame] < probability) {
            frame++;
        }
        return range(START, rate, frame);
    }

    /** The figures of the page. */
    @ParameterizedTest
    @CsvSource({"5, 1859, 1727, 1637", "25, 1920, 1800, 1722", "50, 1942, 1826, 1751"})
    void theRangeOfTheFirstDetectionHardlyDependsOnTheFrameRate(double rate, double tenth, double half, double most) {
        assertThat(quantile(rate, 0.1)).isCloseTo(tenth, within(3.5));
        assertThat(quantile(rate, 0.5)).isCloseTo(half, within(3.5));
        assertThat(quantile(rate, 0.9)).isCloseTo(most, within(3.5));
    }

    /**
     * With the same light, a second has the same information at each rate, and three of five frames use less of it the
     * shorter they are: the figures of the page.
     */
    @ParameterizedTest
    @CsvSource({"5, 2467", "25, 1800", "50, 1561"})
    void withTheSameLightFiveShortFramesSeeLessFar(double rate, double half) {
        double start = 4000;
        double[] detected = detectedBy(camera(rate).withNetd(0.05 * Math.sqrt(rate / 25)), start);
        int frame = 0;
        while (detected[frame] < 0.5) {
            frame++;
        }
        assertThat(range(start, rate, frame)).isCloseTo(half, within(3.5));
    }

    /** More frames are more chances, but a higher threshold takes most of them back. */
    @Test
    void twoHundredTimesTheFramesAddAboutASeventh() {
        assertThat(quantile(200, 0.5) / quantile(1, 0.5)).isBetween(1.1, 1.2);
    }

    @ParameterizedTest
    @CsvSource({"5, 400", "25, 200"})
    void simulatedEncountersAgreeWithTheExactDistribution(double rate, int runs) {
        assertDistribution(firstLooks(camera(rate), runs), detectedBy(rate), 1);
    }

    /**
     * Of the same frames, every fifth is looked at, or each, or each twice: the distribution of the first detection is
     * that of all frames, and run by run it is the same to a look.
     */
    @Test
    void howOftenARunLooksChangesNothing() {
        int runs = 100;
        double frameRate = 25.0;
        double[] exact = detectedBy(frameRate);
        int[] each = firstLooks(camera(25, frameRate), runs);
        int[] everyFifth = firstLooks(camera(5, frameRate), runs);
        int[] twice = firstLooks(camera(50, frameRate), runs);
        int early = 0;
        for (int run = 0; run < runs; run++) {
            assertThat(twice[run]).as("seed %d", 1000 + run).isBetween(2 * each[run] - 1, 2 * each[run]);
            int next = (each[run] + 4) / 5;
            assertThat(everyFifth[run]).as("seed %d", 1000 + run).isLessThanOrEqualTo(next);
            early += everyFifth[run] < next ? 1 : 0;
        }
        // The ratio of a look, which is that at its time, is up to 0.3 % higher than that of the frames before.
        assertThat(early).isLessThan(runs / 10);
        assertDistribution(each, exact, 1);
        assertDistribution(everyFifth, exact, 5);
    }

    /** The look that first detects the drone, in each of several runs. */
    private static int[] firstLooks(ThermalSettings camera, int runs) {
        double rate = camera.rate();
        SpotDetector detector = new SpotDetector(camera.pointTargets().orElseThrow(), camera);
        double[] probabilities = new double[(int) (rate * 110)];
        for (int look = 0; look < probabilities.length; look++) {
            probabilities[look] = detector.probability(signalToNoise(camera, range(START, rate, look)));
        }
        int[] first = new int[runs];
        for (int run = 0; run < runs; run++) {
            // At 2300 m it is not detected yet, but for one in a million.
            int look = (int) (rate * 20);
            while (probabilities[look]
                    < detector.drawnThreshold(Look.of(1000 + run, "wide", look, look / rate), "intruder")) {
                look++;
            }
            first[run] = look;
        }
        return first;
    }

    /** Compares with the exact distribution over frames, of which each look spans some. */
    private static void assertDistribution(int[] firstLooks, double[] detected, int frames) {
        int[] first = firstLooks.clone();
        Arrays.sort(first);
        int runs = first.length;
        for (double quantile : new double[] {0.1, 0.5, 0.9}) {
            double exact = detected[frames * first[(int) (quantile * runs)]];
            double error = Math.sqrt(quantile * (1.0 - quantile) / runs);
            assertThat(exact)
                    .as("seeds 1000 to %d, quantile %s", 999 + runs, quantile)
                    .isCloseTo(quantile, within(4.0 * error));
        }
    }
}
