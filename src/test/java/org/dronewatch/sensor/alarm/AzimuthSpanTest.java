package org.dronewatch.sensor.alarm;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class AzimuthSpanTest {
    /** Against brute force: a hundred thousand bearings at equal steps. */
    @Test
    void agreesWithCountingBearings() {
        long seed = 20_251_124L;
        System.out.println("seed " + seed);
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < 200; i++) {
            AzimuthSpan span = new AzimuthSpan(random.nextDouble(-9, 9), random.nextDouble(0.01, 2.0 * Math.PI));
            double angle = random.nextDouble(0, Math.PI);
            double azimuth = random.nextDouble(-9, 9);
            int inside = 0;
            int all = 100_000;
            for (int k = 0; k < all; k++) {
                double off = Math.IEEEremainder(span.at((k + 0.5) / all) - azimuth, 2.0 * Math.PI);
                inside += Math.abs(off) <= angle ? 1 : 0;
            }
            assertThat(span.probabilityWithin(angle, azimuth)).isCloseTo((double) inside / all, within(5e-5));
        }
    }

    /** A fraction counts clockwise, like an azimuth. */
    @Test
    void fractionsBeginAtTheCounterClockwiseEnd() {
        AzimuthSpan span = new AzimuthSpan(1.0, 0.5);
        assertThat(span.at(0.0)).isEqualTo(0.75);
        assertThat(span.at(0.25)).isEqualTo(0.875);
        assertThat(span.at(0.5)).isEqualTo(1.0);
        assertThat(span.at(1.0)).isEqualTo(1.25);
    }

    @Test
    void allRoundAndNothing() {
        assertThat(AzimuthSpan.ALL.probabilityWithin(Math.PI, 1.0)).isCloseTo(1.0, within(1e-12));
        assertThat(AzimuthSpan.ALL.probabilityWithin(Math.toRadians(10), -3.0)).isCloseTo(20.0 / 360.0, within(1e-12));
        assertThat(new AzimuthSpan(0.0, 0.5).probabilityWithin(0.1, Math.PI)).isZero();
        assertThat(new AzimuthSpan(0.0, 0.5).probabilityWithin(0.0, 0.0)).isZero();
        assertThatThrownBy(() -> new AzimuthSpan(0.0, 0.0)).hasMessageContaining("width 0.0 rad");
    }
}
