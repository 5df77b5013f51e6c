package org.dronewatch.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import org.dronewatch.Wilson;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Observers who draw once per encounter and then search, against the closed forms of how many find the drone by when.
 */
class EncounterTest {
    private static final long SEED = 20261124;
    private static final String DRONE = "drone";
    private static final double SIGMAS = 3.3;

    /** The observer of one sensor, look by look. */
    private static final class Watch {
        private final long seed;
        private final double rate;
        private Encounters encounters = Encounters.NONE;
        private long next;

        Watch(long seed, double rate) {
            this.seed = seed;
            this.rate = rate;
        }

        double time() {
            return next / rate;
        }

        Look look() {
            return Look.of(seed, "camera", next, time()).withEncounters(encounters);
        }

        /** Looks once, and says whether that detects the drone. */
        boolean detects(double probability) {
            Look look = look();
            double threshold = look.observerThreshold(DRONE, rate, probability);
            Observation seen = new Observation(look.id("camera"), DRONE, 100.0, new Reading(probability, threshold, ""))
                    .withFigures(Map.of(Observation.PROBABILITY, probability));
            encounters = Encounters.after(look, rate, List.of(seen));
            next++;
            return seen.isDetected();
        }

        /** When it first detects a drone whose probability changes with time; empty if not by the given time. */
        OptionalDouble first(DoubleUnaryOperator probability, double until) {
            while (time() <= until) {
                double now = time();
                if (detects(probability.applyAsDouble(now))) {
                    return OptionalDouble.of(now);
                }
            }
            return OptionalDouble.empty();
        }
    }

    private static Watch watch(int run, double rate) {
        return new Watch(Draws.mix(SEED, run), rate);
    }

    private static void assertShare(int hits, int of, double expected, String what) {
        double[] interval = Wilson.interval(hits, of, SIGMAS);
        System.out.printf("seed %d, %s: %d of %d, expected %.4f%n", SEED, what, hits, of, expected);
        assertThat(expected).as(what).isBetween(interval[0], interval[1]);
    }

    /** P = 0.9 for 5 s: 0.660, whatever the frame rate. */
    @ParameterizedTest
    @CsvSource({"5, 0.9, 5, 0.660", "25, 0.9, 5, 0.660", "50, 0.9, 5, 0.660", "25, 0.3, 5, 0.107", "25, 1, 3.4, 0.632"})
    void aConstantProbabilityFollowsTheClosedForm(double rate, double probability, double time, double expected) {
        double closed = probability * (1.0 - Math.exp(-probability * time / 3.4));
        assertThat(closed).isCloseTo(expected, within(0.0005));
        int runs = 3000;
        int found = 0;
        for (int run = 0; run < runs; run++) {
            found += watch(run, rate).first(t -> probability, time + 1e-9).isPresent() ? 1 : 0;
        }
        assertShare(found, runs, closed, "P " + probability + " for " + time + " s at " + rate + " Hz");
    }

    /** However long it hovers there: only the fraction P of all observers can find it. */
    @Test
    void timeDoesNotHelpThoseWhoCannot() {
        int runs = 1000;
        int found = 0;
        for (int run = 0; run < runs; run++) {
            found += watch(run, 5.0).first(t -> 0.5, 120.0).isPresent() ? 1 : 0;
        }
        assertShare(found, runs, 0.5, "P 0.5 for two minutes");
    }

    /**
     * A drone of 0.07 m2 and 5 K that flies at 15 m/s towards 640 pixels over 24 degrees (50 mK, 85 % per kilometre).
     * With a whole line pair across the root of its area P is 0.5 at 195 m, and by the integral over observers half of
     * them have found it at 126.5 m; with the three quarters that an area takes, at 260 and 184.7 m.
     */
    private record Approach(double speed, double from, double linePairs) {
        double probability(double range) {
            double across = Math.sqrt(0.07) * 320.0 / Math.tan(Math.toRadians(12.0)) / range;
            double signal = 5.0 * Math.pow(0.85, range / 1000.0) * Math.min(1.0, across * across) / 0.05;
            double pairs = signal > 2.0 ? 0.5 * across * (1.0 - 2.0 / signal) : 0.0;
            return Discrimination.transfer(pairs / linePairs);
        }

        double at(double time) {
            return probability(from - speed * time);
        }

        /** The fraction of observers who have found it by a range: trapezoids over draws and search. */
        double found(double range) {
            double step = 0.25;
            double search = 0.0;
            double sum = 0.0;
            double before = probability(range);
            for (double r = range; r < from; r += step) {
                double next = probability(r + step);
                double middle = 0.5 * (before + next);
                search += middle * step / (speed * 3.4);
                sum += (before - next) * -Math.expm1(-search);
                before = next;
            }
            // Those who could find it from the start.
            return sum - before * Math.expm1(-search);
        }
    }

    @Test
    void theClosedFormOfAnApproachHasItsKnownMedian() {
        Approach approach = new Approach(15.0, 1200.0, 1.0);
        assertThat(approach.probability(195.0)).isCloseTo(0.5, within(0.003));
        assertThat(approach.found(126.5)).isCloseTo(0.5, within(0.003));
        assertThat(approach.found(60.0)).isCloseTo(0.824, within(0.003));
        Approach onArea = new Approach(15.0, 1200.0, Discrimination.DETECTION.linePairs());
        assertThat(onArea.probability(260.0)).isCloseTo(0.5, within(0.003));
        assertThat(onArea.found(184.7)).isCloseTo(0.5, within(0.003));
    }

    @ParameterizedTest
    @ValueSource(doubles = {5, 25, 50})
    void theRangeOfAnApproachDoesNotDependOnTheFrameRate(double rate) {
        Approach approach = new Approach(15.0, 600.0, Discrimination.DETECTION.linePairs());
        int runs = 800;
        List<Double> ranges = new ArrayList<>();
        for (int run = 0; run < runs; run++) {
            watch(run, rate).first(approach::at, 570.0 / 15.0).ifPresent(t -> ranges.add(600.0 - 15.0 * t));
        }
        for (double range : new double[] {60, 127, 185, 260, 350}) {
            int found = (int) ranges.stream().filter(r -> r >= range).count();
            assertShare(found, runs, approach.found(range), "found by " + range + " m at " + rate + " Hz");
        }
    }

    /** Found once, it is held while its probability is at least what the observer drew, and lost below that. */
    @Test
    void whatIsFoundIsHeldWithoutAnotherSearch() {
        Watch watch = watch(1, 25.0);
        double drawn = watch.look().encounter(DRONE, 25.0).draw(watch.seed, "camera", DRONE);
        assertThat(watch.first(t -> 1.0, 60.0)).isPresent();
        for (int i = 0; i < 100; i++) {
            assertThat(watch.detects(drawn)).isTrue();
            assertThat(watch.detects(Math.nextDown(drawn))).isFalse();
        }
        assertThat(watch.look().encounter(DRONE, 25.0)).isEqualTo(new Encounter(0, false, true));
    }

    @Test
    void aDroneThatIsSoonBackIsStillTheSameEncounter() {
        Watch watch = watch(1, 2.0);
        watch.first(t -> 1.0, 60.0);
        double last = watch.time() - 0.5;
        while (watch.time() <= last + Encounter.GAP) {
            assertThat(watch.look().encounter(DRONE, 2.0)).isEqualTo(new Encounter(0, false, true));
            assertThat(watch.detects(0.0)).isFalse();
        }
        assertThat(watch.look().encounter(DRONE, 2.0)).isEqualTo(new Encounter(1, false, false));
    }

    @Test
    void eachEncounterHasADrawOfItsOwn() {
        double[] draws = IntStream.range(0, 1000)
                .mapToDouble(i -> new Encounter(i, false, false).draw(SEED, "camera", DRONE))
                .sorted()
                .toArray();
        // Kolmogorov and Smirnov: 1.95 / sqrt(n) at one in a thousand.
        for (int i = 0; i < draws.length; i++) {
            assertThat(draws[i]).isCloseTo((i + 0.5) / draws.length, within(1.95 / Math.sqrt(draws.length)));
        }
        Encounter first = new Encounter(0, false, false);
        assertThat(first.draw(SEED, "camera", DRONE))
                .isEqualTo(new Encounter(0, true, true).draw(SEED, "camera", DRONE))
                .isNotEqualTo(first.draw(SEED, "camera", "other"))
                .isNotEqualTo(first.draw(SEED, "other", DRONE))
                .isNotEqualTo(first.draw(SEED + 1, "camera", DRONE));
    }

    /** Between two pictures a minute apart a drone is not out of sight. */
    @Test
    void aSlowCameraMeetsADroneOnce() {
        Watch watch = watch(3, 1.0 / 60.0);
        for (int i = 0; i < 20; i++) {
            watch.detects(0.4);
            assertThat(watch.look().encounter(DRONE, 1.0 / 60.0).index()).isZero();
        }
        watch.detects(0.0);
        assertThat(watch.look().encounter(DRONE, 1.0 / 60.0).index()).isOne();
    }

    @Test
    void whatCannotBeSeenIsNeverFound() {
        for (int run = 0; run < 50; run++) {
            assertThat(watch(run, 50.0).first(t -> 0.0, 20.0)).isEmpty();
        }
        assertThat(watch(0, 50.0).detects(1.0))
                .as("nobody has searched before the run begins")
                .isFalse();
    }

    @Test
    void lookingAgainGivesTheSame() {
        Look look = Look.of(SEED, "camera", 7, 3.5);
        for (double probability : new double[] {0.2, 0.6, 1.0}) {
            double threshold = look.observerThreshold(DRONE, 2.0, probability);
            assertThat(look.observerThreshold(DRONE, 2.0, probability)).isEqualTo(threshold);
        }
    }

    /** A false alarm, or a drone that is not seen, leaves no trace; several observations in a look count as one. */
    @Test
    void onlyDronesThatAreSeenAreMet() {
        Look look = Look.of(SEED, "camera", 1, 1.0);
        Observation hidden = new Observation(look.id("camera"), "hidden", 9.0, new Reading(0.0, 0.5, ""));
        Observation nothing =
                Observation.ofNothing(look.id("camera"), new Reading(1.0, 0.5, ""), java.util.Optional.empty());
        Encounters none = Encounters.after(look, 1.0, List.of(hidden, nothing));
        assertThat(none.with("hidden", 99.0, 1.0)).isEqualTo(new Encounter(0, false, false));
        assertThat(none.with("", 99.0, 1.0)).isEqualTo(new Encounter(0, false, false));

        Observation found = new Observation(look.id("camera"), DRONE, 9.0, new Reading(0.9, 0.5, ""));
        Observation again = new Observation(look.id("camera"), DRONE, 9.0, new Reading(0.4, 0.5, ""))
                .withFigures(Map.of(Observation.PROBABILITY, 0.4));
        Encounters after = Encounters.after(look, 1.0, List.of(found, again));
        assertThat(after.with(DRONE, 2.0, 1.0)).isEqualTo(new Encounter(0, false, true));
    }

    /**
     * Sixteen draws predict what an unknown observer finds: within half of a sixteenth, since one of them lies beside
     * P.
     */
    @Test
    void hazardsIntegratedOverSixteenDrawsGiveTheClosedForm() {
        for (double probability : new double[] {0.1, 0.47, 0.9, 1.0}) {
            for (double time : new double[] {1, 5, 30}) {
                double found = 0.0;
                for (int i = 0; i < 16; i++) {
                    double hazard = Chance.PER_ENCOUNTER.hazard(probability, 25.0, (i + 0.5) / 16.0);
                    found -= Math.expm1(-hazard * time) / 16.0;
                }
                double closed = probability * -Math.expm1(-probability * time / 3.4);
                assertThat(found).isCloseTo(closed, within(1.0 / 32.0 + 1e-9));
            }
        }
    }

    /** Looks that decide anew detect within n looks with 1 - (1 - p)^n. */
    @Test
    void theHazardOfLooksIsThatOfIndependentLooks() {
        double hazard = Chance.PER_LOOK.hazard(0.2, 4.0, 0.999);
        assertThat(-Math.expm1(-hazard * 2.5)).isCloseTo(1.0 - Math.pow(0.8, 10), within(1e-12));
        assertThat(Chance.PER_LOOK.hazard(1.0, 4.0, 0.5)).isInfinite();
        assertThat(Chance.PER_LOOK.hazard(0.0, 4.0, 0.5)).isZero();
    }
}
