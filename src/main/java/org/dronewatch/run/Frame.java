package org.dronewatch.run;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.drone.Drone;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.sensor.Observation;

/**
 * The scene at a time at which sensors look: a snapshot that any thread may keep.
 *
 * @param run number of the run in a sweep, from 0
 * @param time seconds since the start of the run
 * @param drones the drones as they are at that time
 * @param observations observations of the sensors that looked at this time
 * @param pointings where the positioners of the sensors that looked at this time pointed, by name of the sensor
 */
public record Frame(
        int run, double time, List<Drone> drones, List<Observation> observations, Map<String, Pointing> pointings) {
    /** Copies the lists: later changes by the caller have no effect. */
    public Frame {
        drones = List.copyOf(drones);
        observations = List.copyOf(observations);
        pointings = Collections.unmodifiableMap(new LinkedHashMap<>(pointings));
    }

    /** The observations of drones: all but the false measurements. */
    public List<Observation> ofDrones() {
        return observations.stream().filter(one -> !one.isFalse()).toList();
    }

    /** A frame in which all sensors have fixed mounts. */
    public Frame(int run, double time, List<Drone> drones, List<Observation> observations) {
        this(run, time, drones, observations, Map.of());
    }
}
