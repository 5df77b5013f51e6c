package org.dronewatch.route;

import java.util.BitSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.InboundTarget;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.RouteFlight;
import org.dronewatch.fusion.AreaZone;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.exposure.ExposureField;
import org.dronewatch.route.search.EnduranceLimit;
import org.dronewatch.route.search.JoinedRoutes;
import org.dronewatch.route.search.RouteExposure;
import org.dronewatch.route.search.RouteGrid;
import org.dronewatch.route.search.RouteMode;
import org.dronewatch.route.search.RoutePath;
import org.dronewatch.route.search.RouteProblem;
import org.dronewatch.route.search.TimeToGo;
import org.dronewatch.route.search.WeakestRoute;
import org.dronewatch.route.search.WeakestRoutes;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;

/**
 * The weakest routes of a site: from the edge of the known ground of a detection field, or from an area, at any of the
 * field's heights up to the drone's ceiling, to the protected zone or, without one, to the mean position of the
 * sensors. A route is complete when it reaches the zone. If the zone contains no cell centre, a route is complete
 * within one cell's length of the zone; if there is no zone, within one cell's length, in plan view, of the mean
 * position of the sensors, at the height nearest to that of the sensors. Routes pass through nothing solid. For use by
 * one thread at a time.
 */
public final class SiteRoutes {
    /** The number of sectors from which routes come: the first is centred on north, the others follow clockwise. */
    public static final int SECTORS = 8;

    private final List<String> sensors;
    private final SiteExposure exposure;
    private final RouteProblem problem;
    private final WeakestRoutes routes;
    private final Function<ExposureField, WeakestRoutes> past;
    private final Function<ExposureField, WeakestRoutes> throughout;
    private final EnduranceLimit endurance;
    private final Position middle;
    private final ToDoubleFunction<Position> height;

    /**
     * Routes that were searched for.
     *
     * @param sensors names of the sensors, in the order of the scene
     * @param past the same search past the sensors and another field of exposure
     * @param throughout the same search, but all detections count, in time or not
     * @param height the height of a point above the ground, m
     */
    SiteRoutes(
            List<String> sensors,
            SiteExposure exposure,
            RouteProblem problem,
            WeakestRoutes routes,
            Function<ExposureField, WeakestRoutes> past,
            Function<ExposureField, WeakestRoutes> throughout,
            EnduranceLimit endurance,
            Position middle,
            ToDoubleFunction<Position> height) {
        this.sensors = List.copyOf(sensors);
        this.exposure = exposure;
        this.problem = problem;
        this.routes = routes;
        this.past = past;
        this.throughout = throughout;
        this.endurance = endurance;
        this.middle = middle;
        this.height = height;
    }

    /**
     * Searches for all routes from the edge of the known ground, flown under power at the cruise speed.
     *
     * @param field field of single looks at the drone, on all courses
     * @param settings settings of the field's scene; the response time is that of the alerts
     * @param stage stage of the scene
     * @param drone name of the drone
     * @throws IllegalArgumentException if the drone cannot be anywhere on the edge, or anywhere in the zone or next to
     *     it
     * @throws java.util.concurrent.CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public static SiteRoutes of(DetectionField field, SceneSettings settings, Stage stage, String drone) {
        return of(field, settings, stage, drone, Optional.empty());
    }

    /**
     * Searches for all routes, flown under power at the cruise speed.
     *
     * @param launch the area in plan view from which the routes come, at any height; if empty, they come from the edge
     *     of the known ground
     * @throws IllegalArgumentException if the drone cannot be anywhere in the area from which the routes come, or
     *     anywhere in the zone or next to it
     * @throws java.util.concurrent.CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public static SiteRoutes of(
            DetectionField field, SceneSettings settings, Stage stage, String drone, Optional<AreaZone> launch) {
        Drone flown = DetectionField.droneOf(stage, drone);
        return of(List.of(ModeField.powered(field, flown.settings())), settings, stage, drone, launch);
    }

    /**
     * Searches for all routes of a drone that may fly in several modes: at any node, the drone may change between modes
     * under power, or once from power to a glide.
     *
     * @param modes the modes, at least one, with fields over the same grid
     * @throws IllegalArgumentException if there is no mode, or the drone cannot be anywhere in the area from which the
     *     routes come, or anywhere in the zone or next to it
     */
    public static SiteRoutes of(
            List<ModeField> modes, SceneSettings settings, Stage stage, String drone, Optional<AreaZone> launch) {
        if (modes.isEmpty()) {
            throw new IllegalArgumentException("0 modes: there must be at least one");
        }
        Position middle = InboundTarget.of(settings, stage.protection());
        DetectionField field = modes.get(0).field();
        return RouteSite.of(modes, settings, stage, drone, launch, middle)
                .past(SiteExposure.of(modes, settings), field.sensors());
    }

    /**
     * The weakest route that begins in a sector; empty if no route leads from there within the endurance of the drone.
     */
    public Optional<WeakestRoute> from(int sector) {
        return within(starts(sector));
    }

    /**
     * The weakest routes from several sectors, each of which may {@linkplain JoinedRoutes join} another one where this
     * lowers its exposure.
     *
     * @param routes the routes as found {@linkplain #from from each sector}
     * @return one route for each given route, in the same order
     */
    public List<WeakestRoute> joined(List<WeakestRoute> routes) {
        return JoinedRoutes.of(this.routes, routes, startsLike(routes), endurance::allows);
    }

    /**
     * Searches once more, with another field of exposure added, such as the exposure that flights have revealed.
     *
     * @param routes the weakest routes so far, by sector
     * @param more the field that is added; it does not count in the exposure of the result
     * @return by sector, the weakest routes of this search; sectors without a route within the endurance are left out
     */
    public Map<Integer, WeakestRoute> past(Map<Integer, WeakestRoute> routes, ExposureField more) {
        WeakestRoutes again = past.apply(more);
        Map<Integer, WeakestRoute> others = new LinkedHashMap<>();
        routes.forEach((sector, before) -> again.from(starts(sector))
                .map(route -> described(endurance.hastenedAtTheEnd(this.routes, route.path()), before))
                .filter(endurance::allows)
                .ifPresent(route -> others.put(sector, route)));
        return others;
    }

    /**
     * Searches once more, for the routes that are least exposed all the way. In the other searches, the drone takes the
     * fastest path from the point after which detections come too late, even if a slower one would keep it undetected.
     *
     * @param routes the weakest routes so far, by sector; the routes of this search may join them
     * @param sectors the sectors from which to search, among those of the routes
     * @param more a field of exposure that is added; it does not count in the exposure of the result
     * @return by sector, the weakest route of this search, with the exposure on the part on which a detection counts.
     *     If this route exceeds the endurance, faster versions of it are returned instead: one speeds up where this
     *     adds the least exposure, the other speeds up first where a detection comes too late. The list is empty for a
     *     sector without a route within the endurance
     */
    public Map<Integer, List<WeakestRoute>> throughout(
            Map<Integer, WeakestRoute> routes, Set<Integer> sectors, ExposureField more) {
        WeakestRoutes again = throughout.apply(more);
        Map<Integer, WeakestRoute> found = new LinkedHashMap<>();
        routes.forEach((sector, before) -> {
            WeakestRoute own = again.described(before.path(), 0.0);
            found.put(
                    sector,
                    sectors.contains(sector) ? again.from(starts(sector)).orElse(own) : own);
        });
        List<WeakestRoute> all = List.copyOf(found.values());
        List<WeakestRoute> joined = JoinedRoutes.of(again, all, startsLike(all), route -> true);
        List<Integer> order = List.copyOf(found.keySet());
        Map<Integer, List<WeakestRoute>> others = new LinkedHashMap<>();
        for (int i = 0; i < order.size(); i++) {
            int sector = order.get(i);
            if (sectors.contains(sector)) {
                others.put(sector, withinEndurance(joined.get(i).path(), routes.get(sector)));
            }
        }
        return others;
    }

    /** The ways to fly a path within the endurance, with the exposure on the part on which a detection counts. */
    private List<WeakestRoute> withinEndurance(RoutePath path, WeakestRoute before) {
        return Stream.of(endurance.hastened(path), endurance.hastenedAtTheEnd(routes, path))
                .distinct()
                .map(one -> described(one, before))
                .filter(endurance::allows)
                .toList();
    }

    private WeakestRoute described(RoutePath path, WeakestRoute before) {
        return routes.described(path, before.lower());
    }

    /** The nodes between which routes lead. */
    public RouteGrid grid() {
        return problem.grid();
    }

    /** By route, the nodes at which one from the same sector may begin. */
    private List<BitSet> startsLike(List<WeakestRoute> found) {
        return found.stream()
                .map(route -> starts(sector(route.path().points().get(0))))
                .toList();
    }

    private BitSet starts(int sector) {
        BitSet starts = new BitSet();
        problem.starts().stream()
                .filter(node -> sector(problem.grid().position(node)) == sector)
                .forEach(starts::set);
        return starts;
    }

    /** The least exposure, with the price of time, of the routes from a sector that lead only over nodes. */
    double overNodes(int sector) {
        return starts(sector).stream().mapToDouble(routes::overNodes).min().orElse(Double.POSITIVE_INFINITY);
    }

    /** The weakest route that does not take longer than the drone's endurance. */
    private Optional<WeakestRoute> within(BitSet starts) {
        return routes.from(starts)
                .flatMap(route -> endurance.allows(route) ? Optional.of(route) : endurance.from(starts, route));
    }

    /** Where the routes lead: the centre of the zone or, without one, the mean position of the sensors, m. */
    public Position target() {
        return middle;
    }

    /** The modes in which the drone flies, in the order of their numbers. */
    public List<RouteMode> modes() {
        return problem.modes();
    }

    /** The least times in which the drone can reach the end of a route, by node. */
    public TimeToGo timeToGo() {
        return routes.timeToGo();
    }

    /** The profile of a route as it is flown, with the exposure along the whole route. */
    public RouteProfile profile(WeakestRoute route) {
        return RouteProfile.of(route.path(), problem, height);
    }

    /** A route together with its exposure to the sensors. */
    public SectorRoute describe(int sector, WeakestRoute route) {
        RouteProfile profile = profile(route);
        RouteCauses causes = RouteCauses.along(profile, sensors, exposure);
        return new SectorRoute(sector, route, profile, bySensor(route), causes, Optional.empty());
    }

    private int sector(Position at) {
        double bearing = StrictMath.atan2(at.x() - middle.x(), at.y() - middle.y());
        return Math.floorMod((int) Math.rint(bearing / (2.0 * Math.PI) * SECTORS), SECTORS);
    }

    /**
     * A route as a flight, for a scene that can be run; empty if the route is shorter than the shortest possible leg.
     */
    public Optional<RouteFlight> flight(WeakestRoute route) {
        return route.path().flight(problem.modes());
    }

    /** By sensor, the exposure along a whole route, including the part on which a detection would come too late. */
    public Map<String, Double> bySensor(WeakestRoute route) {
        Map<String, Double> bySensor = new LinkedHashMap<>();
        sensors.forEach(sensor -> bySensor.put(
                sensor, new RouteExposure(problem.withField(exposure.ofSensor(sensor))).along(route.path())));
        return bySensor;
    }

    /** The exposure to other sensors along the part of a route on which a detection counts. */
    double counted(WeakestRoute route, SiteExposure to) {
        return new RouteExposure(problem.withField(to)).along(routes.counted(route.path()));
    }
}
