package org.dronewatch.flight.mission;

import java.util.Map;
import java.util.Optional;
import org.dronewatch.geo.EarthPoint;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;

/**
 * Reads the numbers of a plan's items, each of which has seven parameters (MAVLink, MISSION_ITEM): the meaning of the
 * first four depends on the command; the others are latitude, longitude and height.
 *
 * @param name name of the file in messages
 */
record PlanNumbers(String name) {
    /** The longest wait, s: more than three years. */
    private static final double LONGEST = 1e8;

    /** The greatest magnitude of a height, m. */
    static final double HIGHEST = 100_000.0;

    /** The frames of MAVLink (MAV_FRAME) in which a mission may state heights. */
    private static final Map<Integer, MissionStep.Frame> FRAMES = Map.of(
            0, MissionStep.Frame.SEA,
            5, MissionStep.Frame.SEA,
            3, MissionStep.Frame.HOME,
            6, MissionStep.Frame.HOME,
            10, MissionStep.Frame.SURFACE,
            11, MissionStep.Frame.SURFACE);

    double wait(JsonNode params, String where) {
        return params.get(0).isNull() ? 0.0 : number(params.get(0), where, "time", 0.0, LONGEST);
    }

    EarthPoint place(JsonNode params, String where) {
        return point(params.get(4), params.get(5), where);
    }

    /**
     * The place in an item; empty if its latitude and longitude are 0, which stands for the drone's current position.
     */
    Optional<EarthPoint> placeIfAny(JsonNode params, String where) {
        boolean none = params.get(4).isNull()
                || params.get(5).isNull()
                || params.get(4).isNumber()
                        && params.get(5).isNumber()
                        && params.get(4).doubleValue() == 0.0
                        && params.get(5).doubleValue() == 0.0;
        return none ? Optional.empty() : Optional.of(place(params, where));
    }

    EarthPoint point(JsonNode latitude, JsonNode longitude, String where) {
        return new EarthPoint(
                Math.toRadians(number(latitude, where, "latitude", -90.0, 90.0)),
                Math.toRadians(number(longitude, where, "longitude", -180.0, 180.0)));
    }

    MissionStep.Height height(JsonNode item, JsonNode params, String where) {
        MissionStep.Frame frame = FRAMES.get(item.path("frame").asInt(-1));
        if (frame == null) {
            throw new InputException(name + ": " + where + ".frame: " + PlainText.value(item.path("frame"))
                    + " must be 0, 3 or 10: heights above sea level, above the launch position, or above the ground");
        }
        return new MissionStep.Height(frame, number(params.get(6), where, "height", -HIGHEST, HIGHEST));
    }

    double number(JsonNode node, String where, String what, double from, double to) {
        double value = node.isNumber() ? node.doubleValue() : Double.NaN;
        if (!(value >= from && value <= to)) {
            throw new InputException(
                    name + ": " + where + ": " + what + " " + PlainText.value(node) + " must be " + from + " to " + to);
        }
        return value;
    }

    /**
     * The seven parameters of an item; earlier versions of QGroundControl wrote only four, and the place separately.
     *
     * @throws InputException unless there are seven
     */
    JsonNode parameters(JsonNode item, String where) {
        JsonNode params = item.path("params");
        JsonNode place = item.path("coordinate");
        if (params.isArray() && params.size() == 4 && place.isArray() && place.size() == 3) {
            ArrayNode all = JsonNodeFactory.instance.arrayNode();
            params.forEach(all::add);
            place.forEach(all::add);
            return all;
        }
        if (!params.isArray() || params.size() != 7) {
            throw new InputException(name + ": " + where + ".params: must be a list of 7 numbers");
        }
        return params;
    }
}
