package org.dronewatch.sensor.acoustic.level;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Stated errors of the fraction of rays that are heard, against disks of known area in the square of directions. */
final class RayShareTest {
    private static final int TRIALS = 400;
    private static final long SEED = 7;

    /**
     * Even directions: at most as far off as stated, and stated to be more accurate than independent ones.
     *
     * @param part the stated error is below this part of that of independent directions
     */
    @ParameterizedTest
    @CsvSource({
        "0.3, 256, 0.55",
        "0.3, 4096, 0.35",
        "0.1, 1024, 0.65",
        "0.1, 4096, 0.5",
        "0.05, 4096, 0.65",
        "0.05, 16384, 0.5",
        "0.01, 16384, 1.0"
    })
    void errorsOfEvenDirectionsAreNotAboveThoseStated(double radius, int rays, double part) {
        SplittableRandom random = new SplittableRandom(SEED);
        Errors errors = errors(radius, rays, () -> new EvenPairs(random));
        assertThat(errors.found() / errors.stated()).as("seed %d", SEED).isLessThan(1.1);
        double missed = 1.0 - area(radius);
        double independent = Math.sqrt(area(radius) / (rays * missed));
        assertThat(errors.stated() / independent).as("seed %d", SEED).isLessThan(part);
    }

    /** Independent directions gain nothing: their error is that of the binomial distribution. */
    @ParameterizedTest
    @CsvSource({"0.3, 256", "0.1, 4096", "0.05, 16384", "0.01, 65536"})
    void errorsOfIndependentDirectionsAreStated(double radius, int rays) {
        SplittableRandom random = new SplittableRandom(SEED);
        Errors errors = errors(radius, rays, () -> random);
        assertThat(errors.found() / errors.stated()).as("seed %d", SEED).isBetween(0.8, 1.25);
    }

    /** If none is heard, the probability is not known better than one ray in all that were traced. */
    @Test
    void noneHeardIsNotCertain() {
        RayShare none = share(false);
        assertThat(none.missed()).isEqualTo(1.0);
        assertThat(Math.sqrt(none.variance())).isBetween(0.9e-3, 1.1e-3);
    }

    /** If all are heard, the logarithm of the probability to miss a ray is not known at all. */
    @Test
    void howSeldomRaysAreMissedIsUnknownIfNoneIs() {
        RayShare all = share(true);
        assertThat(all.missed()).isZero();
        assertThat(Math.sqrt(all.variance())).isBetween(0.9, 1.1);
    }

    private static RayShare share(boolean isHeard) {
        RayShare share = new RayShare(1);
        for (int i = 0; i < 1000; i++) {
            share.add(isHeard);
        }
        return share;
    }

    private interface Directions {
        RandomGenerator begin();
    }

    /** Root mean squares of the errors of the logarithm of the probability to miss a ray. */
    private record Errors(double found, double stated) {}

    private static double area(double radius) {
        return Math.PI * radius * radius;
    }

    private static Errors errors(double radius, int rays, Directions directions) {
        double found = 0.0;
        double stated = 0.0;
        for (int trial = 0; trial < TRIALS; trial++) {
            RandomGenerator pairs = directions.begin();
            RayShare share = new RayShare(1);
            for (int i = 0; i < rays; i++) {
                double first = pairs.nextDouble() - 0.5;
                double second = pairs.nextDouble() - 0.5;
                share.add(first * first + second * second < radius * radius);
            }
            double error = Math.log(share.missed()) - Math.log(1.0 - area(radius));
            found += error * error;
            stated += share.variance();
        }
        return new Errors(Math.sqrt(found / TRIALS), Math.sqrt(stated / TRIALS));
    }
}
