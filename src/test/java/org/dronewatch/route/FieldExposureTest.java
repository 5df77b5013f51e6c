package org.dronewatch.route;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.SplittableRandom;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.ProbabilityStep;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.exposure.LegMotion;
import org.dronewatch.route.search.RouteExposure;
import org.dronewatch.route.search.RouteMode;
import org.dronewatch.route.search.RoutePath;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.Cause;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Rates of a radar that looks once a second, detects what moves radially within 150 m, and not behind boxes. */
class FieldExposureTest {
    private static final FieldGrid GRID = new FieldGrid(0, 0, 500, 20, List.of(10.0, 26.0, 60.0));
    private static final Position RADAR = new Position(0, 0, 4);
    private static final double CERTAIN = -Math.log(1e-6);

    @TempDir
    private Path directory;

    private FieldSite site;
    private DetectionField field;

    @BeforeEach
    void assess() throws IOException {
        site = FieldSite.in(
                directory, FieldSite.ROUND + "alert: {protect: {centre: [0, 0, 10], radius: 30}, response: 5 s}\n");
        field = site.field(GRID, 2);
    }

    private FieldExposure exposure() {
        DroneSettings drone = site.settings().drones().get(FieldSite.DRONE);
        return FieldExposure.of(ModeField.powered(field, drone), site.settings());
    }

    private double rate() {
        return site.settings().enabledSensors().get("round").rate();
    }

    private static LegMotion motion(double heading) {
        return RouteMode.free("powered", 12.0).motion(heading);
    }

    @Test
    void ratesAreThoseOfTheLooksInEveryCell() {
        FieldExposure exposure = exposure();
        long seed = 31;
        SplittableRandom random = new SplittableRandom(seed);
        int detecting = 0;
        for (int i = 0; i < 2000; i++) {
            int level = random.nextInt(3);
            int column = random.nextInt(25);
            int row = random.nextInt(25);
            int course = random.nextInt(8);
            Position at = field.middle(level, column, row);
            double found = exposure.rate(at.x(), at.y(), at.z(), motion(2.0 * Math.PI * course / 8), 0);
            int crossing = crossing(at, course);
            int step = field.step(0, level, column, row, crossing >= 0 ? crossing : course);
            double p = ProbabilityStep.probability(step);
            double expected = p == 1.0 ? rate() * CERTAIN : -rate() * Math.log(1.0 - p);
            assertThat(found).as("seed %d, cell %d", seed, i).isCloseTo(expected, within(1e-6 * (1.0 + expected)));
            Position edge = new Position(at.x() + 9.9, at.y() - 9.9, at.z());
            assertThat(exposure.least(at, edge, 0)).isLessThanOrEqualTo(found);
            detecting += found > 0.0 ? 1 : 0;
        }
        assertThat(detecting).isBetween(200, 1800);
    }

    /**
     * Far away, each look of a radar hardly ever detects the drone, but it looks ten times a second: its rate is kept
     * to a factor of two down to 4e-5 per second.
     */
    @Test
    void seldomDetectionsAreKeptByTheirSize() throws IOException {
        site = FieldSite.in(
                directory,
                """
                  round: {kind: radar, position: [0, 0, 4], minRange: 1, maxRange: 900, elevationWidth: 90 deg, rate: 10,
                    minSpeed: 0 m/s, budget: {range: 100, crossSection: 0.01}, detection: {kind: chance, pulses: 8}}
                """);
        field = site.field(GRID, 2);
        FieldExposure exposure = exposure();
        int seldom = 0;
        for (int cell = 0; cell < GRID.cells(); cell++) {
            int column = cell % GRID.columns();
            int row = cell / GRID.columns();
            double p = field.assess(0, 2, column, row, 0).orElseThrow().probability();
            if (p > 0.0 && p < 0.002) {
                Position at = field.middle(2, column, row);
                double kept = exposure.rate(at.x(), at.y(), at.z(), motion(0.0), 0);
                double exact = 10.0 * -Math.log1p(-p);
                assertThat(kept)
                        .isLessThanOrEqualTo(2.01 * Math.max(exact, 2e-5))
                        .isGreaterThanOrEqualTo(exact / 2.01);
                seldom++;
            }
        }
        assertThat(seldom).isGreaterThan(50);
    }

    /** Between the middles of eight cells, each contributes by how near it is along each axis. */
    @Test
    void ratesAreInterpolatedBetweenTheMiddlesOfCells() throws IOException {
        site = FieldSite.in(directory, FieldSite.ROUND.replace("minSpeed: 3 m/s", "minSpeed: 0 m/s"));
        field = site.field(GRID, 2);
        FieldExposure exposure = exposure();
        long seed = 37;
        SplittableRandom random = new SplittableRandom(seed);
        int mixed = 0;
        List<Double> heights = GRID.heights();
        for (int i = 0; i < 2000; i++) {
            int level = random.nextInt(2);
            int column = random.nextInt(24);
            int row = random.nextInt(24);
            double[] shares = random.doubles(3).toArray();
            LegMotion motion = motion(2.0 * Math.PI * random.nextInt(8) / 8);
            Position low = field.middle(level, column, row);
            Position high = field.middle(level + 1, column + 1, row + 1);
            double expected = 0.0;
            double weights = 0.0;
            double ground = 0.0;
            double least = Double.POSITIVE_INFINITY;
            double most = 0.0;
            for (int corner = 0; corner < 8; corner++) {
                int u = corner & 1;
                int v = corner >> 1 & 1;
                int w = corner >> 2;
                double plan = Math.abs(1 - u - shares[0]) * Math.abs(1 - v - shares[1]);
                ground += 0.5 * plan * field.ground(column + u, row + v);
                if (field.isOpen(level + w, column + u, row + v)) {
                    Position at = field.middle(level + w, column + u, row + v);
                    double rate = exposure.rate(at.x(), at.y(), at.z(), motion, 0);
                    double weight = plan * Math.abs(1 - w - shares[2]);
                    expected += weight * rate;
                    weights += weight;
                    least = Math.min(least, rate);
                    most = Math.max(most, rate);
                }
            }
            Position at = new Position(
                    low.x() + shares[0] * (high.x() - low.x()),
                    low.y() + shares[1] * (high.y() - low.y()),
                    ground + (1.0 - shares[2]) * heights.get(level) + shares[2] * heights.get(level + 1));
            double found = exposure.rate(at.x(), at.y(), at.z(), motion, 0);
            assertThat(exposure.least(at, at, 0)).isLessThanOrEqualTo((1.0 + 1e-12) * found);
            if (weights > 0.0) {
                assertThat(found).as("seed %d, cell %d", seed, i).isCloseTo(expected / weights, within(1e-6));
                mixed += least < most ? 1 : 0;
            }
        }
        assertThat(mixed).isGreaterThan(50);
    }

    /** The mean along a leg is that of the rates at ten thousand points of it, whatever the leg passes. */
    @Test
    void theMeanAlongALegIsThatOfManyPoints() {
        FieldExposure exposure = exposure();
        long seed = 38;
        SplittableRandom random = new SplittableRandom(seed);
        int partly = 0;
        for (int i = 0; i < 60; i++) {
            Position from = anywhere(random);
            Position to = anywhere(random);
            Position along = to.minus(from);
            LegMotion motion = LegMotion.along(along.x(), along.y(), along.z(), along.length() / 12.0);
            double sum = 0.0;
            int points = 10_000;
            for (int point = 0; point < points; point++) {
                Position at = from.plus(along.times((point + 0.5) / points));
                sum += exposure.rate(at.x(), at.y(), at.z(), motion, 0);
            }
            double mean = exposure.mean(from, to, motion, 0, 10.0);
            // A radar's blindness to part of a cell is found on pieces of 2.5 m.
            assertThat(mean).as("seed %d, leg %d", seed, i).isCloseTo(sum / points, within(0.02 * rate() * CERTAIN));
            partly += mean > 0.1 && mean < 0.9 * rate() * CERTAIN ? 1 : 0;
        }
        assertThat(partly).isGreaterThan(20);
    }

    private static Position anywhere(SplittableRandom random) {
        return new Position(
                480 * (random.nextDouble() - 0.5), 480 * (random.nextDouble() - 0.5), 10 + 50 * random.nextDouble());
    }

    /** On both courses across its line of sight, the radar is blind; elsewhere it is not. */
    @Test
    void aCourseAcrossTheLineOfSightHasItsOwnRate() {
        FieldExposure exposure = exposure();
        double bearing = Math.atan2(90.0, -50.0);
        for (double side = -1.0; side <= 1.0; side += 2.0) {
            double across = bearing + side * Math.PI / 2;
            assertThat(exposure.rate(90.0, -50.0, 60.0, motion(across), 0)).isEqualTo(0.0);
            assertThat(exposure.rate(90.0, -50.0, 60.0, motion(across + Math.toRadians(4.9)), 0))
                    .isEqualTo(0.0);
        }
        assertThat(exposure.rate(90.0, -50.0, 60.0, motion(bearing), 0)).isCloseTo(rate() * CERTAIN, within(1e-6));
    }

    /** At any position, heading, speed and climb, in cells that are in sight: as if the drone were assessed there. */
    @Test
    void aRadarIsBlindExactlyWhereTheRadialSpeedIsTooLow() {
        FieldExposure exposure = exposure();
        Assessor assessor = new Assessor(
                "round",
                site.settings().enabledSensors().get("round"),
                site.stage().world());
        Drone drone = DetectionField.droneOf(site.stage(), FieldSite.DRONE);
        SplittableRandom random = new SplittableRandom(5);
        int blind = 0;
        int compared = 0;
        while (compared < 1500) {
            int level = random.nextInt(3);
            Position at = field.middle(level, random.nextInt(25), random.nextInt(25))
                    .plus(new Position(random.nextDouble(), random.nextDouble(), random.nextDouble()).times(9.0));
            Position away = at.minus(RADAR).unit().times(12.0);
            LegMotion receding = LegMotion.along(away.x(), away.y(), away.z(), 1.0);
            double heading = 2.0 * Math.PI * random.nextDouble();
            double speed = 4.0 + 8.0 * random.nextDouble();
            LegMotion motion = LegMotion.along(
                    speed * Math.sin(heading), speed * Math.cos(heading), 6.0 * (random.nextDouble() - 0.5), 1.0);
            // Beside what hides the drone, the rate lies between those of cells.
            boolean isSeen = exposure.rate(at.x(), at.y(), at.z(), receding, 0) > 0.999999 * rate() * CERTAIN
                    && isDetected(assessor, drone, at, receding);
            if (isSeen) {
                boolean isExpected = isDetected(assessor, drone, at, motion);
                assertThat(exposure.rate(at.x(), at.y(), at.z(), motion, 0))
                        .as("%s, %s", at, motion)
                        .isCloseTo(isExpected ? rate() * CERTAIN : 0.0, within(1e-6));
                blind += isExpected ? 0 : 1;
                compared++;
            }
        }
        assertThat(blind).isBetween(300, 1000);
    }

    /** Coming closer by less than 3 m/s, a drone at 12 m/s is never detected: the lower bound of 0 is reached. */
    @Test
    void aSpiralRoundARadarIsNotExposed() {
        RouteMode mode = RouteMode.free("powered", 12.0);
        RouteExposure exposure = new RouteExposure(exposure(), List.of(mode), 1.0);
        List<Position> spiral = new ArrayList<>();
        double bearing = 0.0;
        for (double radius = 145.0; radius > 40.0; radius -= 0.5) {
            spiral.add(new Position(radius * Math.sin(bearing), radius * Math.cos(bearing), 26.0));
            bearing += 4.0 / radius;
        }
        double straight = exposure.leg(spiral.get(0), spiral.get(spiral.size() - 1), 0);
        assertThat(straight).isGreaterThan(20.0);
        assertThat(exposure.along(new RoutePath(spiral, Collections.nCopies(spiral.size() - 1, 0))))
                .isZero();
    }

    private static boolean isDetected(Assessor assessor, Drone drone, Position at, LegMotion motion) {
        Position velocity = new Position(motion.east(), motion.north(), motion.up());
        return assessor.assess(
                        drone.at(new FlightState(at, velocity, motion.heading())), Optional.empty(), new Random(0))
                .cause()
                .equals(Cause.DETECTED);
    }

    /** Only a course that is exactly that of the compass is nearer than one across the line of sight. */
    private int crossing(Position at, int course) {
        double heading = 2.0 * Math.PI * course / 8;
        for (int i = 8; i < field.courses().size(); i++) {
            Course other = field.courses().get(i);
            double angle = Math.abs(Math.IEEEremainder(other.heading(at) - heading, 2.0 * Math.PI));
            if (other.kind() == Course.Kind.CROSSING && angle == 0.0) {
                return i;
            }
        }
        return -1;
    }
}
