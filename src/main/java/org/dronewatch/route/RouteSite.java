package org.dronewatch.route;

import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.drone.FlightLimits;
import org.dronewatch.fusion.AreaZone;
import org.dronewatch.fusion.Protection;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.search.EnduranceLimit;
import org.dronewatch.route.search.Passage;
import org.dronewatch.route.search.PlanDirections;
import org.dronewatch.route.search.RouteEnd;
import org.dronewatch.route.search.RouteMode;
import org.dronewatch.route.search.RouteProblem;
import org.dronewatch.route.search.WeakestRoutes;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.world.SurfaceColumn;
import org.dronewatch.world.World;

/**
 * Where a drone may fly at a site, and where its routes begin and end: whatever does not depend on the sensors.
 *
 * @param nodes nodes that the drone may pass
 * @param modes modes in which the drone may fly
 * @param turnRadius smallest radius of the drone's turns at cruise speed, 0 for none, m
 * @param endurance longest flight under power, s
 * @param starts nodes at which routes may begin
 * @param goals nodes at which routes may end
 * @param reached the nodes of all cubes in which a route may end
 * @param passage decides between which points the drone can fly straight
 * @param arrival where a route arrives between nodes
 * @param response time from a detection until the drone is stopped, s
 * @param middle centre of the protected zone, or mean position of the sensors, m
 * @param world the site itself
 */
record RouteSite(
        SiteNodes nodes,
        List<RouteMode> modes,
        double turnRadius,
        double endurance,
        BitSet starts,
        BitSet goals,
        BitSet reached,
        Passage passage,
        RouteEnd arrival,
        double response,
        Position middle,
        World world) {
    /**
     * The time of a flight of the whole endurance counts as this exposure, so that of equally exposed routes the
     * fastest is found.
     */
    private static final double PRICE_OF_ENDURANCE = 1e-3;

    /** The number of directions in plan view and, where turns need room, of headings. */
    private static final int FINE = 48;

    private static final int COARSE = 16;

    /** The greatest number of states of a search; they take some 600 MB. */
    private static final long MOST_STATES = 50_000_000;

    private static final String NO_CELL =
            "no cell there has its centre above known ground and outside everything solid,"
                    + " at any of the heights; a larger side, smaller cells or other heights may help";

    RouteSite {
        modes = List.copyOf(modes);
    }

    /**
     * A site.
     *
     * @param modes at least one, with fields over the same grid, whose sensors do not matter
     * @param launch the area from which routes come; the edge if it is empty
     * @param middle centre of the protected zone, or mean position of the sensors, m
     * @throws IllegalArgumentException if the drone cannot be anywhere that routes begin, or anywhere that they end
     */
    static RouteSite of(
            List<ModeField> modes,
            SceneSettings settings,
            Stage stage,
            String drone,
            Optional<AreaZone> launch,
            Position middle) {
        FlightLimits limits = DetectionField.droneOf(stage, drone).settings().flightLimits();
        double cruise = DetectionField.droneOf(stage, drone).settings().speed();
        SiteNodes nodes = new SiteNodes(modes.get(0).field(), limits.ceiling());
        Protection protection = stage.protection();
        double reach = nodes.reach(protection, middle);
        BitSet starts = launch.map(nodes::over).orElseGet(nodes::rim);
        BitSet goals = nodes.goals(protection, middle, reach);
        checkNodes(starts, goals, launch.isPresent(), !protection.isEmpty());
        return new RouteSite(
                nodes,
                modes.stream().map(ModeField::mode).toList(),
                limits.hover() ? 0.0 : cruise / limits.turnRate(),
                limits.endurance(),
                starts,
                goals,
                nodes.ends(protection, middle, reach),
                Passage.through(stage.world()),
                !protection.isEmpty() && reach == 0.0 ? protection::entry : RouteEnd.AT_NODE,
                settings.alert().response(),
                middle,
                stage.world());
    }

    private static void checkNodes(BitSet starts, BitSet goals, boolean isLaunch, boolean isZone) {
        if (starts.isEmpty()) {
            throw new IllegalArgumentException("no route can begin "
                    + (isLaunch ? "in the launch area" : "on the edge of the area") + ": " + NO_CELL);
        }
        if (goals.isEmpty()) {
            throw new IllegalArgumentException("no route can end "
                    + (isZone ? "in the protected zone or next to it" : "at the centroid of the sensors") + ": "
                    + NO_CELL);
        }
    }

    /**
     * Searches for the weakest routes past some sensors.
     *
     * @param exposure exposure to these sensors
     * @param sensors names of these sensors, in the order of the scene
     */
    SiteRoutes past(SiteExposure exposure, List<String> sensors) {
        RouteProblem problem =
                new RouteProblem(nodes.grid(), exposure, modes, turnRadius, directions(), starts, goals, passage);
        double price = PRICE_OF_ENDURANCE / endurance;
        EnduranceLimit limit = new EnduranceLimit(problem, endurance, ofTime -> search(problem, ofTime));
        return new SiteRoutes(
                sensors,
                exposure,
                problem,
                search(problem, price),
                more -> search(problem.withField(exposure.plus(more)), price),
                more -> WeakestRoutes.of(problem.withField(exposure.plus(more)), reached, price, arrival),
                limit,
                middle,
                this::height);
    }

    /**
     * Enough directions to find the narrow bands of headings in which radars are blind, unless they need too much
     * memory.
     */
    private PlanDirections directions() {
        long perHeading = (long) modes.size() * nodes.grid().size();
        return PlanDirections.of(turnRadius > 0.0 && FINE * perHeading > MOST_STATES ? COARSE : FINE);
    }

    private WeakestRoutes search(RouteProblem problem, double price) {
        return response > 0.0
                ? WeakestRoutes.inTime(problem, reached, response, price, arrival)
                : WeakestRoutes.of(problem, reached, price, arrival);
    }

    /** The height of a point above the ground, m; where there is none, above that of the grid. */
    private double height(Position at) {
        return SurfaceColumn.at(world, at.x(), at.y())
                .ground()
                .map(ground -> at.z() - ground.z())
                .orElseGet(() -> nodes.grid().above(at));
    }
}
