package org.dronewatch.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.random.RandomGenerator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Random numbers by name. */
class DrawsTest {
    private static final List<String> NAMES =
            List.of("", "a", "b", "camera", "camera-1", "camera-2", "radar", "Radar", "microphone", "x-1", "x-10");

    /** Test vectors of the authors: FNV-1a, 64 bits, in the IETF's draft-eastlake-fnv, appendix C. */
    @ParameterizedTest
    @CsvSource({"'', cbf29ce484222325", "a, af63dc4c8601ec8c", "foobar, 85944171f73967e8"})
    void namesAreHashedAsPublished(String name, String hash) {
        assertThat(Long.toHexString(Draws.hash(name))).isEqualTo(hash);
    }

    @Test
    void aNameIsHashedAsUtf8() {
        // The bytes C3 A9, by hand.
        long expected = ((0xCBF29CE484222325L ^ 0xC3) * 0x100000001B3L ^ 0xA9) * 0x100000001B3L;
        assertThat(Draws.hash("\u00e9")).isEqualTo(expected);
    }

    @Test
    void everyKeyHasAStreamOfItsOwn() {
        Set<Long> first = new HashSet<>();
        int keys = 0;
        for (String sensor : NAMES) {
            for (String drone : NAMES) {
                for (long look = 0; look < 50; look++) {
                    for (String purpose : List.of("detection", "error", "rays")) {
                        first.add(Draws.stream(1, sensor, drone, look, purpose).nextLong());
                        keys++;
                    }
                }
            }
        }
        assertThat(first).hasSize(keys);
    }

    /** Sensor and drone of exchanged names must not share numbers. */
    @Test
    void namesAreNotExchangeable() {
        assertThat(Draws.stream(1, "a", "b", 0, "detection").nextLong())
                .isNotEqualTo(Draws.stream(1, "b", "a", 0, "detection").nextLong());
    }

    /** Neighbouring looks, sensors that are named alike and other purposes must not be correlated. */
    @Test
    void neighbouringStreamsAreIndependent() {
        int looks = 20_000;
        // The standard deviation of a sample correlation of independent numbers is 1 / sqrt(n).
        double most = 4.5 / Math.sqrt(looks);
        assertThat(correlation(looks, "s-1", "d", 0, "detection", 0)).isCloseTo(1.0, within(1e-9));
        assertThat(correlation(looks, "s-1", "d", 1, "detection", 0)).isCloseTo(0.0, within(most));
        assertThat(correlation(looks, "s-2", "d", 0, "detection", 0)).isCloseTo(0.0, within(most));
        assertThat(correlation(looks, "s-1", "e", 0, "detection", 0)).isCloseTo(0.0, within(most));
        assertThat(correlation(looks, "s-1", "d", 0, "error", 0)).isCloseTo(0.0, within(most));
        assertThat(correlation(looks, "s-1", "d", 0, "detection", 1)).isCloseTo(0.0, within(most));
    }

    /** Of the numbers of sensor s-1 that looks at drone d with those of another stream. */
    private static double correlation(int looks, String sensor, String drone, int later, String purpose, long seeds) {
        double[] sums = new double[5];
        for (int look = 0; look < looks; look++) {
            double a = Draws.stream(7, "s-1", "d", look, "detection").nextDouble() - 0.5;
            double b = Draws.stream(7 + seeds, sensor, drone, look + later, purpose)
                            .nextDouble()
                    - 0.5;
            sums[0] += a;
            sums[1] += b;
            sums[2] += a * a;
            sums[3] += b * b;
            sums[4] += a * b;
        }
        double covariance = sums[4] - sums[0] * sums[1] / looks;
        return covariance / Math.sqrt((sums[2] - sums[0] * sums[0] / looks) * (sums[3] - sums[1] * sums[1] / looks));
    }

    @Test
    void aStreamBeginsAnewEachTime() {
        RandomGenerator one = Draws.stream(1, "s", "d", 3, "error");
        double first = one.nextDouble();
        one.nextDouble();
        assertThat(Draws.stream(1, "s", "d", 3, "error").nextDouble()).isEqualTo(first);
    }

    @Test
    void theFirstRunHasTheSeedAsGivenAndOthersHaveSeedsThatJsonKeeps() {
        assertThat(Draws.derivedSeed(-5, "run", 0)).isEqualTo(-5);
        Set<Long> seeds = new HashSet<>();
        for (int number = 1; number <= 10_000; number++) {
            long run = Draws.derivedSeed(-5, "run", number);
            assertThat(run).isBetween(0L, 1L << 53);
            assertThat((long) (double) run).isEqualTo(run);
            seeds.add(run);
            seeds.add(Draws.derivedSeed(-5, "replication", number));
        }
        assertThat(seeds).hasSize(20_000);
    }
}
