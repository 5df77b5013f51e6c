package org.dronewatch.sensor.thermal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.SplittableRandom;
import org.dronewatch.sensor.NormalTail;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PointTargetsTest {
    private static final long PIXELS = 640 * 512;

    private static PointTargets rule(int hits, int frames, int gate) {
        return PointTargets.DEFAULT.withConfirmation(hits, frames).withGate(gate);
    }

    private static final PointTargets SINGLE =
            PointTargets.DEFAULT.withConfirmation(1, 1).withGate(1);

    /** Computed with mpmath to 20 digits: erfc(t / sqrt(2)) / 2. */
    @ParameterizedTest
    @CsvSource({
        "-9, 0.99999999999999999989",
        "-3.2, 0.99931286206208415",
        "-1, 0.84134474606854295",
        "0, 0.5",
        "1, 0.15865525393145705",
        "2.9, 0.0018658133003840378",
        "2.999999, 0.0013499024634851542",
        "3.000001, 0.0013498935997883304",
        "5, 2.8665157187919391e-7",
        "8, 6.2209605742717841e-16",
        "20, 2.7536241186062337e-89"
    })
    void theTailIsThatOfTables(double t, double above) {
        assertThat(NormalTail.above(t)).isCloseTo(above, within(1e-12 * above));
    }

    @Test
    void theTailFallsWithoutAStep() {
        double last = 1.0;
        for (double t = -9.0; t < 37.0; t += 0.001) {
            double now = NormalTail.above(t);
            assertThat(now).as("t = %f", t).isLessThanOrEqualTo(last);
            last = now;
        }
        assertThat(NormalTail.above(60.0)).isZero();
        assertThat(NormalTail.above(Double.POSITIVE_INFINITY)).isZero();
        assertThat(NormalTail.above(Double.NEGATIVE_INFINITY)).isEqualTo(1.0);
    }

    /**
     * 640 x 512 pixels, 25 frames a second, t = 5: 8,450 false alarms an hour; a drone with SNR 5 is marked in every
     * second frame.
     */
    @Test
    void aSingleFrameAtFiveSigmaRaisesThousandsOfFalseAlarms() {
        assertThat(SINGLE.falseAlarmsPerHour(5.0, PIXELS)).isCloseTo(8450.0, within(10.0));
        assertThat(PointTargets.markProbability(5.0, 5.0)).isEqualTo(0.5);
        assertThat(SINGLE.probability(0.5)).isEqualTo(0.5);
        assertThat(SINGLE.withFalseAlarmsPerHour(8454.0).threshold(PIXELS)).isCloseTo(5.0, within(1e-4));
    }

    @ParameterizedTest
    @CsvSource({"1, 1, 1", "1, 1, 9", "2, 3, 9", "3, 5, 1", "3, 5, 9", "5, 5, 25", "50, 50, 9"})
    void theThresholdKeepsToTheFalseAlarms(int hits, int frames, int gate) {
        PointTargets rule = rule(hits, frames, gate);
        for (double perHour : new double[] {1e-6, 0.1, 1.0, 1000.0}) {
            PointTargets accepted = rule.withFalseAlarmsPerHour(perHour);
            double threshold = accepted.threshold(PIXELS);
            assertThat(accepted.falseAlarmsPerHour(threshold, PIXELS)).isCloseTo(perHour, within(1e-9 * perHour));
        }
    }

    /** Two, ten times the frames: as many more chances for noise. */
    @Test
    void moreFramesRaiseTheThreshold() {
        for (PointTargets rule : new PointTargets[] {SINGLE, PointTargets.DEFAULT}) {
            PointTargets few = rule.withFrameRate(5.0);
            PointTargets many = rule.withFrameRate(50.0);
            double slow = few.threshold(PIXELS);
            assertThat(many.threshold(PIXELS)).isGreaterThan(slow);
            assertThat(many.falseAlarmsPerHour(slow, PIXELS))
                    .isCloseTo(10.0 * few.falseAlarmsPerHour(slow, PIXELS), within(1e-9));
        }
    }

    /** Pixels full of noise, frame after frame, counted as a program would. */
    @ParameterizedTest
    @CsvSource({"1, 1, 1, 0.02", "3, 5, 1, 0.08", "2, 3, 9, 0.01", "3, 5, 9, 0.015", "1, 4, 9, 0.01"})
    void noiseIsConfirmedAsOftenAsTheFormulaStates(int hits, int frames, int gate, double mark) {
        long seed = 20261124;
        SplittableRandom random = new SplittableRandom(seed);
        int side = 60;
        int count = 3000;
        boolean[][][] marks = new boolean[frames + 1][side + 2][side + 2];
        long confirmed = 0;
        for (int frame = 0; frame < count; frame++) {
            boolean[][] now = marks[frame % (frames + 1)];
            for (boolean[] row : now) {
                for (int x = 0; x < row.length; x++) {
                    row[x] = random.nextDouble() < mark;
                }
            }
            confirmed += frame < frames ? 0 : newlyConfirmed(marks, frame, hits, frames, gate);
        }
        double t = PointTargets.exceededWith(mark);
        double pixelFrames = (double) side * side * (count - frames);
        double expected = rule(hits, frames, gate).withFrameRate(1.0 / 3600.0).falseAlarmsPerHour(t, 1) * pixelFrames;

        // Overlapping gates make neighbours depend on each other: their variance is up to the gate times that of a
        // count.
        assertThat((double) confirmed)
                .as("seed %d", seed)
                .isCloseTo(expected, within(4.0 * Math.sqrt(expected * gate)));
        assertThat(expected).isGreaterThan(300.0);
    }

    private static long newlyConfirmed(boolean[][][] marks, int frame, int hits, int frames, int gate) {
        int length = frames + 1;
        int reach = gate == 1 ? 0 : 1;
        int side = marks[0].length - 2;
        long confirmed = 0;
        for (int y = 1; y <= side; y++) {
            for (int x = 1; x <= side; x++) {
                if (!marks[frame % length][y][x]) {
                    continue;
                }
                int before = 0;
                for (int back = 1; back < frames; back++) {
                    before += isMarked(marks[(frame - back) % length], x, y, reach) ? 1 : 0;
                }
                boolean first = !isMarked(marks[(frame - frames) % length], x, y, reach);
                confirmed += before == hits - 1 && first ? 1 : 0;
            }
        }
        return confirmed;
    }

    private static boolean isMarked(boolean[][] frame, int x, int y, int reach) {
        for (int dy = -reach; dy <= reach; dy++) {
            for (int dx = -reach; dx <= reach; dx++) {
                if (frame[y + dy][x + dx]) {
                    return true;
                }
            }
        }
        return false;
    }

    /** 3 of 5 at .5 is even, at .9 it is .99144, and at .001 9.985e-9. */
    @Test
    void severalFramesConfirm() {
        assertThat(PointTargets.DEFAULT.probability(0.5)).isCloseTo(0.5, within(1e-15));
        assertThat(PointTargets.DEFAULT.probability(0.9)).isCloseTo(0.99144, within(1e-14));
        assertThat(PointTargets.DEFAULT.probability(0.001)).isCloseTo(9.985e-9, within(1e-12));
        assertThat(PointTargets.DEFAULT.probability(0.0)).isZero();
        assertThat(PointTargets.DEFAULT.probability(1.0)).isEqualTo(1.0);
        assertThat(rule(50, 50, 1).probability(1.0)).isEqualTo(1.0);
        assertThat(rule(25, 50, 1).probability(0.5)).isCloseTo(0.5561, within(1e-4));
    }

    /**
     * One pixel at a frame an hour cannot raise a billion false alarms an hour: the threshold stays where it raises the
     * most.
     */
    @Test
    void moreFalseAlarmsThanThereAreFramesAreNotSought() {
        PointTargets greedy = SINGLE.withFalseAlarmsPerHour(1e9).withFrameRate(1.0);

        assertThat(greedy.threshold(1)).isCloseTo(0.0, within(0.01));
        assertThat(PointTargets.DEFAULT
                        .withFalseAlarmsPerHour(1e9)
                        .withFrameRate(1.0)
                        .threshold(100))
                .isBetween(0.5, 3.0);
    }

    /**
     * What cannot be reached is sought where noise is confirmed most often: on either side of that threshold there are
     * fewer false alarms. Without neighbours (a gate of one pixel), that is where M of N + 1 frames are marked.
     */
    @ParameterizedTest
    @CsvSource({"1, 1, 1", "3, 5, 1", "5, 5, 1", "2, 3, 9", "3, 5, 9", "1, 4, 9", "5, 5, 25", "2, 12, 25", "4, 9, 2"})
    void theLowestThresholdRaisesTheMostFalseAlarms(int hits, int frames, int gate) {
        PointTargets greedy =
                rule(hits, frames, gate).withFalseAlarmsPerHour(1e9).withFrameRate(1.0);
        double threshold = greedy.threshold(1);
        double most = greedy.falseAlarmsPerHour(threshold, 1);

        for (double off : new double[] {0.003, 0.03, 0.3}) {
            assertThat(greedy.falseAlarmsPerHour(threshold - off, 1)).isLessThan(most);
            assertThat(greedy.falseAlarmsPerHour(threshold + off, 1)).isLessThan(most);
        }
        if (gate == 1) {
            assertThat(NormalTail.above(threshold)).isCloseTo(hits / (frames + 1.0), within(1e-9));
        }
    }

    /** A thousand frames in a look, and a thousand false alarms at the same time, are the most that is allowed. */
    @Test
    void limitsCanBeReachedButNotExceeded() {
        PointTargets fast = PointTargets.DEFAULT.withFrameRate(1000.0);
        fast.checkFrames(1.0);
        assertThatIllegalArgumentException().isThrownBy(() -> fast.checkFrames(Math.nextDown(1.0)));

        // Each lasts for three looks: 1000 at a time are 25 / 3 * 1000 a second.
        PointTargets busy = PointTargets.DEFAULT.withFalseAlarmsPerHour(3e7);
        busy.checkRate(25.0);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> busy.withFalseAlarmsPerHour(Math.nextUp(3e7)).checkRate(25.0));
    }

    /** Rounding in the threshold of such a rule must not make its false alarms too many. */
    @Test
    void asManyFalseAlarmsAsAreAcceptedCanBeSimulated() {
        SplittableRandom random = new SplittableRandom(1000);
        for (int i = 0; i < 300; i++) {
            int hits = random.nextInt(1, 6);
            int frames = hits + random.nextInt(4);
            int looks = random.nextInt(1, 40);
            // With a frame per look, each lasts for as many looks as its marks can keep it confirmed.
            PointTargets rule = rule(hits, frames, 9)
                    .withFrameRate(looks)
                    .withFalseAlarmsPerHour(1000.0 * 3600.0 * looks / (frames - hits + 1));
            rule.checkRate(looks);
            assertThat(rule.rate(640 * 512, looks).perHour())
                    .as("%s", rule)
                    .isCloseTo(rule.falseAlarmsPerHour(), withinPercentage(1e-6));
        }
    }

    @Test
    void moreHitsThanFramesAreRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> rule(4, 3, 9))
                .withMessage("hits 4 must be at most frames 3");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> PointTargets.DEFAULT.withFalseAlarmsPerHour(0.0))
                .withMessageContaining("falseAlarmsPerHour");
    }
}
