package org.dronewatch.sensor.acoustic.propagation;

import java.util.List;
import java.util.Map;
import org.dronewatch.sensor.Condition;
import org.dronewatch.world.World;

/**
 * How sound propagates from a drone to a microphone. Implementations are immutable records;
 * {@link org.dronewatch.setting.Kind} explains how scene files can choose a new one.
 */
public interface Propagation {

    /** A tracer of sound to a microphone in a world. */
    SoundTracer tracer(Microphone microphone, World world);

    /** What is compared with the threshold, in words for a plot: {@code sound level}. */
    String measures();

    /** The speed at which sound travels to the microphone, m/s; infinity where it is heard at once. */
    default double signalSpeed(World world) {
        return Double.POSITIVE_INFINITY;
    }

    /**
     * Whether what a microphone hears comes with the signal-to-noise ratio in each octave band, which directions need.
     */
    default boolean hasBands() {
        return false;
    }

    /** What this model leaves out of the propagation of real sound, in a sentence for a report. */
    default String leavesOut() {
        return "Interference of sound is left out.";
    }

    /**
     * Conditions of the site that would matter to real sound but not to this model; none by default.
     *
     * @return by condition what to do instead, in words
     */
    default Map<Condition, String> ignoredConditions() {
        return Map.of();
    }

    /** What looks odd about its settings, although it is allowed: one sentence for each oddity, without a full stop. */
    default List<String> advice() {
        return List.of();
    }
}
