package org.dronewatch.sensor.radar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dronewatch.drone.RadarSignature.Fluctuation;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.radar.LinkBudget.DataSheet;
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
}
