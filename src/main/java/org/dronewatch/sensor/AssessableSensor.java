package org.dronewatch.sensor;

import java.util.Optional;
import java.util.random.RandomGenerator;
import org.dronewatch.drone.Drone;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.world.World;

/**
 * A sensor that can tell what it has of a drone, and why that is not enough, before chance decides. Its looks draw from the
 * same signal: a field of assessments and a run agree exactly, but where a kind of sensor says otherwise. A drone is
 * assessed alone: that other drones may stand before it is known to looks only. All kinds that come with the library are
 * assessable; others are assessed by an {@link Assessor}.
 */
public interface AssessableSensor extends Sensor {

    /**
     * What the sensor has of a drone.
     *
     * @param world the site
     * @param drone as it reaches the sensor: for a signal that takes its time, as it was when that left it
     * @param pointing where a positioner points the sensor; empty for its own aim
     * @param rayRandom the random numbers of the rays of sensors that follow rays by chance; others draw none
     */
    Signal signal(World world, Drone drone, Optional<Pointing> pointing, RandomGenerator rayRandom);

    /**
     * Why a drone is missed: the first {@link Cause} that holds. Costs no more than a few looks of a camera, whatever the kind.
     *
     * @param world the site
     * @param drone that the sensor does not detect, as it reaches the sensor
     * @param pointing where a positioner points the sensor; empty for its own aim
     * @return never {@link Cause#DETECTED}
     */
    Explanation explainMiss(World world, Drone drone, Optional<Pointing> pointing);

    /** What the sensor has of a drone, and why that is not enough; parameters as of {@link #signal}. */
    default Assessment assess(World world, Drone drone, Optional<Pointing> pointing, RandomGenerator rayRandom) {
        Signal signal = signal(world, drone, pointing, rayRandom);
        return new Assessment(signal, signal.isDetected() ? Explanation.DETECTED : explainMiss(world, drone, pointing));
    }
}
