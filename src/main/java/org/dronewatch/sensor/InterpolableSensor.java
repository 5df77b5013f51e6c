package org.dronewatch.sensor;

import java.util.Optional;
import org.dronewatch.drone.Drone;
import org.dronewatch.world.World;

/**
 * A sensor whose signal takes long to assess, except for the part that arrives along paths that are found quickly. The
 * part that arrives along all other paths varies slowly with the drone's position, except at shadow boundaries: a field
 * may assess it at some positions and interpolate it at the others. Quantities and thresholds are in dB.
 */
public interface InterpolableSensor extends AssessableSensor {

    /**
     * The signal that would arrive if there were nothing but air between the drone and the sensor, which is computed at
     * very little cost.
     *
     * @return empty where the signal must be assessed at each position
     */
    Optional<Signal> signalInTheOpen(World world, Drone drone);

    /** The signal that arrives along those paths that are found without tracing random rays. */
    Signal signalOnExactPaths(World world, Drone drone);

    /** Whether the direct signal is unobstructed, on its path through the air of the site. */
    boolean isInSight(World world, Drone drone);
}
