package org.dronewatch.sensor;

import java.util.List;
import org.dronewatch.drone.Drone;
import org.dronewatch.world.World;

/**
 * Something that looks at a world with drones in it. A sensor may keep scratch memory and caches, so it is used by one
 * thread at a time; what it observes depends only on its settings and its arguments.
 */
public interface Sensor {

    /**
     * One look.
     *
     * @param world the site
     * @param drones the drones as they appear at the sensor at the look's time: as they are, or, for a signal that
     *     takes time to arrive, as they were when it left them
     * @param look which look of which sensor this is, when, and with which random numbers
     * @return what was observed: usually one observation of each drone, in the same order; a sensor may leave drones
     *     out, observe one several times, and report false alarms ({@link Observation#ofNothing})
     */
    List<Observation> observe(World world, List<Drone> drones, Look look);
}
