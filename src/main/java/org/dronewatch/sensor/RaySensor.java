package org.dronewatch.sensor;

import java.util.random.RandomGenerator;
import org.dronewatch.drone.Drone;
import org.dronewatch.world.World;

/** A sensor that follows rays from a drone and can tell of every one of them. */
public interface RaySensor extends Sensor {
    /** What the random numbers of rays are drawn for: {@link Sample#random}. */
    String RAYS = "rays";

    /**
     * Traces all that leads from one drone to this sensor.
     *
     * @param world the site
     * @param drone the drone as it is now
     * @param random the random numbers of the rays
     * @param recorder is told every straight piece of every ray
     */
    void traceRays(World world, Drone drone, RandomGenerator random, RayRecorder recorder);
}
