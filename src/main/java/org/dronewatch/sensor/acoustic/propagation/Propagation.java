package org.dronewatch.sensor.acoustic.propagation;

import java.util.List;
import java.util.Map;
import org.dronewatch.sensor.Condition;
import org.dronewatch.world.World;

/**
 * A model of the propagation of sound from a drone to a microphone. Implementations are immutable records;
 * {@link org.dronewatch.setting.Kind} explains how scene files can choose a new one.
 */
public interface Propagation {

    /** A tracer of sound to a microphone in a world. */
    SoundTracer tracer(Microphone microphone, World world);

    /** The quantity that is compared with the threshold, as the label of an axis, such as {@code sound level}. */
    String measures();

    /** The speed at which sound travels to the microphone, m/s; infinity if it arrives at once. */
    default double signalSpeed(World world) {
        return Double.POSITIVE_INFINITY;
    }

    /** Whether the result includes the signal-to-noise ratio in each octave band, from which arrays find directions. */
    default boolean hasBands() {
        return false;
    }

    /** Effects on the propagation of real sound that this model leaves out, in a sentence for a report. */
    default String leavesOut() {
        return "Interference of sound is left out.";
    }

    /**
     * Conditions of the site that would matter to real sound but not to this model; none by default.
     *
     * @return the advice for the user, by condition
     */
    default Map<Condition, String> ignoredConditions() {
        return Map.of();
    }

    /** Warnings about settings that are valid, but implausible: one sentence each, without a full stop. */
    default List<String> advice() {
        return List.of();
    }
}
