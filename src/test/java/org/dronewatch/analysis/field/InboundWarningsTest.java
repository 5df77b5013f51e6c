package org.dronewatch.analysis.field;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The warning of inbound flights, from the geometry of the boxes. */
class InboundWarningsTest {
    private static final FieldGrid GRID = new FieldGrid(0, 0, 500, 8, List.of(2.0, 26.0, 60.0));
    private static final Position RADAR = new Position(0, 0, 4);
    private static final String ZONE = "alert: {protect: {centre: [0, 0, 10], radius: 30}, response: 9.5 s}\n";

    @TempDir
    private Path directory;

    private InboundWarnings warnings(String sensors, int threads) throws IOException {
        return warnings(sensors, threads, GRID, FieldTerms.ONE_LOOK);
    }

    private InboundWarnings warnings(String sensors, int threads, FieldGrid grid, FieldTerms terms) throws IOException {
        FieldSite site = FieldSite.in(directory, sensors);
        try (Workers workers = new Workers(threads)) {
            return workers.call(() ->
                    InboundWarnings.of(site.settings(), site.stage(), FieldSite.DRONE, grid, terms, 0.5, cells -> {}));
        }
    }

    /** The radar detects what is within 150 m, not hidden, and not more than 45 degrees above it. */
    @Test
    void theWarningFollowsFromRangeAndShadows() throws IOException {
        InboundWarnings found = warnings(FieldSite.ROUND + ZONE, 1);
        assertThat(found.isZone()).isTrue();
        assertThat(found.target()).isEqualTo(new Position(0, 0, 10));
        assertThat(found.reach()).isEqualTo(250);
        assertThat(found.all()).hasSize(3 * 36);
        int compared = 0;
        int late = 0;
        for (Warning one : found.all()) {
            OptionalDouble expected = expected(one);
            if (expected.isPresent()) {
                compared++;
                double time = (expected.getAsDouble() - 30) / 12;
                assertThat(one.arrival()).as("to the safe side").isBetween(30 - 1e-9, 30 + 1.1e-3);
                assertThat(one.range().orElseThrow()).as("%s", one).isCloseTo(expected.getAsDouble(), within(1e-9));
                assertThat(one.time().orElseThrow()).as("%s", one).isCloseTo(time, within(1e-3));
                assertThat(one.isInTime(found.response())).isEqualTo(time >= 9.5);
                late += time < 9.5 ? 1 : 0;
            }
        }
        assertThat(compared).isGreaterThan(60);
        assertThat(late).as("behind the building, low").isPositive();
        assertThat(warnings(FieldSite.ROUND + ZONE, 8)).isEqualTo(found);
    }

    /** Empty where the size of the drone would matter, and over the hill. */
    private static OptionalDouble expected(Warning one) {
        for (double distance = 250; distance > 30; distance -= 8) {
            double x = distance * Math.sin(one.bearing());
            double y = distance * Math.cos(one.bearing());
            Position at = new Position(x, y, one.height());
            if (FieldSite.BOXES.get("terrain").contains(x, y)) {
                return OptionalDouble.empty();
            }
            boolean isInside = FieldSite.BOXES.values().stream()
                    .anyMatch(box -> box.contains(x, y) && one.height() < box.height());
            double range = at.distance(RADAR);
            double elevation = Math.toDegrees(Math.asin((one.height() - 4) / range));
            int hidden = 0;
            for (int corner = 0; corner < 8; corner++) {
                Position offset = new Position(
                        (corner & 1) == 0 ? -0.5 : 0.5, (corner & 2) == 0 ? -0.5 : 0.5, (corner & 4) == 0 ? -0.5 : 0.5);
                hidden += FieldSite.hidden(RADAR, at.plus(offset)).isPresent() ? 1 : 0;
            }
            if (range <= 150 && elevation < 45 && !isInside && hidden < 8) {
                return hidden > 0 ? OptionalDouble.empty() : OptionalDouble.of(distance);
            }
        }
        return OptionalDouble.empty();
    }

    /** A radar that reaches less far than the zone detects nothing in time; without a zone the sensors count. */
    @Test
    void whatIsDetectedTooLateHasNoWarning() throws IOException {
        InboundWarnings blind = warnings(FieldSite.ROUND.replace("maxRange: 150", "maxRange: 25") + ZONE, 2);
        assertThat(blind.all())
                .allMatch(one -> one.range().isEmpty() && one.time().isEmpty() && !one.isInTime(0.0));

        InboundWarnings open = warnings(
                FieldSite.ROUND + FieldSite.ROUND.replace("round", "other").replace("[0, 0, 4]", "[20, 40, 6]"), 2);
        assertThat(open.isZone()).isFalse();
        assertThat(open.target()).isEqualTo(new Position(10, 20, 5));
        assertThat(open.all()).allMatch(one -> one.arrival() == 0.0 && one.isInTime(open.response()));
    }

    /** The second zone reaches from 230 to 270 m east of the first, across the place where a flight would begin. */
    @Test
    void noFlightBeginsInAZone() throws IOException {
        InboundWarnings found = warnings(
                FieldSite.ROUND
                        + """
                        alert:
                          zones:
                            first: {centre: [0, 0], radius: 30, height: 20}
                            second: {area: [[230, -20], [270, -20], [270, 20], [230, 20]], height: 20}
                        """,
                2);

        assertThat(found.reach()).isEqualTo(Math.ceil(250 + Math.hypot(270, 20)));
        Warning east = found.all().get(9);
        assertThat(Math.toDegrees(east.bearing())).isCloseTo(90, within(1e-9));
        assertThat(east.arrival()).isCloseTo(270, within(2e-3));
        assertThat(found.all().get(0).arrival()).isCloseTo(30, within(0.2));
    }

    /** A small area: flights begin at 30 m + 12 m/s * 9.5 s, so that a radar of 150 m is not blamed for its size. */
    @Test
    void flightsBeginFarEnoughAwayForTheResponse() throws IOException {
        FieldGrid small = new FieldGrid(0, 0, 80, 8, List.of(26.0));
        InboundWarnings found = warnings(FieldSite.ROUND + ZONE, 2, small, FieldTerms.ONE_LOOK);

        assertThat(found.reach()).isEqualTo(145);
        assertThat(found.longest()).isCloseTo((145 - 30) / 12.0, within(1e-3));
        assertThat(found.undecided()).isZero();
        Warning free = found.all().get(5);
        assertThat(free.range()).hasValue(145);
        assertThat(free.isFromStart()).isTrue();
        assertThat(free.isInTime(found.response())).isTrue();
        Warning hidden = found.all().get(18);
        assertThat(hidden.isFromStart()).as("behind the box in the south").isFalse();
        assertThat(hidden.isLate(found.response())).isTrue();
    }

    /** The plain ends 500 m away, or 707 m at its corners: what is detected there at once may have been before. */
    @Test
    void beyondTheKnownGroundNothingIsDecided() throws IOException {
        String far = FieldSite.ROUND.replace("maxRange: 150", "maxRange: 2000") + ZONE.replace("9.5 s", "60 s");
        InboundWarnings found = warnings(far, 2, new FieldGrid(0, 0, 100, 10, List.of(60.0)), FieldTerms.ONE_LOOK);

        assertThat(found.reach()).isEqualTo(Math.ceil(500 * Math.sqrt(2)));
        Warning free = found.all().get(5);
        assertThat(free.range().orElseThrow()).isCloseTo(500 / Math.sin(Math.toRadians(50)), within(10.0));
        assertThat(free.isUndecided(60)).isTrue();
        assertThat(free.isLate(60)).isFalse();
        Warning hidden = found.all().get(0);
        assertThat(hidden.isLate(60)).as("behind the building in the north").isTrue();
        assertThat(found.late() + found.undecided()).isEqualTo(36);
        assertThat(found.late()).isBetween(1L, 35L);
    }

    /** The time that a sensor has to detect the drone passes before the response begins. */
    @Test
    void theTimeToDetectShortensTheLongestWarning() throws IOException {
        FieldTerms terms = new FieldTerms(FieldTerms.Turning.CUED, Optional.of(2.0));
        InboundWarnings wide = warnings(FieldSite.ROUND + ZONE, 2, GRID, terms);
        assertThat(wide.longest()).isCloseTo((250 - 30) / 12.0 - 2, within(1e-3));

        InboundWarnings small = warnings(FieldSite.ROUND + ZONE, 2, new FieldGrid(0, 0, 80, 8, List.of(26.0)), terms);
        assertThat(small.reach()).isEqualTo(30 + Math.ceil(12 * (9.5 + 2) + 1e-3));
        assertThat(small.longest()).isBetween(9.5, 9.6);
    }

    /** The flights that begin 271 m away cross a second zone, which ends at 270 m: they have to begin farther away. */
    @Test
    void aFartherZoneMayBeTheFirst() throws IOException {
        InboundWarnings found = warnings(
                FieldSite.ROUND
                        + """
                        alert:
                          response: 20 s
                          zones:
                            first: {centre: [0, 0], radius: 30, height: 20}
                            second: {area: [[230, -20], [270, -20], [270, 20], [230, 20]], height: 20}
                        """,
                2,
                new FieldGrid(0, 0, 80, 8, List.of(26.0)),
                FieldTerms.ONE_LOOK);

        assertThat(found.all().get(9).arrival()).isCloseTo(270, within(2e-3));
        assertThat(found.reach()).isEqualTo(511);
    }

    /** No sensor looks where another has already detected the drone: the first detection is that of the first. */
    @Test
    void theFirstOfSeveralSensorsCounts() throws IOException {
        String radar = FieldSite.ROUND.replace("maxRange: 150", "maxRange: 150, azimuthWidth: 120 deg");
        String ear =
                """
                  ear: {kind: acoustic, position: [0, 0, 4], propagation: {kind: level-model, initialRays: 4, reflectionsPerHit: 1, maxOrder: 1}}
                """;
        String eye = "  eye: {kind: camera, position: [0, 0, 4], fov: 40 deg, width: 800, height: 600}\n";
        FieldGrid grid = new FieldGrid(0, 0, 320, 16, List.of(10.0, 26.0));
        List<InboundWarnings> alone = new ArrayList<>();
        for (String sensor : List.of(ear, eye, radar)) {
            alone.add(warnings(sensor + ZONE, 2, grid, FieldTerms.ONE_LOOK));
        }
        InboundWarnings joint = warnings(ear + eye + radar + ZONE, 2, grid, FieldTerms.ONE_LOOK);
        Set<Integer> firsts = new HashSet<>();
        for (int flight = 0; flight < joint.all().size(); flight++) {
            double farthest = -1.0;
            int first = -1;
            for (int sensor = 0; sensor < alone.size(); sensor++) {
                double range = alone.get(sensor).all().get(flight).range().orElse(-1.0);
                if (range > farthest) {
                    farthest = range;
                    first = sensor;
                }
            }
            firsts.add(first);
            assertThat(joint.all().get(flight).range().orElse(-1.0)).isEqualTo(farthest);
        }
        assertThat(firsts).as("each sensor is the first somewhere").contains(0, 2);
    }
}
