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
import org.junit.jupiter.params.provider.MethodSource;

/**
 * No radar of the catalogue contradicts physics or itself, and each keeps its promise with the probability that belongs
 * to it.
 */
class CatalogRadarTest {
    private static final Position SENSOR = new Position(0, 0, 10);

    /** What data sheets mean by a range unless they say otherwise (Skolnik, Radar Handbook). */
    private static final double USUAL_PROBABILITY = 0.9;

    private static final double USUAL_FALSE_ALARM = 1e-6;

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
    void theCatalogueHasRadarsOfBothKinds() {
        assertThat(radars()).hasSizeGreaterThanOrEqualTo(5);
        assertThat(radars().stream()
                        .<Class<?>>map(name -> settings(name).budget().getClass()))
                .contains(Hardware.class, DataSheet.class);
    }

    /**
     * A sphere has 4 pi; a beam of gain G fills 4 pi / G of it, and a band of azimuths and elevations its own solid
     * angle.
     */
    @ParameterizedTest
    @MethodSource("radars")
    void aScanIsLongEnoughForItsBeams(String name) {
        RadarSettings radar = settings(name);
        if (radar.budget() instanceof Hardware hardware) {
            double band = radar.azimuthWidth() * 2.0 * Math.sin(0.5 * radar.elevationWidth());
            double beams = band / (4.0 * Math.PI / Math.pow(10.0, 0.1 * hardware.gain()));
            assertThat(beams * hardware.integrationTime() * radar.rate()).isBetween(0.5, 1.0);
        }
        assertThat(radar.advice()).isEmpty();
    }

    /** A gain of 33 dBi and a beam of 10 x 10 degrees contradict each other: such an entry would not pass. */
    @ParameterizedTest
    @MethodSource("radars")
    void noBeamIsWiderThanItsGainAllows(String name) {
        RadarSettings radar = settings(name);
        if (radar.budget() instanceof Hardware hardware) {
            radar.beam().ifPresent(beam -> assertThat(hardware.gain()).isLessThanOrEqualTo(beam.largestGain()));
            BeamPattern wide = BeamPattern.of(Math.toRadians(10), Math.toRadians(10));
            assertThat(radar.withBeam(wide).advice()).hasSize(1);
        }
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
            double falseAlarm = radar.budget() instanceof DataSheet sheet ? sheet.falseAlarm() : USUAL_FALSE_ALARM;
            RadarSettings chance = radar.withDetection(new RadarDetection.Chance(falseAlarm, 1));
            Assessment at = assess(chance, open(), coming(range, range.distance()));
            if (radar.budget() instanceof DataSheet sheet) {
                assertThat(at.probability()).isCloseTo(sheet.probability(), within(1e-9));
                assertThat(assess(chance, open(), coming(range, 1.05 * range.distance()))
                                .probability())
                        .isLessThan(sheet.probability() - 0.1);
            } else {
                assertThat(at.probability()).isGreaterThan(USUAL_PROBABILITY);
            }
            Drone drone = coming(range, range.distance());
            assertThat(at.probability())
                    .isEqualTo(Detectability.probability(
                            at.quantity(), falseAlarm, drone.settings().radar().fluctuation()));
            assertThat(assess(radar, open(), drone).margin())
                    .as("its own threshold is just met")
                    .isBetween(-1e-4, 0.3);
        }
    }
}
