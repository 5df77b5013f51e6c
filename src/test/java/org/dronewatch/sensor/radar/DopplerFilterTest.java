package org.dronewatch.sensor.radar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Explanation;
import org.dronewatch.sensor.radar.DopplerFilter.Canceller;
import org.dronewatch.sensor.radar.DopplerFilter.HighPass;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What filters let pass of an echo by its radial speed. */
class DopplerFilterTest {

    /** Half the power at the stated speed for every order, and 6 n dB an octave far below it. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 5, 20})
    void aHighPassFilterHasItsWidthAndItsSlope(int order) {
        HighPass filter = new HighPass(1.5, order);
        assertThat(filter.response(1.5)).isCloseTo(0.5, within(1e-12));
        assertThat(filter.response(-1.5)).isEqualTo(filter.response(1.5));
        assertThat(filter.response(0.0)).isZero();
        assertThat(filter.response(1e4)).isCloseTo(1.0, within(1e-7));
        double octave = 10.0 * Math.log10(filter.response(0.03) / filter.response(0.015));
        assertThat(octave).isCloseTo(order * 20.0 * Math.log10(2.0), within(0.01));
        assertThat(HighPass.of(1.5)).isEqualTo(new HighPass(1.5, 2));
    }

    /**
     * The response is that of the sum of N pulses with binomial weights of alternating sign, relative to its greatest.
     */
    @ParameterizedTest
    @CsvSource({"2, 80", "3, 80", "5, 31.7", "10, 12"})
    void aCancellerIsTheSumOfItsPulses(int pulses, double blind) {
        Canceller filter = new Canceller(pulses, blind);
        for (double speed = -2.5 * blind; speed <= 2.5 * blind; speed += 0.0371 * blind) {
            // An echo turns by a whole turn from pulse to pulse at the first blind speed.
            double turn = 2.0 * Math.PI * speed / blind;
            double re = 0.0;
            double im = 0.0;
            double weight = 1.0;
            for (int k = 0; k < pulses; k++) {
                re += weight * Math.cos(k * turn);
                im += weight * Math.sin(k * turn);
                weight *= -(pulses - 1.0 - k) / (k + 1.0);
            }
            double greatest = Math.pow(2.0, 2.0 * (pulses - 1));
            assertThat(filter.response(speed)).isCloseTo((re * re + im * im) / greatest, within(1e-12));
        }
        assertThat(filter.response(0.0)).isZero();
        assertThat(filter.response(blind)).isZero();
        assertThat(filter.response(3.0 * blind)).as("but for rounding").isLessThan(1e-28);
        assertThat(filter.response(0.5 * blind)).isEqualTo(1.0);
    }

    /** The limit that an explanation gives is the speed from which on just enough passes. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-6, 0.01, 0.3, 0.5, 0.999})
    void theLimitIsWhereEnoughPasses(double needed) {
        for (DopplerFilter filter : new DopplerFilter[] {new HighPass(2.0, 3), new Canceller(3, 40.0)}) {
            Explanation slow = filter.miss(-0.01, needed);
            assertThat(slow.cause()).isEqualTo(Cause.TOO_SLOW);
            assertThat(filter.response(slow.limit().orElseThrow())).isCloseTo(needed, within(1e-9));
        }
        Canceller canceller = new Canceller(3, 40.0);
        Explanation fast = canceller.miss(-80.5, needed);
        assertThat(fast.cause()).isEqualTo(Cause.TOO_FAST);
        assertThat(fast.limit().orElseThrow()).isBetween(60.0, 80.0);
        assertThat(canceller.response(fast.limit().orElseThrow())).isCloseTo(needed, within(1e-9));
    }

    /** Where nothing less than the whole echo would do, no speed is enough. */
    @Test
    void whatNeedsEverythingHasNoLimit() {
        assertThat(new HighPass(2.0, 3).miss(1.0, 1.0)).isEqualTo(Explanation.of(Cause.TOO_SLOW));
        assertThat(new Canceller(2, 40.0).miss(1.0, 1.0).limit().orElseThrow()).isEqualTo(20.0);
    }

    @Test
    void settingsHaveLimits() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new HighPass(0.0, 2))
                .withMessage("halfPowerSpeed 0 m/s must be above 0 and at most 1000");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Canceller(1, 40.0))
                .withMessage("pulses 1 must be 2 to 10");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Canceller(2, Double.NaN))
                .withMessageContaining("blindSpeed");
    }
}
