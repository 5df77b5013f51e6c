package org.dronewatch.analysis.field;

import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.dronewatch.analysis.cell.FieldColumns;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.fusion.Protection;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.world.GroundPoint;

/**
 * The plan of straight flights to a target from all bearings: a row for each bearing, a column for each step inward.
 *
 * @param target point to which the flights lead, m
 * @param reach horizontal distance from that point at which they begin, m
 * @param step length of a step, m
 * @param heights above the ground, m
 */
record InboundFlights(Position target, double reach, double step, List<Double> heights) {
    /** The number of bearings. */
    static final int BEARINGS = 36;

    /** The greatest number of steps to which a flight is lengthened so that there is time for the response. */
    static final int MOST_STEPS = 2000;

    /** How far beyond the farthest corner of an area or zone flights begin, m: half the default side of a grid. */
    private static final double BEYOND = 250.0;

    /** How accurately the entry into a zone is found, m. */
    private static final double ACCURACY = 1e-3;

    /** Into how many steps a flight is divided to find where it enters a zone. */
    private static final int STEPS = 4000;

    /**
     * The flights over a grid. They begin half a side of the grid away from their target; if the grid is that of an
     * area, 250 m beyond its farthest corner. Where that is too near for a detection to leave the required response
     * time, they begin farther away, but not beyond the model of the site. If any of them would begin in a protected
     * zone, they begin 250 m beyond the farthest corner of all zones.
     */
    static InboundFlights of(SceneSettings settings, Stage stage, String drone, FieldGrid grid, FieldTerms terms) {
        Protection protection = stage.protection();
        Position target = InboundTarget.of(settings, protection, grid);
        double asked =
                grid.area().map(area -> beyond(target, area.outline().stream())).orElse(0.5 * grid.side());
        InboundFlights flights = new InboundFlights(target, asked, grid.cell(), grid.heights()).outside(protection);
        double response = settings.alert().response();
        if (response == 0.0) {
            return flights;
        }
        double speed = DetectionField.droneOf(stage, drone).settings().speed();
        double ahead = speed * (response + terms.within().orElse(0.0));
        double most = Math.min(
                MOST_STEPS * grid.cell(), farthest(target, stage.world().bounds()));
        while (true) {
            // A flight that begins farther away may meet another zone first.
            double needed = Math.ceil(Math.min(most, flights.firstArrival(protection) + ahead + ACCURACY));
            if (needed <= flights.reach()) {
                return flights;
            }
            flights = flights.from(needed).outside(protection);
        }
    }

    private InboundFlights from(double distance) {
        return new InboundFlights(target, distance, step, heights);
    }

    /** These flights or, if any of them begins in a zone, flights that begin beyond all zones. */
    private InboundFlights outside(Protection protection) {
        if (IntStream.range(0, BEARINGS).noneMatch(bearing -> protection.distance(at(reach, bearing)) == 0.0)) {
            return this;
        }
        double sphere = protection
                .zone()
                .map(ball -> Math.ceil(BEYOND
                        + Math.hypot(
                                target.x() - ball.centre().x(),
                                target.y() - ball.centre().y())
                        + ball.radius()))
                .orElse(0.0);
        return from(
                Math.max(sphere, beyond(target, protection.areas().stream().flatMap(area -> area.outline().stream()))));
    }

    private static double beyond(Position target, Stream<GroundPoint> corners) {
        return Math.ceil(BEYOND
                + corners.mapToDouble(corner -> Math.hypot(corner.x() - target.x(), corner.y() - target.y()))
                        .max()
                        .orElse(0.0));
    }

    /** The horizontal distance of the farthest corner of a box, m. */
    private static double farthest(Position target, AABB box) {
        return Math.hypot(
                Math.max(target.x() - box.minX(), box.maxX() - target.x()),
                Math.max(target.y() - box.minY(), box.maxY() - target.y()));
    }

    /** The bearing from which a flight comes, clockwise from north, rad. */
    static double angle(int bearing) {
        return 2.0 * Math.PI * bearing / BEARINGS;
    }

    /** The number of steps of a flight. */
    int steps() {
        return (int) Math.floor(reach / step) + 1;
    }

    /** The horizontal distance from the target at a step, m. */
    double distance(int number) {
        return Math.max(0.0, reach - number * step);
    }

    /** A place of a flight in plan view, at the height of the target. */
    private Position at(double distance, int bearing) {
        return new Position(
                target.x() + distance * StrictMath.sin(angle(bearing)),
                target.y() + distance * StrictMath.cos(angle(bearing)),
                target.z());
    }

    /** By height and bearing, the last step more than a delay, m, before the entry into a zone; -1 for none. */
    int[][] lastSteps(Protection protection, double delay) {
        int[] last = IntStream.range(0, BEARINGS)
                .map(bearing -> {
                    double least = arrival(bearing, protection) + delay;
                    return (int) IntStream.range(0, steps())
                                    .takeWhile(number -> distance(number) > least)
                                    .count()
                            - 1;
                })
                .toArray();
        return heights.stream().map(height -> last.clone()).toArray(int[][]::new);
    }

    /**
     * The cells of the flights up to the last step of each.
     *
     * @param last by height and bearing
     */
    FieldColumns.Plan upTo(int[][] last) {
        return new FieldColumns.Plan() {
            @Override
            public double x(int column, int row) {
                return at(distance(column), row).x();
            }

            @Override
            public double y(int column, int row) {
                return at(distance(column), row).y();
            }

            @Override
            public double above(int level, int column, int row) {
                return column <= last[level][row] ? heights.get(level) : Double.NaN;
            }
        };
    }

    /** The distance from the target at which the first of all flights enters a zone, m. */
    private double firstArrival(Protection protection) {
        return IntStream.range(0, BEARINGS)
                .mapToDouble(bearing -> arrival(bearing, protection))
                .max()
                .orElseThrow();
    }

    /**
     * Where a flight enters a zone, whatever its height: its horizontal distance from the target, m, at most 1 mm too
     * far. 0 without a zone.
     */
    double arrival(int bearing, Protection protection) {
        if (protection.isEmpty()) {
            return 0.0;
        }
        double outside = reach;
        for (int number = 0; number <= STEPS; number++) {
            double distance = reach * (STEPS - number) / STEPS;
            if (protection.distance(at(distance, bearing)) == 0.0) {
                return entry(bearing, protection, distance, outside);
            }
            outside = distance;
        }
        return 0.0;
    }

    private double entry(int bearing, Protection protection, double inside, double outside) {
        double low = inside;
        double high = outside;
        while (high - low > ACCURACY) {
            double middle = 0.5 * (low + high);
            if (protection.distance(at(middle, bearing)) == 0.0) {
                low = middle;
            } else {
                high = middle;
            }
        }
        // The outer end: a warning must not be longer than it is.
        return high;
    }
}
