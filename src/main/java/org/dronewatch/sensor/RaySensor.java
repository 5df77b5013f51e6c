package org.dronewatch.sensor;

import java.util.List;
import java.util.random.RandomGenerator;
import org.dronewatch.drone.Drone;
import org.dronewatch.world.World;

/** A sensor that traces rays from a drone and can report each of them. */
public interface RaySensor extends Sensor {
    /** The purpose of the random numbers that are drawn for rays; see {@link Look#random}. */
    String RAYS = "rays";

    /**
     * Traces all rays from one drone to this sensor.
     *
     * @param world the site
     * @param drone the drone in its present state
     * @param random the random numbers of the rays
     * @param recorder receives every segment of every ray
     */
    void traceRays(World world, Drone drone, RandomGenerator random, RayRecorder recorder);

    /**
     * Whether a look at a single drone detects it: the same result as that of {@link #observe} with the same random
     * numbers, perhaps at less cost.
     *
     * @param world the site
     * @param drone the drone, as it appears at the sensor
     */
    default boolean detects(World world, Drone drone, Look look) {
        return observe(world, List.of(drone), look).stream()
                .anyMatch(seen -> seen.drone().equals(drone.id()) && seen.isDetected());
    }
}
