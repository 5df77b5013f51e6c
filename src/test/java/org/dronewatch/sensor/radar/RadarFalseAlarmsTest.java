package org.dronewatch.sensor.radar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Map;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.alarm.FalseAlarmRate;
import org.junit.jupiter.api.Test;

/** How many cells a radar decides on, and how often noise passes its threshold. */
class RadarFalseAlarmsTest {
    private static final Position PLACE = new Position(0, 0, 10);

    /** With the limits of the catalogue's entry, and hardware that its data sheet does not state. */
    private static RadarSettings blighter() {
        RadarSettings entry = (RadarSettings) Catalog.packaged().settings("blighter-a400", Map.of("position", PLACE));
        return entry.withBudget(LinkBudget.Hardware.of(4, 33, 0.02));
    }

    /** By hand: 9950 m in cells of 14.99 m, 174 beams, 2 x 99 m/s in cells of 0.454 m/s. */
    @Test
    void theCellsOfAHardwareBudget() {
        RadarSettings radar = blighter().withFalseAlarms(RadarFalseAlarms.DEFAULT.withProbability(1e-6));
        FalseAlarmRate rate = radar.falseAlarmRate().orElseThrow();
        double cells = 664.0 * 174.0 * 436.0;
        assertThat(rate.perLook()).isCloseTo(cells * 1e-6, within(1e-9));
        assertThat(rate.perHour()).isCloseTo(cells * 1e-6 * 0.1 * 3600, within(1e-6));
        assertThat(rate.cells()).isEqualTo((long) Math.floor(cells / 27));
        assertThat(rate.looks()).isEqualTo(1);
        // The chance that none of all cells gives a false alarm: exp(-n p) for rare ones.
        assertThat(Math.pow(1.0 - rate.probability(), rate.cells())).isCloseTo(Math.exp(-cells * 1e-6), within(1e-12));
    }

    /** 90 x 20 degrees by a beam of 3 x 5: 30 x 4, a fan of 3 degrees: 30, a fixed beam: 1. */
    @Test
    void theBeamsOfABeam() {
        RadarSettings radar = RadarSettings.at(PLACE, LinkBudget.Hardware.of(1, 30, 0.01))
                .withFieldOfView(Math.toRadians(90), Math.toRadians(20))
                .withFalseAlarms(RadarFalseAlarms.DEFAULT.withProbability(1e-7));
        BeamPattern pencil = BeamPattern.of(Math.toRadians(3), Math.toRadians(5));
        BeamPattern fan = pencil.withSteering(BeamPattern.Steering.AZIMUTH);
        double one = perLook(radar.withBeam(pencil.withSteering(BeamPattern.Steering.NONE)));
        assertThat(perLook(radar.withBeam(fan))).isCloseTo(30 * one, within(1e-9));
        assertThat(perLook(radar.withBeam(pencil))).isCloseTo(120 * one, within(1e-9));
    }

    /** 2 x 100 instead of 2 x 99 m/s in cells of 0.454 m/s. */
    @Test
    void withANotchSlowSpeedsCountToo() {
        RadarSettings radar = blighter().withFalseAlarms(RadarFalseAlarms.DEFAULT.withProbability(1e-6));
        assertThat(perLook(radar.withNotch(DopplerFilter.HighPass.of(1))))
                .isCloseTo(664.0 * 174.0 * 441.0 * 1e-6, within(1e-9));
    }

    private static double perLook(RadarSettings radar) {
        return radar.falseAlarmRate().orElseThrow().perLook();
    }

    @Test
    void theProbabilityIsThatOfTheDetectionOrOfTheDataSheet() {
        RadarFalseAlarms thousand = RadarFalseAlarms.DEFAULT.withCells(1000).withGate(1);
        RadarSettings sheet = RadarSettings.at(
                        PLACE,
                        new LinkBudget.DataSheet(
                                1000, 0.01, 0.9, 1e-5, org.dronewatch.drone.RadarSignature.Fluctuation.STEADY))
                .withFalseAlarms(thousand);
        assertThat(perLook(sheet)).isCloseTo(0.01, within(1e-12));
        assertThat(sheet.falseAlarmRate().orElseThrow().cells()).isEqualTo(1000);
        assertThat(perLook(sheet.withDetection(new RadarDetection.Chance(1e-3, 10))))
                .isCloseTo(1.0, within(1e-12));
        assertThat(perLook(sheet.withFalseAlarms(thousand.withProbability(0.002))))
                .isCloseTo(2.0, within(1e-12));
        assertThat(sheet.withFalseAlarms(thousand.withGate(5000))
                        .falseAlarmRate()
                        .orElseThrow()
                        .cells())
                .isEqualTo(1);
    }

    /** There and back again: the probability for 20 an hour gives 20 an hour. */
    @Test
    void theThresholdForAWantedRate() {
        RadarSettings radar = blighter();
        double probability = radar.falseAlarmProbability(20);
        RadarSettings set = radar.withFalseAlarms(RadarFalseAlarms.DEFAULT.withProbability(probability));
        assertThat(set.falseAlarmRate().orElseThrow().perHour()).isCloseTo(20.0, within(1e-9));
    }

    @Test
    void whatIsMissingOrTooMuchIsSaid() {
        RadarSettings sheet = RadarSettings.at(PLACE, LinkBudget.DataSheet.of(1000, 0.01));
        RadarFalseAlarms none = RadarFalseAlarms.DEFAULT;
        assertThatThrownBy(() -> sheet.withFalseAlarms(none)).hasMessageStartingWith("falseAlarms.cells is missing");
        assertThatThrownBy(() -> sheet.falseAlarmProbability(5)).hasMessageStartingWith("falseAlarms.cells is missing");
        assertThatThrownBy(() -> blighter().withFalseAlarms(none))
                .hasMessageStartingWith("falseAlarms.probability is missing");
        assertThatThrownBy(() -> sheet.withDetection(RadarDetection.Chance.DEFAULT)
                        .withFalseAlarms(none.withCells(10).withProbability(1e-6)))
                .hasMessageContaining("are mutually exclusive");
        assertThatThrownBy(() -> blighter().withFalseAlarms(none.withProbability(1e-4)))
                .hasMessage(
                        "falseAlarms: 50373696 cells, each with a probability of 0.0001, raise 5037 false alarms per"
                                + " scan; there must be at most 1000");
        assertThatThrownBy(() -> none.withGate(0.5)).hasMessage("gate 0.5 must be 1 to 1e6");
    }

    /** A million cells, each with one in a thousand, are as many as are allowed. */
    @Test
    void aThousandPerScanAreAllowed() {
        RadarSettings sheet = RadarSettings.at(PLACE, LinkBudget.DataSheet.of(1000, 0.01));
        RadarFalseAlarms million = RadarFalseAlarms.DEFAULT.withCells(1e6);
        assertThat(perLook(sheet.withFalseAlarms(million.withProbability(1e-3))))
                .isEqualTo(1000.0);
        assertThatThrownBy(() -> sheet.withFalseAlarms(million.withProbability(1.001e-3)))
                .hasMessageContaining("there must be at most 1000");
    }
}
