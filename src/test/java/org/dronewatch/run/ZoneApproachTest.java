package org.dronewatch.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.flight.TerrainFollowing;
import org.dronewatch.fusion.ProtectedZone;
import org.dronewatch.fusion.Protection;
import org.dronewatch.geometry.Position;
import org.dronewatch.world.GroundPoint;
import org.junit.jupiter.api.Test;

/** Against every segment and every moment, one by one: what is skipped changes nothing, to the last bit. */
class ZoneApproachTest {
    private static final int SEGMENTS = 10_000;
    private static final long SEED = 20_261_126L;

    private static FlightPath path(SplittableRandom random, boolean overGround) {
        List<Position> corners = new ArrayList<>();
        for (int i = random.nextInt(2, 7); i > 0; i--) {
            corners.add(new Position(
                    random.nextDouble(-900.0, 900.0), random.nextDouble(-900.0, 900.0), random.nextDouble(5.0, 120.0)));
        }
        FlightPathSettings flight = overGround
                ? TerrainFollowing.over(
                        corners.stream()
                                .map(one -> new GroundPoint(one.x(), one.y()))
                                .toList(),
                        30.0)
                : new FlightPathSettings.Waypoints(corners);
        return flight.create(
                random.nextDouble(5.0, 40.0),
                random.nextDouble(1.0, 5.0),
                (x, y) -> OptionalDouble.of(40.0 * Math.sin(0.05 * x) * Math.cos(0.03 * y)));
    }

    private static OptionalDouble entered(FlightPath path, Protection zone, double simulated) {
        double step = simulated / SEGMENTS;
        for (int i = 1; i <= SEGMENTS; i++) {
            OptionalDouble share = zone.entry(
                    path.at((i - 1) * step).position(), path.at(i * step).position());
            if (share.isPresent()) {
                return OptionalDouble.of((i - 1 + share.getAsDouble()) * step);
            }
        }
        return OptionalDouble.empty();
    }

    private static double closest(FlightPath path, Protection zone, double simulated) {
        double closest = Double.POSITIVE_INFINITY;
        for (int i = 0; i <= SEGMENTS; i++) {
            closest = Math.min(
                    closest, zone.distance(path.at(i * (simulated / SEGMENTS)).position()));
        }
        return closest;
    }

    @Test
    void whatIsSkippedChangesNothing() {
        System.out.println("seed of the flights: " + SEED);
        SplittableRandom random = new SplittableRandom(SEED);
        int entries = 0;
        int flights = 60;
        for (int i = 0; i < flights; i++) {
            FlightPath path = path(random, i % 2 == 0);
            FlightPath unbounded = path::at;
            Protection zone = new Protection(
                    Optional.of(new ProtectedZone(new Position(0, 0, 20), random.nextDouble(10.0, 200.0))), List.of());
            double simulated = random.nextDouble(20.0, 200.0);
            OptionalDouble expected = entered(path, zone, simulated);
            ZoneApproach approach = new ZoneApproach(path, zone, simulated);

            assertThat(path.topSpeed()).isPresent();
            assertThat(approach.entered()).isEqualTo(expected);
            assertThat(new ZoneApproach(unbounded, zone, simulated).entered()).isEqualTo(expected);
            assertThat(approach.closest()).isEqualTo(closest(path, zone, simulated));
            entries += expected.isPresent() ? 1 : 0;
        }
        assertThat(entries).isBetween(flights / 5, 4 * flights / 5);
    }

    /** A drone at rest in the zone, and a run that was cut short before its first look. */
    @Test
    void aRunWithoutDurationIsWhereItBegins() {
        FlightPath rest = path(new SplittableRandom(1), false);
        Position start = rest.position(0.0);
        Protection around = new Protection(Optional.of(new ProtectedZone(start, 5.0)), List.of());
        Protection elsewhere =
                new Protection(Optional.of(new ProtectedZone(start.plus(new Position(0, 0, 50)), 5.0)), List.of());

        assertThat(new ZoneApproach(rest, around, 0.0).entered()).hasValue(0.0);
        assertThat(new ZoneApproach(rest, elsewhere, 0.0).entered()).isEmpty();
        assertThat(new ZoneApproach(rest, elsewhere, 0.0).closest()).isEqualTo(45.0);
    }
}
