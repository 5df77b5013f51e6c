package org.dronewatch.sensor.rf;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.radio.AntennaPattern;
import org.dronewatch.setting.SettingsForm;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Advice on receivers, at and beyond its limits. */
class RfAdviceTest {
    private static final RfSettings RECEIVER = RfSettings.at(new Position(0, 0, 0));

    private static List<String> ofRate(double rate, Dwell dwell) {
        return SettingsForm.with(RECEIVER, "rate", rate).withDwell(dwell).advice();
    }

    @Test
    void anEnvironmentWithoutEffectIsNamedWithBothFrequencies() {
        assertThat(RECEIVER.withEnvironment(ManMadeNoise.RURAL).advice())
                .containsExactly("environment has no effect: ITU-R P.372 gives its noise only up to 250 MHz, less"
                        + " than minFrequency, 400 MHz");
        assertThat(RECEIVER.withFrequencies(2.4e9, 6e9)
                        .withEnvironment(ManMadeNoise.BUSINESS)
                        .advice())
                .containsExactly("environment has no effect: ITU-R P.372 gives its noise only up to 900 MHz, less"
                        + " than minFrequency, 2400 MHz");
    }

    /** At the highest frequency with a figure, there still is one. */
    @ParameterizedTest
    @EnumSource(ManMadeNoise.class)
    void anEnvironmentCountsFromOneFrequencyOn(ManMadeNoise noise) {
        double highest = noise.highestFrequency();
        RfSettings just = RECEIVER.withFrequencies(highest, 6e9).withEnvironment(noise);
        assertThat(just.advice()).isEmpty();
        assertThat(just.withFrequencies(Math.nextUp(highest), 6e9).advice())
                .singleElement()
                .asString()
                .startsWith("environment has no effect");
    }

    @Test
    void aBeamMayHaveTheLargestGainOfItsWidths() {
        AntennaPattern beam = AntennaPattern.of(Math.toRadians(60), Math.toRadians(20));
        double largest = beam.largestGain();
        assertThat(RECEIVER.withBeam(beam).withGain(largest).advice()).isEmpty();
        assertThat(RECEIVER.withBeam(beam).withGain(Math.nextUp(largest)).advice())
                .singleElement()
                .asString()
                .startsWith("an antenna of ")
                .endsWith(" deg, whose gain is at most 15.3 dBi");
    }

    /** Dwells that fill a look fit into it; rounding may exceed it by a billionth. */
    @Test
    void dwellsMayFillALook() {
        assertThat(ofRate(1.0, Dwell.of(1.0))).isEmpty();
        assertThat(ofRate(1.0 + 1e-9, Dwell.of(1.0))).isEmpty();
        assertThat(ofRate(Math.nextUp(1.0 + 1e-9), Dwell.of(1.0)))
                .containsExactly("1 x 1 s of dwell is longer than a look of 1 s: set a rate of at most 1 Hz");
        // 3 x 0.1 is more than 0.3 in binary numbers.
        assertThat(ofRate(1.0 / 0.3, Dwell.of(0.1).withCount(3))).isEmpty();
        assertThat(ofRate(1.0, Dwell.of(1000).withCount(10_000)))
                .containsExactly("10000 x 1000 s of dwell is longer than a look of 1 s: set a rate of at most 1e-7 Hz");
    }

    @Test
    void eachContradictionHasItsOwnSentence() {
        RfSettings wrong = RECEIVER.withEnvironment(ManMadeNoise.CITY)
                .withBeam(AntennaPattern.of(2.0 * Math.PI, Math.PI))
                .withDwell(Dwell.of(2.0));
        assertThat(wrong.advice())
                .hasSize(3)
                .satisfiesExactly(
                        noise -> assertThat(noise).startsWith("environment"),
                        gain -> assertThat(gain).startsWith("an antenna of 0 dBi cannot have a beam of 360 x 180 deg"),
                        dwells -> assertThat(dwells).endsWith("set a rate of at most 0.5 Hz"));
    }
}
