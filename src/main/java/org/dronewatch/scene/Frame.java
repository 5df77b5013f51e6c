package org.dronewatch.scene;

import java.util.List;
import org.dronewatch.sensor.Observation;
import org.dronewatch.world.Drone;

/**
 * The scene at one sampling time: a snapshot that any thread may keep.
 *
 * @param run number of the run in a sweep, from 0
 * @param time seconds since the start of the run
 * @param drones the drones as they are now
 * @param observations what the sensors that looked now have observed
 */
public record Frame(int run, double time, List<Drone> drones, List<Observation> observations) {
    /** Keeps its own lists. */
    public Frame {
        drones = List.copyOf(drones);
        observations = List.copyOf(observations);
    }
}
