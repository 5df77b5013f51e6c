package org.dronewatch.catalog;

import java.util.LinkedHashMap;
import java.util.Map;
import org.dronewatch.setting.Check;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.file.Node;

/**
 * A system of several sensors that are sold together. A scene file uses it by its name, like a sensor.
 *
 * @param title manufacturer's name for the system
 * @param source source of the description
 * @param note omissions and assumptions
 * @param parts each sensor as in a scene file, without a position, by the suffix of its name: the part {@code radar} of
 *     a system {@code gate} is the sensor {@code gate-radar}
 */
public record SensorSystem(String title, String source, String note, Node.Mapping parts) {
    /** Checks that no component is missing. */
    public SensorSystem {
        Check.present("title", title);
        Check.present("source", source);
        Check.present("note", note);
        Check.present("parts", parts);
    }

    /** A system without a note. */
    @Defaults({"title", "source", "parts"})
    public static SensorSystem of(String title, String source, Node.Mapping parts) {
        return new SensorSystem(title, source, "", parts);
    }

    /** The sensors, each as in a scene file. */
    public Map<String, Node.Mapping> sensors() {
        Map<String, Node.Mapping> sensors = new LinkedHashMap<>();
        parts.values().keySet().forEach(name -> parts.mapping(name).ifPresent(part -> sensors.put(name, part)));
        return sensors;
    }
}
