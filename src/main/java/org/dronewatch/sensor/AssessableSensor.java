package org.dronewatch.sensor;

import java.util.Optional;
import java.util.random.RandomGenerator;
import org.dronewatch.drone.Drone;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.world.World;

/**
 * A sensor that can compute the signal it receives from a drone, and explain why that is insufficient, before any
 * random decision. Its looks are based on the same signal, so a field of assessments and a run agree exactly, unless a
 * kind of sensor states otherwise. A drone is assessed alone: only looks take into account that other drones may hide
 * it. All the library's own kinds of sensor are assessable; an {@link Assessor} also assesses others.
 */
public interface AssessableSensor extends Sensor {

    /**
     * The signal that the sensor receives from a drone.
     *
     * @param world the site
     * @param drone the drone, as it appears at the sensor: for a signal that takes time to arrive, as it was when the
     *     signal left it
     * @param pointing where a positioner points the sensor; empty for the aim in its settings
     * @param rayRandom random numbers for sensors that trace random rays; others draw none
     */
    Signal signal(World world, Drone drone, Optional<Pointing> pointing, RandomGenerator rayRandom);

    /**
     * The reason why a drone is missed: the first {@link Cause} that applies. For any kind of sensor, the cost is at
     * most that of a few looks of a camera.
     *
     * @param world the site
     * @param drone the drone that is missed, as it appears at the sensor
     * @param pointing where a positioner points the sensor; empty for the aim in its settings
     * @return never {@link Cause#DETECTED}
     */
    Explanation explainMiss(World world, Drone drone, Optional<Pointing> pointing);

    /**
     * Whether the signal and the reason for a miss are certain to be the same at every heading and speed of a level
     * drone at its position, so that a field of assessments needs only one assessment there. False unless overridden.
     *
     * @param world the site
     * @param drone the drone, at any heading and speed
     * @param pointing where a positioner points the sensor; empty for the aim in its settings
     */
    default boolean isSameAtAllHeadings(World world, Drone drone, Optional<Pointing> pointing) {
        return false;
    }

    /**
     * Whether the signal and the reason for a miss are certain not to depend on the speed of a level drone, although
     * they may depend on its heading. False unless overridden.
     */
    default boolean isSameAtAllSpeeds() {
        return false;
    }

    /**
     * Assesses a drone as {@link #assess} does, but at less cost where possible, for a field that stores probabilities
     * in steps. A probability other than 0 and 1 may be replaced by another one that counts as equal. Estimates may
     * draw random numbers other than those of {@code assess} but are as accurate, unless the only question is on which
     * side of a limit a probability lies ({@link ProbabilityResolution#isSideOnly}). The quantity may be lower than
     * that of {@code assess} for a drone that is detected and, if it is an estimate, for one that is missed; the cause
     * and the obstacle are the same unless they depend on an estimate. Calls {@code assess} unless overridden.
     *
     * @param resolution the probabilities that count as equal; other parameters as for {@link #signal}
     */
    default Assessment assessCoarsely(
            World world,
            Drone drone,
            Optional<Pointing> pointing,
            RandomGenerator rayRandom,
            ProbabilityResolution resolution) {
        return assess(world, drone, pointing, rayRandom);
    }

    /**
     * The signal that the sensor receives from a drone, and why it is insufficient; parameters as for {@link #signal}.
     */
    default Assessment assess(World world, Drone drone, Optional<Pointing> pointing, RandomGenerator rayRandom) {
        Signal signal = signal(world, drone, pointing, rayRandom);
        return new Assessment(signal, signal.isDetected() ? Explanation.DETECTED : explainMiss(world, drone, pointing));
    }
}
