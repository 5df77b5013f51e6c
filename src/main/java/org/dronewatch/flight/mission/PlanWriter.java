package org.dronewatch.flight.mission;

import java.math.BigDecimal;
import java.util.List;
import java.util.OptionalDouble;
import java.util.regex.Pattern;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.geo.GeoPoint;
import org.dronewatch.geo.Geodesy;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;
import org.dronewatch.world.Places;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/**
 * Writes a flight as a QGroundControl plan: take-off, waypoints and changes of speed, with heights above the launch
 * position, which is on the surface below the start.
 */
public final class PlanWriter {
    /** Matches the beginning of the first line of every file written by this class. */
    public static final Pattern FIRST_LINE =
            Pattern.compile(Pattern.quote("{\"fileType\": \"Plan\", \"groundStation\": \"dronewatch\","));

    /** The type of autopilot: PX4 (MAV_AUTOPILOT_PX4). */
    private static final int FIRMWARE = 12;

    private static final int QUADROTOR = 2;
    private static final int FIXED_WING = 1;

    /**
     * The frames of items with heights above the launch position (MAV_FRAME_GLOBAL_RELATIVE_ALT), and of items without
     * a position (MAV_FRAME_MISSION).
     */
    private static final int RELATIVE = 3;

    private static final int NO_FRAME = 2;

    /** The number of the mode in QGroundControl in which heights are relative to the launch position. */
    private static final int RELATIVE_MODE = 1;

    /** The least height to which autopilots take off, m. */
    private static final double LOWEST = 1.0;

    /**
     * A flight nearer than this to the surface counts as landed; one that moves sideways by less than this counts as
     * vertical, m.
     */
    private static final double NEAR = 0.5;

    /** Changes of speed smaller than this are not worth an item, m/s. */
    private static final double SAME_SPEED = 0.01;

    /** The speed stated in the plan of a flight that does not move, m/s. */
    private static final double USUAL_SPEED = 5.0;

    private static final int DECIMALS_OF_DEGREES = 8;
    private static final int DECIMALS = 3;

    private final Geodesy geodesy;
    private final Places places;
    private final boolean isWinged;
    private final ArrayNode items = JsonNodeFactory.instance.arrayNode();
    private GeoPoint home;
    private double speed;

    /**
     * The result of writing a flight.
     *
     * @param text content of the file
     * @param items number of items of the mission
     * @param tolerance greatest distance that is allowed between the flight and the straight lines of the mission, m
     */
    public record Written(String text, int items, double tolerance) {}

    /**
     * A writer for flights of a scene.
     *
     * @param places converts places on the map to positions on the scene's site
     * @param isWinged whether the drone is a fixed-wing aircraft
     */
    public PlanWriter(Origin origin, Places places, boolean isWinged) {
        this.geodesy = new Geodesy(origin);
        this.places = places;
        this.isWinged = isWinged;
    }

    /**
     * Writes a flight.
     *
     * @param until time at which the flight ends, above 0, seconds since the start of the run
     */
    public Written write(FlightPath path, double until) {
        PlanSampling.Waypoints found = new PlanSampling(path, until).waypoints();
        List<PlanSampling.Waypoint> stops = found.all();
        items.removeAll();
        home = home(stops.get(0).at());
        int next = takeOff(stops);
        speed = next < stops.size() && stops.get(next).speed() > 0.0
                ? stops.get(next).speed()
                : USUAL_SPEED;
        double first = speed;
        int last = landsAtTheEnd(stops) ? stops.size() - 1 : stops.size();
        for (int i = next; i < last; i++) {
            changeSpeed(stops.get(i));
            item(16, stops.get(i).at(), stops.get(i).hold());
        }
        if (last < stops.size() && last >= next) {
            item(21, stops.get(last).at(), 0.0);
        }
        return new Written(text(first), items.size(), found.tolerance());
    }

    /** The home position: on the surface below the start, or at the start where there is no surface. */
    private GeoPoint home(Position start) {
        OptionalDouble ground = places.ground().height(start.x(), start.y());
        GeoPoint above = geodesy.onEarth(start);
        if (ground.isEmpty()) {
            return above;
        }
        OptionalDouble height = places.surface(Math.toRadians(above.latitude()), Math.toRadians(above.longitude()));
        return new GeoPoint(above.longitude(), above.latitude(), height.orElse(above.height()));
    }

    /**
     * Writes the take-off: a climb to the start or, from a start on the ground, to the point at which the flight first
     * turns. Returns the index of the next waypoint.
     */
    private int takeOff(List<PlanSampling.Waypoint> stops) {
        Position start = stops.get(0).at();
        boolean isOnTheGround = relative(start) < LOWEST;
        boolean climbs = stops.size() > 1
                && isVertical(start, stops.get(1).at())
                && stops.get(1).at().z() > start.z();
        PlanSampling.Waypoint to = stops.get(isOnTheGround && climbs ? 1 : 0);
        GeoPoint place = geodesy.onEarth(to.at());
        put(22, RELATIVE, 0.0, place, Math.max(LOWEST, relative(to.at())));
        if (to.hold() > 0.0) {
            delay(to.hold());
        }
        return isOnTheGround && climbs ? 2 : 1;
    }

    private boolean landsAtTheEnd(List<PlanSampling.Waypoint> stops) {
        if (stops.size() < 2) {
            return false;
        }
        Position end = stops.get(stops.size() - 1).at();
        Position before = stops.get(stops.size() - 2).at();
        OptionalDouble ground = places.ground().height(end.x(), end.y());
        return ground.isPresent()
                && Math.abs(end.z() - ground.getAsDouble()) < NEAR
                && isVertical(before, end)
                && before.z() > end.z();
    }

    private static boolean isVertical(Position from, Position to) {
        return Math.hypot(to.x() - from.x(), to.y() - from.y()) < NEAR;
    }

    private double relative(Position position) {
        return geodesy.onEarth(position).height() - home.height();
    }

    private void changeSpeed(PlanSampling.Waypoint to) {
        if (Math.abs(to.speed() - speed) > SAME_SPEED * speed && to.speed() > 0.0) {
            speed = to.speed();
            ObjectNode item = simple(178, NO_FRAME);
            ArrayNode params = item.putArray("params");
            params.add(1).add(rounded(speed)).add(-1).add(0).add(0).add(0).add(0);
        }
    }

    private void delay(double seconds) {
        ArrayNode params = simple(93, NO_FRAME).putArray("params");
        params.add(rounded(seconds)).add(-1).add(-1).add(-1).add(0).add(0).add(0);
    }

    private void item(int command, Position at, double hold) {
        put(command, RELATIVE, hold, geodesy.onEarth(at), command == 21 ? 0.0 : relative(at));
    }

    private void put(int command, int frame, double hold, GeoPoint place, double height) {
        ObjectNode item = simple(command, frame);
        item.putNull("AMSLAltAboveTerrain");
        item.put("Altitude", rounded(height));
        item.put("AltitudeMode", RELATIVE_MODE);
        ArrayNode params = item.putArray("params");
        params.add(rounded(hold)).add(0).add(0).addNull();
        params.add(degrees(place.latitude())).add(degrees(place.longitude())).add(rounded(height));
    }

    private ObjectNode simple(int command, int frame) {
        ObjectNode item = items.addObject();
        item.put("type", "SimpleItem");
        item.put("autoContinue", true);
        item.put("command", command);
        item.put("doJumpId", items.size());
        item.put("frame", frame);
        return item;
    }

    private String text(double cruise) {
        ObjectNode root = JsonNodeFactory.instance.objectNode();
        root.put("version", 1);
        ObjectNode mission = root.putObject("mission");
        mission.put("version", 2);
        mission.put("firmwareType", FIRMWARE);
        mission.put("globalPlanAltitudeMode", RELATIVE_MODE);
        mission.put("vehicleType", isWinged ? FIXED_WING : QUADROTOR);
        mission.put("cruiseSpeed", rounded(cruise));
        mission.put("hoverSpeed", rounded(cruise));
        ArrayNode launch = mission.putArray("plannedHomePosition");
        launch.add(degrees(home.latitude())).add(degrees(home.longitude())).add(rounded(home.height()));
        mission.set("items", items.deepCopy());
        ObjectNode fence = root.putObject("geoFence");
        fence.put("version", 2);
        fence.putArray("circles");
        fence.putArray("polygons");
        ObjectNode rally = root.putObject("rallyPoints");
        rally.put("version", 2);
        rally.putArray("points");
        String body = JsonMapper.shared().writerWithDefaultPrettyPrinter().writeValueAsString(root);
        return "{\"fileType\": \"Plan\", \"groundStation\": \"dronewatch\"," + body.substring(1) + "\n";
    }

    private static BigDecimal rounded(double value) {
        return GeoPoint.rounded(value, DECIMALS);
    }

    /**
     * A number of degrees as a plan states it: longitudes of a frame continue beyond the date line; those of a plan do
     * not.
     */
    private static BigDecimal degrees(double value) {
        return GeoPoint.rounded(
                Math.abs(value) > 180.0 ? Math.IEEEremainder(value, 360.0) : value, DECIMALS_OF_DEGREES);
    }
}
