package org.dronewatch.sensor.radar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dronewatch.drone.RadarSignature.Fluctuation;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.radar.LinkBudget.DataSheet;
import org.dronewatch.sensor.radar.LinkBudget.Hardware;
import org.dronewatch.sensor.radar.RadarDetection.FixedThreshold;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The range of a data sheet against a fixed threshold that is not the one it implies. */
class RadarAdviceTest {
    private static final double RANGE = 500.0;
    private static final double CROSS_SECTION = 0.05;

    private static RadarSettings radar(DataSheet sheet) {
        return RadarSettings.at(new Position(0, 0, 5), sheet);
    }

    @Test
    void theDefaultThresholdFallsShortOfADataSheet() {
        DataSheet sheet = DataSheet.of(RANGE, CROSS_SECTION);
        RadarSettings radar = radar(sheet);
        double reached = sheet.range(radar.frequency(), CROSS_SECTION, 15.0);

        assertThat(reached).isBetween(450.0, 451.0);
        assertThat(radar.advice())
                .containsExactly(String.format(
                        Locale.ROOT,
                        "with a fixed threshold of 15 dB, the target of the data sheet is detected up to %.1f m, not 500 m; a"
                                + " 'signalToNoise' of 13.18 dB or 'detection: {kind: chance, falseAlarm: 1.0E-6}' gives the"
                                + " range of the data sheet",
                        reached));
        assertThat(radar.withDetection(RadarDetection.Chance.DEFAULT).advice()).isEmpty();
    }

    /** With the threshold that is advised, a target of the data sheet's fluctuation is detected up to its range. */
    @ParameterizedTest
    @EnumSource
    void theAdvisedThresholdGivesTheRange(Fluctuation fluctuation) {
        DataSheet sheet = new DataSheet(RANGE, CROSS_SECTION, 0.8, 1e-5, fluctuation);
        RadarSettings radar = radar(sheet);
        Matcher advised = Pattern.compile("'signalToNoise' of (\\S+) dB")
                .matcher(radar.advice().get(0));
        assertThat(advised.find()).isTrue();
        FixedThreshold threshold = new FixedThreshold(Double.parseDouble(advised.group(1)));

        assertThat(radar.withDetection(threshold).advice()).isEmpty();
        assertThat(sheet.range(
                        radar.frequency(),
                        CROSS_SECTION,
                        threshold.on(fluctuation).evenThreshold()))
                .isBetween(0.999 * RANGE, 1.001 * RANGE);
    }

    /** With the false alarms of the data sheet, its target has its probability at its range. */
    @Test
    void theAdvisedChanceGivesTheProbability() {
        DataSheet sheet = new DataSheet(RANGE, CROSS_SECTION, 0.8, 1e-4, Fluctuation.STEADY);
        RadarSettings radar = radar(sheet);
        assertThat(radar.advice()).singleElement().asString().contains("falseAlarm: 1.0E-4}");
        RadarDetection.Chance chance = new RadarDetection.Chance(1e-4, 1);
        double ratio = sheet.signalToNoise(radar.frequency(), CROSS_SECTION, RANGE);

        assertThat(chance.on(Fluctuation.STEADY).probability(ratio)).isCloseTo(0.8, within(1e-6));
    }

    /** Beyond its largest range the radar processes no echo, whatever the threshold. */
    @Test
    void thereIsNothingToSayBeyondTheLargestRange() {
        RadarSettings radar = radar(DataSheet.of(RANGE, CROSS_SECTION));
        assertThat(radar.withRanges(20, 450).advice()).isEmpty();
        assertThat(radar.withRanges(20, 451).advice()).hasSize(1);
    }

    @Test
    void longRangesAreWrittenOut() {
        assertThat(radar(DataSheet.of(20_000, CROSS_SECTION))
                        .withRanges(20, 30_000)
                        .advice())
                .singleElement()
                .asString()
                .contains("up to 18010 m, not 20000 m");
    }

    @Test
    void aLowThresholdReachesFartherThanTheDataSheet() {
        RadarSettings radar = radar(DataSheet.of(RANGE, CROSS_SECTION)).withDetection(new FixedThreshold(10.0));
        assertThat(radar.advice()).singleElement().asString().contains("up to 600.6 m, not 500 m");
    }

    /** A radar that looks no farther than the range of the data sheet gains nothing by a low threshold. */
    @Test
    void thereIsNothingToSayIfTheLargestRangeIsThatOfTheDataSheet() {
        RadarSettings radar = radar(DataSheet.of(RANGE, CROSS_SECTION)).withDetection(new FixedThreshold(10.0));
        assertThat(radar.withRanges(20, RANGE).advice()).isEmpty();
        assertThat(radar.withRanges(20, 1.001 * RANGE).advice()).hasSize(1);
    }

    /**
     * 174 beams of 10 pulses of 0.02 s take 34.8 s. Half a second is enough for a 69.6th of that: 0.287 ms for each. It
     * is the same for a data sheet that states gain and integration time.
     */
    @Test
    void aScanTakesTimeForAllPulsesOfAllBeams() {
        String advice = "an antenna of 33 dBi needs at least 174 beams to cover 180 x 20 deg: at 10 pulses with an"
                + " integrationTime of 0.02 s each, a scan takes 34.8 s, not 0.5 s; lower the rate to 0.0287 Hz,"
                + " the number of pulses, or the integrationTime to 0.000287 s";
        Hardware hardware = new Hardware(4, 33, 0.02, 10e6, 5, 6);
        RadarSettings radar = radar(DataSheet.of(RANGE, CROSS_SECTION))
                .withFieldOfView(Math.PI, Math.toRadians(20))
                .withDetection(new RadarDetection.Chance(1e-6, 10))
                .withRate(2);
        assertThat(radar.withBudget(hardware).advice()).containsExactly(advice);
        assertThat(radar.withBudget(hardware).withRate(0.0287).advice()).isEmpty();
        DataSheet stated = DataSheet.of(RANGE, CROSS_SECTION).withGain(33).withIntegrationTime(0.02);
        assertThat(radar.withBudget(stated).advice()).containsExactly(advice);
        assertThat(radar.withBudget(stated.withIntegrationTime(0.000287)).advice())
                .isEmpty();
        assertThat(radar.advice()).as("unstated").isEmpty();
    }

    /** A beam may have all the gain that its widths allow. */
    @Test
    void theLargestGainOfABeamIsPossible() {
        BeamPattern beam = BeamPattern.of(Math.toRadians(3), Math.toRadians(10));
        RadarSettings radar =
                radar(DataSheet.of(RANGE, CROSS_SECTION)).withFieldOfView(Math.toRadians(3), Math.toRadians(10));
        double most = beam.largestGain();
        assertThat(radar.withBeam(beam)
                        .withBudget(new Hardware(4, most, 0.02, 10e6, 5, 6))
                        .advice())
                .isEmpty();
        assertThat(radar.withBeam(beam)
                        .withBudget(new Hardware(4, Math.nextUp(most), 0.02, 10e6, 5, 6))
                        .advice())
                .hasSize(1);
    }
}
