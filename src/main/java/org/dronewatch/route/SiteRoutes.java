package org.dronewatch.route;

import java.util.BitSet;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.DoubleFunction;
import java.util.stream.IntStream;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.InboundTarget;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.FlightLimits;
import org.dronewatch.flight.RouteFlight;
import org.dronewatch.fusion.AreaZone;
import org.dronewatch.fusion.Protection;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Cause;

/**
 * The weakest routes of a site: from the edge of the known ground of a detection field, or from an area, at
 * any of the field's heights up to the drone's ceiling, to the protected zone or, without one, to the middle of the
 * sensors. A route has arrived when it is in the zone; if there is no zone, or it contains the middle of no cell, when
 * it is within one cell's length of the zone or, in plan view, of the middle of the sensors, at the height that is
 * nearest to theirs. It meets nothing solid.
 * One thread at a time.
 */
public final class SiteRoutes {
    /** The sectors from which routes come: the first centred on north, then clockwise. */
    public static final int SECTORS = 8;

    /** What a flight of the whole endurance counts for, so that of equally exposed routes the fastest is found. */
    private static final double PRICE_OF_ENDURANCE = 1e-3;

    private static final String NO_CELL =
            "no cell there has its middle above known ground and outside everything solid,"
                    + " at any of the heights; smaller cells or other heights may have one";

    private final DetectionField field;
    private final SiteExposure exposure;
    private final RouteProblem problem;
    private final WeakestRoutes routes;
    private final EnduranceLimit endurance;
    private final Position middle;

    private SiteRoutes(
            DetectionField field,
            SiteExposure exposure,
            RouteProblem problem,
            WeakestRoutes routes,
            EnduranceLimit endurance,
            Position middle) {
        this.field = field;
        this.exposure = exposure;
        this.problem = problem;
        this.routes = routes;
        this.endurance = endurance;
        this.middle = middle;
    }

    /**
     * Searches for all routes from the edge.
     *
     * @param field of single looks at the drone, on all courses
     * @param settings of its scene; the time of the response is that of the alerts
     * @param stage its world and drones
     * @param drone name of the drone
     * @throws IllegalArgumentException if there is nowhere on the edge, or nowhere in the zone, where the drone can be
     * @throws java.util.concurrent.CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public static SiteRoutes of(DetectionField field, SceneSettings settings, Stage stage, String drone) {
        return of(field, settings, stage, drone, Optional.empty());
    }

    /**
     * Searches for all routes.
     *
     * @param launch the area in plan view from which the routes come, at any height; from the edge if it is empty
     * @throws IllegalArgumentException if the drone cannot be anywhere in the area from which the routes come, or not
     *     anywhere in the zone
     * @throws java.util.concurrent.CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public static SiteRoutes of(
            DetectionField field, SceneSettings settings, Stage stage, String drone, Optional<AreaZone> launch) {
        Drone flown = DetectionField.droneOf(stage, drone);
        return of(List.of(ModeField.powered(field, flown.settings())), settings, stage, drone, launch);
    }

    /**
     * Searches for all routes of a drone that may fly in several modes: it begins in the first of them, and may change
     * to the next one, once and at any post, such as from power to gliding.
     *
     * @param modes at least one, with fields over the same grid
     * @throws IllegalArgumentException if there is no mode, or as above
     */
    public static SiteRoutes of(
            List<ModeField> modes, SceneSettings settings, Stage stage, String drone, Optional<AreaZone> launch) {
        if (modes.isEmpty()) {
            throw new IllegalArgumentException("0 modes: must be at least one");
        }
        DetectionField field = modes.get(0).field();
        FlightLimits limits = DetectionField.droneOf(stage, drone).settings().flightLimits();
        double cruise = DetectionField.droneOf(stage, drone).settings().speed();
        SitePosts posts = new SitePosts(field, limits.ceiling());
        Protection protection = stage.protection();
        Position middle = InboundTarget.of(settings, protection);
        double reach = posts.reach(protection, middle);
        BitSet starts = launch.map(posts::over).orElseGet(posts::rim);
        BitSet goals = posts.goals(protection, middle, reach);
        checkPosts(starts, goals, launch.isPresent(), !protection.isEmpty());
        SiteExposure exposure = SiteExposure.of(modes, settings);
        RouteProblem problem = new RouteProblem(
                posts.grid(),
                exposure,
                modes.stream().map(ModeField::mode).toList(),
                limits.hover() ? 0.0 : cruise / limits.turnRate(),
                PlanDirections.of(limits.hover() ? 48 : 16),
                starts,
                goals,
                Passage.through(stage.world()));
        BitSet reached = posts.near(protection, middle, reach + posts.diagonal());
        double response = settings.alert().response();
        double price = PRICE_OF_ENDURANCE / limits.endurance();
        RouteEnd arrival = !protection.isEmpty() && reach == 0.0 ? protection::entry : RouteEnd.AT_POST;
        DoubleFunction<WeakestRoutes> search = ofTime -> response > 0.0
                ? WeakestRoutes.inTime(problem, reached, response, ofTime, arrival)
                : WeakestRoutes.of(problem, reached, ofTime, arrival);
        EnduranceLimit endurance = new EnduranceLimit(problem.modes(), limits.endurance(), search);
        return new SiteRoutes(field, exposure, problem, search.apply(price), endurance, middle);
    }

    private static void checkPosts(BitSet starts, BitSet goals, boolean isLaunch, boolean isZone) {
        if (starts.isEmpty()) {
            throw new IllegalArgumentException(
                    "no route begins " + (isLaunch ? "in the launch area" : "on the edge") + ": " + NO_CELL);
        }
        if (goals.isEmpty()) {
            throw new IllegalArgumentException(
                    "no route ends " + (isZone ? "in the protected zone or beside it" : "at the middle of the sensors")
                            + ": " + NO_CELL);
        }
    }

    /** The weakest route from the starts in a sector; empty if none leads from there within the endurance. */
    public Optional<WeakestRoute> from(int sector) {
        return within(starts(sector));
    }

    private BitSet starts(int sector) {
        BitSet starts = new BitSet();
        problem.starts().stream()
                .filter(post -> sector(problem.grid().position(post)) == sector)
                .forEach(starts::set);
        return starts;
    }

    /** The least exposure, with the price of time, over the posts alone of the routes from a sector. */
    double overPosts(int sector) {
        return starts(sector).stream().mapToDouble(routes::overPosts).min().orElse(Double.POSITIVE_INFINITY);
    }

    /** The weakest route from any start; empty if none leads from there within the endurance. */
    public Optional<WeakestRoute> fromAnywhere() {
        return within(problem.starts());
    }

    /** The weakest route that does not take longer than the drone's endurance. */
    private Optional<WeakestRoute> within(BitSet starts) {
        return routes.from(starts)
                .flatMap(route -> endurance.allows(route) ? Optional.of(route) : endurance.from(starts, route));
    }

    /** Where the routes lead: the middle of the zone or of the sensors, m. */
    public Position target() {
        return middle;
    }

    /** The modes in which the drone flies, by their numbers. */
    public List<RouteMode> modes() {
        return problem.modes();
    }

    /** The least times in which the drone can reach the end of a route, by post. */
    public TimeToGo timeToGo() {
        return routes.timeToGo();
    }

    /** A route as it is flown, with the exposure along the whole of it. */
    public RouteProfile profile(WeakestRoute route) {
        return RouteProfile.of(route.path(), problem);
    }

    /** A route with what the sensors see of it. */
    public SectorRoute describe(int sector, WeakestRoute route) {
        RouteProfile profile = profile(route);
        Map<Cause, Double> causes = new EnumMap<>(Cause.class);
        for (int i = 1; i < profile.points().size(); i++) {
            RoutePoint from = profile.points().get(i - 1);
            RoutePoint to = profile.points().get(i);
            causes.merge(
                    exposure.cause(from.position(), to.position(), from.mode()), to.time() - from.time(), Double::sum);
        }
        return new SectorRoute(sector, route, profile, bySensor(route), causes, Optional.empty());
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
