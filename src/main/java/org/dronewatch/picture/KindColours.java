package org.dronewatch.picture;

import java.awt.Color;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import org.dronewatch.sensor.SensorSettings;

/** One colour for each kind of sensor in a scene: the same in all its pictures. Immutable. */
public final class KindColours {
    private static final Color[] COLOURS = {
        new Color(0x1f5fbf), new Color(0xff6a00), new Color(0x2a9d5c), new Color(0x9b3fb5), new Color(0xb58900),
    };

    private final Map<String, Color> colours = new LinkedHashMap<>();

    private KindColours(Collection<SensorSettings<?>> sensors) {
        for (SensorSettings<?> sensor : sensors) {
            colours.computeIfAbsent(sensor.kind(), kind -> COLOURS[colours.size() % COLOURS.length]);
        }
    }

    /** For the kinds of some sensors, in the order of their first. */
    public static KindColours of(Collection<SensorSettings<?>> sensors) {
        return new KindColours(sensors);
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
