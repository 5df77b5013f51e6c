package org.dronewatch.sensor.radar;

import static org.assertj.core.api.Assertions.assertThat;

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
                        "with a fixed threshold of 15 dB, the target of the data sheet is detected up to %.4g m, not 500 m;"
                                + " 'detection: chance' or a 'signalToNoise' of 13.18 dB gives the range of the data sheet",
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

    @Test
    void aLowThresholdReachesFartherThanTheDataSheet() {
        RadarSettings radar = radar(DataSheet.of(RANGE, CROSS_SECTION)).withDetection(new FixedThreshold(10.0));
        assertThat(radar.advice()).singleElement().asString().contains("up to 600.6 m, not 500 m");
    }
}
