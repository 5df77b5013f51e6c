package org.dronewatch.examples;

import java.util.BitSet;
import java.util.List;
import org.dronewatch.drone.FlightLimits;
import org.dronewatch.flight.Airframe;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.exposure.ExposureField;
import org.dronewatch.route.exposure.LegMotion;
import org.dronewatch.route.search.PlanDirections;
import org.dronewatch.route.search.RouteGrid;
import org.dronewatch.route.search.RouteMode;
import org.dronewatch.route.search.RouteProblem;
import org.dronewatch.route.search.WeakestRoute;
import org.dronewatch.route.search.WeakestRoutes;

/**
 * The weakest route through a field of exposure that you define, without a scene: 2 km eastward, 30 m above a plain.
 */
public final class RouteThroughAField {
    private RouteThroughAField() {}

    /**
     * A sensor whose rate of detections falls with the square of the distance.
     *
     * @param sensor its position, m
     * @param strength the rate at a distance of 1 m, 1/s
     */
    public record InverseSquare(Position sensor, double strength) implements ExposureField {
        @Override
        public double rate(double x, double y, double z, LegMotion motion, int mode) {
            double distance = new Position(x, y, z).distance(sensor);
            return strength / (distance * distance);
        }

        /** The rate at the farthest corner. */
        @Override
        public double least(Position low, Position high, int mode) {
            double x = Math.max(sensor.x() - low.x(), high.x() - sensor.x());
            double y = Math.max(sensor.y() - low.y(), high.y() - sensor.y());
            double z = Math.max(sensor.z() - low.z(), high.z() - sensor.z());
            return strength / (x * x + y * y + z * z);
        }
    }

    /**
     * Searches from the western edge to the point [2000, 0].
     *
     * @param field how exposed the drone is
     * @param airframe type of the drone's airframe, which determines how fast it climbs and turns
     * @param cruise its cruise speed, m/s
     * @param response the time before arrival during which a detection comes too late, s
     */
    public static WeakestRoute search(ExposureField field, Airframe airframe, double cruise, double response) {
        RouteGrid grid = RouteGrid.level(0.0, -200.0, 10.0, 201, 41, 30.0);
        BitSet starts = new BitSet();
        for (int row = 0; row < grid.rows(); row++) {
            starts.set(grid.node(0, row, 0));
        }
        BitSet goals = new BitSet();
        goals.set(grid.nearest(new Position(2000.0, 0.0, 30.0)));
        FlightLimits limits = FlightLimits.typical(airframe, cruise);
        double turnRadius = limits.hover() ? 0.0 : cruise / limits.turnRate();
        List<RouteMode> modes = List.of(RouteMode.powered(limits, cruise));
        RouteProblem problem = new RouteProblem(grid, field, modes, turnRadius, PlanDirections.of(32), starts, goals);
        return WeakestRoutes.inTime(problem, goals, response).from(starts).orElseThrow();
    }

    public static void main(String[] args) {
        ExposureField field = new InverseSquare(new Position(1000.0, 50.0, 0.0), 100.0);
        WeakestRoute route = search(field, Airframe.MULTIROTOR, 12.0, 20.0);
        System.out.println("detected in time with a probability of " + route.detection());
        route.path().points().forEach(System.out::println);
    }
}
