package org.dronewatch.sensor.acoustic.propagation;

import java.util.List;
import java.util.Optional;
import java.util.random.RandomGenerator;
import org.dronewatch.drone.Drone;
import org.dronewatch.sensor.Curve;
import org.dronewatch.sensor.ProbabilityResolution;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.Signal;

/**
 * Traces sound from drones to one microphone in one world. May keep scratch memory: for use by one thread at a time.
 */
public interface SoundTracer {

    /**
     * Takes one look.
     *
     * @param drone the drone, as it was when the sound left it
     * @param random the random numbers of the look's rays
     */
    Heard hear(Drone drone, RandomGenerator random);

    /**
     * Whether a look hears the drone: the same result as that of {@link #hear} with the same random numbers, perhaps at
     * less cost.
     */
    default boolean hears(Drone drone, RandomGenerator random) {
        Heard heard = hear(drone, random);
        return heard.value() >= heard.threshold();
    }

    /** The signal received from a drone, before any random decision; it draws the same random numbers as a look. */
    Signal signal(Drone drone, RandomGenerator random);

    /**
     * The signal received from a drone, computed at less cost than by {@link #signal} where possible: where the
     * probability is estimated as the fraction of several looks that detect the drone, the looks after the first may
     * draw other random numbers, and the quantity may be lower for a drone that is missed. Calls {@code signal} unless
     * overridden.
     *
     * @param resolution states which probabilities count as equal
     */
    default Signal coarseSignal(Drone drone, RandomGenerator random, ProbabilityResolution resolution) {
        return signal(drone, random);
    }

    /**
     * The signal that would arrive if there were nothing but air between the drone and the microphone; see
     * {@link org.dronewatch.sensor.InterpolableSensor#signalInTheOpen}. Empty unless overridden.
     */
    default Optional<Signal> signalInTheOpen(Drone drone) {
        return Optional.empty();
    }

    /**
     * The signal that arrives along those paths that are found without tracing random rays.
     *
     * @throws UnsupportedOperationException if the model has no {@link #signalInTheOpen}
     */
    default Signal signalOnExactPaths(Drone drone) {
        throw new UnsupportedOperationException("this model of propagation is not interpolated");
    }

    /** Whether the path of the direct sound is unobstructed; false unless overridden. */
    default boolean isInSight(Drone drone) {
        return false;
    }

    /** Whether a drone would be heard without obstructions. */
    boolean isHeardInTheOpen(Drone drone);

    /**
     * Whether a drone at its position is certain to sound the same at every heading and speed; false unless overridden.
     */
    default boolean isSameAtAllHeadings(Drone drone) {
        return false;
    }

    /**
     * Traces the rays of one look to their ends and reports every segment to the recorder; does nothing if there are no
     * rays.
     */
    default void traceRays(Drone drone, RandomGenerator random, RayRecorder recorder) {}

    /** Curves that describe the sound of a drone; none by default. */
    default List<Curve> curves(Drone drone, RandomGenerator random) {
        return List.of();
    }
}
