package org.dronewatch.catalog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dronewatch.sensor.Walls.assess;
import static org.dronewatch.sensor.Walls.cube;
import static org.dronewatch.sensor.Walls.open;

import java.util.List;
import java.util.Map;
import org.dronewatch.catalog.CatalogEntry.PublishedRange;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.radar.BeamPattern;
import org.dronewatch.sensor.radar.Detectability;
import org.dronewatch.sensor.radar.LinkBudget.DataSheet;
import org.dronewatch.sensor.radar.LinkBudget.Hardware;
import org.dronewatch.sensor.radar.RadarDetection;
import org.dronewatch.sensor.radar.RadarSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * No radar of the catalogue contradicts physics or itself, and each keeps its promise with the probability that belongs
 * to it.
 */
class CatalogRadarTest {
    private static final Position SENSOR = new Position(0, 0, 10);

    private static List<String> radars() {
        return Catalog.packagedNames().stream()
                .filter(name ->
                        Catalog.packaged().entry(name).orElseThrow().kind().equals("radar"))
                .toList();
    }

    private static RadarSettings settings(String name) {
        return (RadarSettings) Catalog.packaged().settings(name, Map.of("position", SENSOR));
    }

    /** A drone for which a range is published, at a distance, coming. */
    private static Drone coming(PublishedRange range, double distance) {
        Position place = SENSOR.plus(new Position(0, distance, 0));
        DroneSettings drone = range.droneOn(Hover.at(place));
        return cube(drone, place, new Position(0, -10, 0));
    }

    @Test
    void theCatalogueHasRadars() {
        assertThat(radars()).hasSizeGreaterThanOrEqualTo(5);
    }

    /** No hardware is published, and none is made up; nothing that is stated contradicts the rest. */
    @ParameterizedTest
    @MethodSource("radars")
    void whatIsNotPublishedIsNotMadeUp(String name) {
        RadarSettings radar = settings(name);
        assertThat(radar.budget()).isInstanceOf(DataSheet.class);
        assertThat(radar.beam()).isEmpty();
        assertThat(radar.advice()).isEmpty();
    }

    /** As long as no source says otherwise. */
    @ParameterizedTest
    @MethodSource("radars")
    void noneMeasuresElevation(String name) {
        assertThat(settings(name).accuracy().measuresElevation()).isFalse();
        assertThat(Catalog.packaged().entry(name).orElseThrow().note().replaceAll("\\s+", " "))
                .contains("No source states that the radar measures elevation");
    }

    /**
     * What the Blighter's note says of the hardware that its range takes, by the radar equation and by the solid angle:
     * {@code 4 pi / G} for each beam of 20 ms, and {@code 2 pi sin(e/2)} for half the horizon. The entry states both,
     * and scans no faster than they allow: 5 % more draws a warning.
     */
    @ParameterizedTest
    @CsvSource({"blighter-a400-m10s, 246, 4.9", "blighter-a400, 489, 9.8"})
    void theHardwareThatARangeTakesIsStatedAndAllowsItsScan(String name, long beams, double seconds) {
        RadarSettings radar = settings(name);
        double wavelength = 299_792_458.0 / radar.frequency();
        double noise = 1.380649e-23 * 290.0 / 0.02;
        double alone =
                4.0 * wavelength * wavelength * 0.01 / (Math.pow(4.0 * Math.PI, 3) * Math.pow(8000.0, 4) * noise);
        double gain = 0.5 * (13.1835 + 5.0 + 6.0 - 10.0 * Math.log10(alone));
        DataSheet sheet = (DataSheet) radar.budget();
        assertThat(sheet.gain().orElseThrow()).isCloseTo(gain, within(0.05));
        assertThat(sheet.integrationTime()).contains(0.02);
        double field = radar.azimuthWidth() * 2.0 * Math.sin(0.5 * radar.elevationWidth());
        long needed = (long) Math.ceil(field * Math.pow(10.0, 3.75) / (4.0 * Math.PI));
        assertThat(needed).isEqualTo(beams);
        assertThat(0.02 * needed).isCloseTo(seconds, within(0.05));
        assertThat(Catalog.packaged().entry(name).orElseThrow().note().replaceAll("\\s+", " "))
                .contains("37.5 dBi", beams + " beams and " + seconds + " s");

        assertThat(radar.advice()).isEmpty();
        assertThat(radar.withRate(1.05 * radar.rate()).advice())
                .singleElement()
                .asString()
                .startsWith("an antenna of 37.5 dBi needs at least " + beams + " beams to cover");

        // The program's own equation agrees: that hardware reaches 8 km.
        RadarSettings built = radar.withBudget(Hardware.of(4.0, gain, 0.02));
        assertThat(built.budget().range(radar.frequency(), 0.01, 13.1835)).isCloseTo(8000.0, within(0.1));
    }

    /** A data sheet with a beam and a dwell is checked as hardware is; with too little stated, nothing is. */
    @Test
    void aDataSheetIsCheckedAsFarAsItStates() {
        DataSheet sheet = DataSheet.of(1000, 0.01);
        RadarSettings radar = settings("spotterrf-c550").withBudget(sheet);
        RadarSettings pencil = radar.withBeam(BeamPattern.of(Math.toRadians(2), Math.toRadians(10)));
        assertThat(pencil.advice()).isEmpty();
        assertThat(radar.withBudget(sheet.withGain(30)).advice()).isEmpty();
        assertThat(radar.withBudget(sheet.withIntegrationTime(0.02)).advice()).isEmpty();
        // 45 x 2 positions of 20 ms: 1.8 s.
        RadarSettings dwelling = pencil.withBudget(sheet.withIntegrationTime(0.02));
        assertThat(dwelling.advice())
                .containsExactly(
                        "a beam of 2 x 10 deg needs 90 positions to cover 90 x 20 deg: at an integrationTime of 0.02"
                                + " s each, a scan takes 1.8 s, not 0.1429 s; lower the rate to 0.555 Hz, or the integrationTime to"
                                + " 0.00158 s");
        assertThat(dwelling.withRate(0.555).advice()).isEmpty();
        // Ten pulses, each of which is integrated for 20 ms: 18 s.
        RadarSettings pulsed = dwelling.withDetection(new RadarDetection.Chance(1e-6, 10));
        assertThat(pulsed.advice())
                .containsExactly(
                        "a beam of 2 x 10 deg needs 90 positions to cover 90 x 20 deg: at 10 pulses with an integrationTime"
                                + " of 0.02 s each, a scan takes 18 s, not 0.1429 s; lower the rate to 0.0555 Hz, the number"
                                + " of pulses, or the integrationTime to 0.000158 s");
        assertThat(pulsed.withRate(0.0555).advice()).isEmpty();
        assertThat(pulsed.withBudget(sheet.withIntegrationTime(0.000158)).advice())
                .isEmpty();
        assertThat(pencil.withBudget(sheet.withGain(40)).advice())
                .containsExactly(
                        "an antenna of 40 dBi cannot have a beam of 2 x 10 deg, whose gain is at most 33.1 dBi");
    }

    /**
     * With noise and chance, at the published range and for the stated target: exactly the probability of the data
     * sheet, or at least nine of ten where none is stated; at 1.05 times that range less than stated.
     */
    @ParameterizedTest
    @MethodSource("radars")
    void atThePublishedRangeTheStatedProbabilityIsMet(String name) {
        RadarSettings radar = settings(name);
        List<PublishedRange> ranges =
                Catalog.packaged().entry(name).orElseThrow().ranges();
        assertThat(ranges).isNotEmpty();
        for (PublishedRange range : ranges) {
            DataSheet sheet = (DataSheet) radar.budget();
            RadarSettings chance = radar.withDetection(new RadarDetection.Chance(sheet.falseAlarm(), 1));
            Assessment at = assess(chance, open(), coming(range, range.distance()));
            assertThat(at.probability()).isCloseTo(sheet.probability(), within(1e-9));
            assertThat(assess(chance, open(), coming(range, 1.05 * range.distance()))
                            .probability())
                    .isLessThan(sheet.probability() - 0.1);
            Drone drone = coming(range, range.distance());
            assertThat(at.probability())
                    .isEqualTo(Detectability.probability(
                            at.quantity(),
                            sheet.falseAlarm(),
                            drone.settings().radar().fluctuation()));
            assertThat(assess(radar, open(), drone).margin())
                    .as("its own threshold is just met")
                    .isBetween(-1e-4, 0.3);
        }
    }
}
