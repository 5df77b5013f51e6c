package org.dronewatch.flight.mission;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.flight.file.DroneSpeeds;
import org.dronewatch.flight.file.EquatorSite;
import org.dronewatch.world.Ground;
import org.dronewatch.world.Places;
import org.dronewatch.world.WorldSettings;

/** Writes plans as QGroundControl does, and flies them over a site near the equator. */
final class Plans {
    static final DroneSpeeds DRONE = new DroneSpeeds(5.0, 2.5, 3.0, 1.5);

    final List<String> items = new ArrayList<>();
    final List<String> warnings = new ArrayList<>();
    String home = "[1.0, 2.0, 100]";
    String mission = "\"hoverSpeed\": 8, \"cruiseSpeed\": 20, \"vehicleType\": 2";
    String others = "";
    Ground ground = (x, y) -> java.util.OptionalDouble.of(0.0);
    DroneSpeeds drone = DRONE;
    Mission settings = Mission.of("a.plan");

    /** An item with seven parameters, of which the last three are latitude, longitude and height. */
    Plans item(int command, int frame, Object... params) {
        StringBuilder list = new StringBuilder();
        for (Object param : params) {
            list.append(list.length() == 0 ? "" : ", ").append(param);
        }
        items.add(String.format(
                Locale.ROOT,
                "{\"type\": \"SimpleItem\", \"autoContinue\": true, \"command\": %d, \"frame\": %d, \"params\": [%s]}",
                command,
                frame,
                list));
        return this;
    }

    Plans waypoint(int frame, double latitude, double longitude, double height) {
        return item(16, frame, 0, 0, 0, "null", latitude, longitude, height);
    }

    String text() {
        return "{\"fileType\": \"Plan\", \"version\": 1, \"mission\": {\"version\": 2, " + mission
                + ", \"plannedHomePosition\": " + home + ", \"items\": [" + String.join(",\n", items) + "]}" + others
                + "}";
    }

    PlannedFlight read() {
        return new PlannedFlight(settings, PlanFile.read("a.plan", text().getBytes(StandardCharsets.UTF_8)));
    }

    Places places() {
        return new Places(WorldSettings.EMPTY.withOrigin(EquatorSite.ORIGIN), () -> ground);
    }

    /** The flight of the drone. */
    FlightPath fly() {
        return read().path(places(), drone, warnings::add);
    }
}
