package org.dronewatch.render.canvas;

import java.awt.Color;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The colours of the parts of flights, by the sensors that detect the drone there, in the order of occurrence. */
public final class WatcherColours {
    /** The colour of parts where no sensor detects the drone; such parts are also dashed. */
    public static final Color NOBODY = new Color(0x20262e);

    private static final int MOST_NAMES = 3;

    /** For any colour vision: Okabe and Ito, Color Universal Design, 2008. The last is for all that do not fit. */
    private static final Color[] COLOURS = {
        new Color(0x0072b2),
        new Color(0xd55e00),
        new Color(0x009e73),
        new Color(0xcc79a7),
        new Color(0x56b4e9),
        new Color(0xe69f00),
        new Color(0x8a8f96)
    };

    private final Map<List<String>, Color> colours = new LinkedHashMap<>();

    /** Assigns colours to parts of flights, in the given order. */
    public WatcherColours(List<FlightStretch> stretches) {
        int number = 0;
        for (FlightStretch stretch : stretches) {
            if (stretch.sensors().isEmpty()) {
                colours.put(stretch.sensors(), NOBODY);
            } else if (!colours.containsKey(stretch.sensors())) {
                colours.put(stretch.sensors(), COLOURS[Math.min(number++, COLOURS.length - 1)]);
            }
        }
    }

    /** The colour of one of these parts. */
    public Color of(FlightStretch stretch) {
        return colours.get(stretch.sensors());
    }

    /** The meaning of each colour; combinations of sensors beyond the number of colours share an entry. */
    public Map<String, Color> legend() {
        Map<String, Color> lines = new LinkedHashMap<>();
        colours.forEach((sensors, colour) -> lines.putIfAbsent(
                colour.equals(COLOURS[COLOURS.length - 1])
                        ? "detected by others"
                        : sensors.isEmpty() ? "not detected" : "detected by " + names(sensors),
                colour));
        return lines;
    }

    /** The names of sensors, such as {@code radar, camera +3} for five of them; {@code not detected} for none. */
    public static String names(List<String> sensors) {
        if (sensors.isEmpty()) {
            return "not detected";
        }
        return sensors.size() <= MOST_NAMES
                ? String.join(", ", sensors)
                : String.join(", ", sensors.subList(0, MOST_NAMES - 1)) + " +" + (sensors.size() - MOST_NAMES + 1);
    }
}
