package org.dronewatch.sound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ToneTest {
    private static final double SOUND = 343.2;

    @ParameterizedTest
    @CsvSource({"15, 1.0457", "-15, 0.9581", "0, 1"})
    void motionShiftsTheFrequency(double approach, double factor) {
        assertThat(new Tone(1, 205.0, 0.5).heard(approach, SOUND).orElseThrow() / 205.0)
                .isCloseTo(factor, within(5e-5));
    }

    /**
     * Brute force: wave crests leave a drone that flies past 30 m to the side, each arrives a path later; counted at
     * the end.
     */
    @Test
    void crestsArriveAtTheHeardFrequency() {
        double speed = 15.0;
        for (double along : new double[] {-200, -40, 0, 25, 300}) {
            double period = 1.0 / 205.0;
            double before = arrival(along, -0.5 * period, speed);
            double after = arrival(along, 0.5 * period, speed);
            double approach = -speed * along / Math.hypot(along, 30.0);
            assertThat(new Tone(1, 205.0, 0.5).heard(approach, SOUND).orElseThrow())
                    .isCloseTo(1.0 / (after - before), within(1e-4));
        }
    }

    private static double arrival(double along, double time, double speed) {
        return time + Math.hypot(along + speed * time, 30.0) / SOUND;
    }

    @Test
    void fromTheSpeedOfSoundOnThereIsNoTone() {
        assertThat(new Tone(1, 205.0, 0.5).heard(SOUND, SOUND)).isEmpty();
        assertThat(new Tone(1, 205.0, 0.5).heard(400.0, SOUND)).isEmpty();
        assertThat(new Tone(1, 205.0, 0.5).heard(-400.0, SOUND)).isPresent();
    }
}
