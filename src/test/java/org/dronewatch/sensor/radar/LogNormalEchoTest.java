package org.dronewatch.sensor.radar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.dronewatch.drone.DroneClass;
import org.dronewatch.drone.RadarSignature;
import org.dronewatch.drone.RadarSignature.Fluctuation;
import org.dronewatch.sensor.radar.RadarDetection.Decision;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Log-normal cross-sections against the figures of 3GPP TR 38.901, a fine integral, and simulated looks. */
class LogNormalEchoTest {
    private static final long SEED = 20_261_124;
    private static final int LOOKS = 200_000;

    /** 3GPP TR 38.901, section 7.9.2.1. */
    @Test
    void classesHaveTheirFigures() {
        RadarSignature small = RadarSignature.of(DroneClass.SMALL_UAV);
        assertThat(10 * Math.log10(small.mean())).isCloseTo(-12.81, within(1e-9));
        assertThat(small.mean()).isCloseTo(0.0524, within(5e-5));
        assertThat(small.towards(1.0)).isEqualTo(small.mean());
        assertThat(small.deviation()).isEqualTo(3.74);
        RadarSignature large = RadarSignature.of(DroneClass.LARGE_UAV);
        assertThat(10 * Math.log10(large.mean())).isCloseTo(-5.85, within(1e-9));
        assertThat(large.deviation()).isEqualTo(2.5);
        assertThat(RadarSignature.DEFAULT.deviation()).isZero();
        // Means of five drones from Phantom 3 to Matrice 600 at 24 GHz, IEICE Communications Express 9, 2020.
        assertThat(10 * Math.log10(small.mean())).isBetween(-19.1, -8.1);
        assertThat(10 * Math.log10(RadarSignature.DEFAULT.mean())).isLessThan(-19.1);
        // The mean of the decibels lies lower than the mean of the cross-section: 1.610 dB for the small class.
        assertThat(new LogNormalEcho(new SquareLawDetector(1e-6, 1), 3.74).excess(0))
                .isCloseTo(-1.610, within(5e-4));
    }

    @ParameterizedTest
    @EnumSource(DroneClass.class)
    void theDistributionKeepsTheMean(DroneClass drones) {
        LogNormalEcho echo = new LogNormalEcho(new SquareLawDetector(1e-6, 1), drones.spread());
        SplittableRandom random = new SplittableRandom(SEED);
        double sum = 0;
        double squares = 0;
        for (int i = 0; i < LOOKS; i++) {
            double share = Math.pow(10, 0.1 * echo.excess(random.nextGaussian()));
            sum += share;
            squares += share * share;
        }
        double mean = sum / LOOKS;
        double error = Math.sqrt((squares / LOOKS - mean * mean) / LOOKS);
        assertThat(mean).as("seed %d", SEED).isCloseTo(1.0, within(4 * error));
    }

    /** The integral of the steady probability over the distribution, by 20,001 points. */
    @ParameterizedTest
    @CsvSource({"3.74, 1e-6, 1", "2.5, 1e-6, 1", "3.74, 1e-4, 10", "2.5, 1e-12, 1000", "0.5, 1e-6, 1", "20, 1e-6, 100"})
    void theProbabilityIsTheMeanOverTheDistribution(double spread, double falseAlarm, int pulses) {
        LogNormalEcho echo = new LogNormalEcho(new SquareLawDetector(falseAlarm, pulses), spread);
        SquareLawDetector detector = new SquareLawDetector(falseAlarm, pulses);
        for (double ratio = -20; ratio <= 30; ratio += 5) {
            double fine = 0;
            double step = 1e-3;
            for (double z = -10; z <= 10; z += step) {
                double decibels = ratio + spread * z - Math.log(10) / 20 * spread * spread;
                fine += step
                        * Math.exp(-0.5 * z * z)
                        / Math.sqrt(2 * Math.PI)
                        * detector.probability(decibels, Fluctuation.STEADY);
            }
            assertThat(echo.probability(ratio)).as("%f dB", ratio).isCloseTo(fine, within(1e-8));
        }
        for (double probability : new double[] {0.1, 0.5, 0.9}) {
            assertThat(echo.probability(echo.required(probability))).isCloseTo(probability, within(1e-8));
        }
    }

    /** Amplitudes with normal noise and a drawn cross-section, compared with the threshold for one pulse. */
    @ParameterizedTest
    @CsvSource({"SMALL_UAV, 8", "SMALL_UAV, 15", "LARGE_UAV, 12"})
    void aSimulatedDetectorAgrees(DroneClass drones, double ratio) {
        double falseAlarm = 1e-3;
        double threshold = -Math.log(falseAlarm);
        SplittableRandom random = new SplittableRandom(SEED);
        double sigma = drones.spread();
        int detected = 0;
        for (int look = 0; look < LOOKS; look++) {
            double decibels = ratio + sigma * random.nextGaussian() - Math.log(10) / 20 * sigma * sigma;
            double real = Math.pow(10, decibels / 20) + random.nextGaussian() / Math.sqrt(2);
            double imaginary = random.nextGaussian() / Math.sqrt(2);
            detected += real * real + imaginary * imaginary > threshold ? 1 : 0;
        }
        double expected = new RadarDetection.Chance(falseAlarm, 1)
                .on(RadarSignature.of(drones))
                .probability(ratio);
        assertThat((double) detected / LOOKS)
                .as("seed %d", SEED)
                .isCloseTo(expected, within(4 * Math.sqrt(expected * (1 - expected) / LOOKS)));
    }

    /** What looks need at random is reached as often as the probability says. */
    @ParameterizedTest
    @CsvSource({"1, 10", "1, 16", "10, 8"})
    void looksAreDetectedAsOftenAsTheProbabilitySays(int pulses, double ratio) {
        Decision decision = new RadarDetection.Chance(1e-6, pulses).on(RadarSignature.of(DroneClass.SMALL_UAV));
        SplittableRandom random = new SplittableRandom(SEED);
        int detected = 0;
        int looks = 20_000;
        for (int i = 0; i < looks; i++) {
            detected += ratio >= decision.threshold(random) ? 1 : 0;
        }
        double expected = decision.probability(ratio);
        assertThat((double) detected / looks)
                .as("seed %d", SEED)
                .isCloseTo(expected, within(4 * Math.sqrt(expected * (1 - expected) / looks)));
        assertThat(decision.probability(decision.evenThreshold())).isCloseTo(0.5, within(1e-8));
    }

    /** A narrow distribution is a steady target; a fixed threshold rises by the fluctuation loss. */
    @Test
    void theLimitIsASteadyTarget() {
        SquareLawDetector detector = new SquareLawDetector(1e-6, 1);
        assertThat(new LogNormalEcho(detector, 1e-4).required(0.9))
                .isCloseTo(detector.required(0.9, Fluctuation.STEADY), within(1e-3));
        Decision fixed = RadarDetection.FixedThreshold.DEFAULT.on(RadarSignature.of(DroneClass.SMALL_UAV));
        double loss = new LogNormalEcho(detector, 3.74).required(0.9) - detector.required(0.9, Fluctuation.STEADY);
        assertThat(fixed.evenThreshold()).isCloseTo(15 + loss, within(1e-9));
        assertThat(loss).isBetween(3.0, 7.0);
    }

    /** Ratios are kept for later; that of a spread which no other test has is found for the first time. */
    @Test
    void aRatioIsTheSameWhenItIsSoughtAgain() {
        long seed = System.nanoTime();
        double spread = new SplittableRandom(seed).nextDouble(2, 6);
        SquareLawDetector detector = new SquareLawDetector(1e-6, 1);
        for (double probability : new double[] {0.1, 0.5, 0.95}) {
            double first = new LogNormalEcho(detector, spread).required(probability);
            LogNormalEcho again = new LogNormalEcho(detector, spread);
            assertThat(again.probability(first)).as("seed %d", seed).isCloseTo(probability, within(1e-9));
            assertThat(again.required(probability)).as("seed %d", seed).isEqualTo(first);
        }
    }

    @Test
    void settingsExcludeOneAnother() {
        RadarSignature small = RadarSignature.of(DroneClass.SMALL_UAV);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> small.withCrossSection(1))
                .withMessage("droneClass and crossSection are mutually exclusive: omit one of them");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> small.withSpread(3))
                .withMessageContaining("spread");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> small.withFluctuation(Fluctuation.SWERLING_1))
                .withMessageContaining("droneClass and fluctuation");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> RadarSignature.DEFAULT.withSpread(21))
                .withMessageContaining("spread 21 dB must be above 0 and at most 20");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> RadarSignature.DEFAULT.withSpread(3).withFluctuation(Fluctuation.SWERLING_3))
                .withMessageContaining("spread and fluctuation");
    }
}
