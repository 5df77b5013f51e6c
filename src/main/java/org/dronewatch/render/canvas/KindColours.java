package org.dronewatch.render.canvas;

import java.awt.Color;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronewatch.catalog.SensorKinds;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.sensor.SensorSettings;

/**
 * The colours of the kinds of sensors. For kinds on the class path, they are the same in all scenes; for other kinds,
 * only within one scene. Immutable.
 */
public final class KindColours {
    /** The colour of drones and their paths in all pictures. */
    public static final Color DRONE = new Color(0xd62f1f);

    /** The colour of birds and their paths in all pictures: no kind of sensor has it, and it is not alarming. */
    public static final Color BIRD = new Color(0x6b7280);

    private static final Color[] COLOURS = {
        new Color(0x1f5fbf), new Color(0xff6a00), new Color(0x2a9d5c), new Color(0x9b3fb5), new Color(0xb58900),
        new Color(0x008b8b), new Color(0x8b4513), new Color(0x5f6b2d), new Color(0xc2185b), new Color(0x546e7a),
    };

    private final Map<String, Color> colours = new LinkedHashMap<>();

    private KindColours(Collection<SensorSettings<?>> sensors) {
        List<String> known = new ArrayList<>(SensorKinds.all().keySet());
        for (SensorSettings<?> sensor : sensors) {
            if (!known.contains(sensor.kind())) {
                known.add(sensor.kind());
            }
            colours.computeIfAbsent(sensor.kind(), kind -> COLOURS[known.indexOf(kind) % COLOURS.length]);
        }
    }

    /** Colours for the kinds of some sensors, in the order in which the kinds first occur. */
    public static KindColours of(Collection<SensorSettings<?>> sensors) {
        return new KindColours(sensors);
    }

    /** The colour of a drone or of a bird, and of its path. */
    public static Color of(DroneSettings flying) {
        return flying.isBird() ? BIRD : DRONE;
    }

    /**
     * The colour of a kind.
     *
     * @throws IllegalArgumentException when no sensor is of this kind
     */
    public Color of(String kind) {
        Color colour = colours.get(kind);
        if (colour == null) {
            throw new IllegalArgumentException("no sensor of the kind '" + kind + "' in " + colours.keySet());
        }
        return colour;
    }

    /** The kinds, in the order of their first sensors. */
    public Set<String> kinds() {
        return Collections.unmodifiableSet(colours.keySet());
    }
}
