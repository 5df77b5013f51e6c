package org.dronewatch.sensor;

import java.util.random.RandomGenerator;
import org.dronewatch.drone.Drone;
import org.dronewatch.world.World;

/** A sensor that traces rays from a drone and can report each of them. */
public interface RaySensor extends Sensor {
    /** The purpose of the random numbers of rays: {@link Look#random}. */
    String RAYS = "rays";

    /**
     * Traces all rays from one drone to this sensor.
     *
     * @param world the site
     * @param drone the drone as it is now
     * @param random the random numbers of the rays
     * @param recorder receives every segment of every ray
     */
    void traceRays(World world, Drone drone, RandomGenerator random, RayRecorder recorder);
}
