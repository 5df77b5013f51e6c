package org.dronewatch.run;

import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;

/**
 * The computing time of a scene's runs by task, in wall-clock seconds.
 *
 * @param load reading models
 * @param build building trees
 * @param wall simulating, after loading and building
 * @param looking computing time of the looks of each kind of sensor, summed over all threads
 */
public record Timing(double load, double build, double wall, Map<String, Double> looking) {
    /** Copies the map: later changes by the caller have no effect. */
    public Timing {
        looking = Collections.unmodifiableMap(new TreeMap<>(looking));
    }
}
