package org.dronewatch.route;

import java.util.Arrays;
import java.util.BitSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldGrid;
import org.dronewatch.analysis.field.InboundTarget;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.FlightLimits;
import org.dronewatch.flight.RouteFlight;
import org.dronewatch.fusion.Protection;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;

/**
 * The weakest routes of a site under power: from the rim of a detection field, at any of its heights up to the drone's
 * ceiling, to the protected zone or, without one, to the middle of the sensors. A route counts as having arrived
 * when it is within one cell's length of the zone or, in plan view, of the middle. Immutable and thread-safe.
 */
public final class SiteRoutes {
    /** The sectors from which routes come: the first centred on north, then clockwise. */
    public static final int SECTORS = 8;

    private final DetectionField field;
    private final FieldExposure exposure;
    private final RouteProblem problem;
    private final WeakestRoutes routes;
    private final Position middle;

    private SiteRoutes(
            DetectionField field, FieldExposure exposure, RouteProblem problem, WeakestRoutes routes, Position middle) {
        this.field = field;
        this.exposure = exposure;
        this.problem = problem;
        this.routes = routes;
        this.middle = middle;
    }

    /**
     * Searches for all routes.
     *
     * @param field of single looks at the drone, on all courses
     * @param settings of its scene; the time of the response is that of the alerts
     * @param stage its world and drones
     * @param drone name of the drone
     * @throws IllegalArgumentException if there is nowhere on the rim, or nowhere in the zone, where the drone can be
     * @throws java.util.concurrent.CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public static SiteRoutes of(DetectionField field, SceneSettings settings, Stage stage, String drone) {
        Drone flown = DetectionField.droneOf(stage, drone);
        FlightLimits limits = flown.settings().flightLimits();
        double cruise = flown.settings().speed();
        RouteGrid grid = grid(field, limits.ceiling());
        Position middle = InboundTarget.of(settings, stage.protection());
        FieldExposure exposure = FieldExposure.of(field, settings);
        RouteProblem problem = new RouteProblem(
                grid,
                exposure,
                List.of(RouteMode.powered(limits, cruise)),
                limits.hover() ? 0.0 : cruise / limits.turnRate(),
                PlanDirections.of(limits.hover() ? 32 : 16),
                rim(grid),
                near(grid, stage.protection(), middle, grid.spacing()));
        BitSet reached = near(grid, stage.protection(), middle, grid.spacing() + diagonal(grid));
        double response = settings.alert().response();
        WeakestRoutes routes =
                response > 0.0 ? WeakestRoutes.inTime(problem, reached, response) : WeakestRoutes.of(problem, reached);
        return new SiteRoutes(field, exposure, problem, routes, middle);
    }

    /** A post in the middle of each cell. */
    private static RouteGrid grid(DetectionField field, double ceiling) {
        FieldGrid cells = field.grid();
        int side = cells.columns();
        int levels = (int)
                cells.heights().stream().filter(height -> height <= ceiling).count();
        double[] heights = cells.heights().stream()
                .limit(levels)
                .mapToDouble(Double::doubleValue)
                .toArray();
        double[] ground = new double[side * side];
        Arrays.setAll(ground, post -> field.ground(post % side, side - 1 - post / side));
        double mean = Arrays.stream(ground).filter(Double::isFinite).average().orElse(0.0);
        BitSet closed = new BitSet();
        for (int post = 0; post < levels * ground.length; post++) {
            int below = post % ground.length;
            closed.set(post, !field.isOpen(post / ground.length, below % side, side - 1 - below / side));
        }
        double[] known = Arrays.stream(ground)
                .map(height -> Double.isNaN(height) ? mean : height)
                .toArray();
        return new RouteGrid(cells.x(0), cells.y(side - 1), cells.cell(), side, side, heights, known, closed);
    }

    private static BitSet rim(RouteGrid grid) {
        BitSet rim = new BitSet();
        for (int post = 0; post < grid.size(); post++) {
            int column = post % grid.columns();
            int row = post / grid.columns() % grid.rows();
            boolean isRim = column == 0 || row == 0 || column == grid.columns() - 1 || row == grid.rows() - 1;
            rim.set(post, isRim && grid.isOpen(post));
        }
        return rim;
    }

    private static BitSet near(RouteGrid grid, Protection protection, Position middle, double distance) {
        BitSet near = new BitSet();
        for (int post = 0; post < grid.size(); post++) {
            Position at = grid.position(post);
            double away = protection.isEmpty()
                    ? Math.hypot(at.x() - middle.x(), at.y() - middle.y())
                    : protection.distance(at);
            near.set(post, away <= distance && grid.isOpen(post));
        }
        return near;
    }

    /** The longest diagonal of a cube between posts, m. */
    private static double diagonal(RouteGrid grid) {
        double rise = grid.levels() > 1 ? grid.height(grid.levels() - 1) : 0.0;
        double gap = 0.0;
        for (int level = 1; level < grid.levels(); level++) {
            gap = Math.max(gap, grid.height(level) - grid.height(level - 1));
        }
        for (int cell = 0; rise > 0.0 && cell < grid.columns() * grid.rows(); cell++) {
            int column = Math.min(cell % grid.columns(), grid.columns() - 2);
            int row = Math.min(cell / grid.columns(), grid.rows() - 2);
            double[] ground = grid.groundRange(column, row);
            rise = Math.max(rise, gap + ground[1] - ground[0]);
        }
        return Math.sqrt(2.0 * grid.spacing() * grid.spacing() + rise * rise);
    }

    /** The weakest route from the posts of a sector of the rim; empty if none leads from there. */
    public Optional<WeakestRoute> from(int sector) {
        BitSet starts = new BitSet();
        problem.starts().stream()
                .filter(post -> sector(problem.grid().position(post)) == sector)
                .forEach(starts::set);
        return routes.from(starts);
    }

    /** The weakest route from anywhere on the rim; empty if none leads from there. */
    public Optional<WeakestRoute> fromAnywhere() {
        return routes.from(problem.starts());
    }

    private int sector(Position at) {
        double bearing = StrictMath.atan2(at.x() - middle.x(), at.y() - middle.y());
        return Math.floorMod((int) Math.rint(bearing / (2.0 * Math.PI) * SECTORS), SECTORS);
    }

    /** A route as a flight, for a scene that runs; empty if it is shorter than a leg can be. */
    public Optional<RouteFlight> flight(WeakestRoute route) {
        return route.path().flight(problem.modes());
    }

    /** By sensor, the exposure along the whole of a route, even where a detection comes too late. */
    public Map<String, Double> bySensor(WeakestRoute route) {
        Map<String, Double> bySensor = new LinkedHashMap<>();
        IntStream.range(0, field.sensors().size())
                .forEach(sensor -> bySensor.put(
                        field.sensors().get(sensor),
                        new RouteExposure(problem.withField(exposure.ofSensor(sensor))).along(route.path())));
        return bySensor;
    }
}
