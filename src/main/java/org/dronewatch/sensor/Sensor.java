package org.dronewatch.sensor;

import java.util.List;
import org.dronewatch.drone.Drone;
import org.dronewatch.world.World;

/**
 * A sensor: it observes the drones in a world, one look at a time. It may keep scratch memory and caches, so it is used
 * by one thread at a time; its observations depend only on its settings and its arguments.
 */
public interface Sensor {

    /**
     * Takes one look.
     *
     * @param world the site
     * @param drones the drones as they appear at the sensor at the look's time: as they are, or, for a signal that
     *     takes time to arrive, as they were when the signal left them
     * @param look identity, time and random numbers of the look
     * @return the observations: usually one of each drone, in the same order; a sensor may leave drones out, observe
     *     one several times, and report false alarms ({@link Observation#ofNothing})
     */
    List<Observation> observe(World world, List<Drone> drones, Look look);
}
