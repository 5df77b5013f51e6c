package org.dronewatch.sensor.camera;

import java.util.Map;
import java.util.OptionalDouble;
import java.util.random.RandomGenerator;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.Condition;

/** Decides whether a camera detects a drone: a value from the drone's view, and the threshold that it must reach. */
public interface DetectionFunction {

    /** The value that is compared with the threshold. */
    double value(DroneView view);

    /**
     * The value at and above which the drone counts as detected; for a probabilistic function, the value at which the
     * detection probability is 0.5.
     */
    double threshold();

    /**
     * What the value must reach in one frame; the same in all frames unless a function is probabilistic.
     *
     * @param random the frame's random numbers
     */
    default double threshold(RandomGenerator random) {
        return threshold();
    }

    /** Whether the function is probabilistic: then {@link #probability} is known. */
    default boolean byChance() {
        return false;
    }

    /**
     * When chance decides, if it does: anew in each frame, with {@link #threshold(RandomGenerator)}, unless stated
     * otherwise. Where it decides once per encounter, the value is the probability, and the camera's observer takes
     * care of the rest.
     */
    default Chance chance() {
        return Chance.PER_LOOK;
    }

    /**
     * The probability that the drone is detected, 0 to 1: by one frame or, per encounter, by an observer; empty if not
     * known.
     */
    default OptionalDouble probability(DroneView view) {
        return OptionalDouble.empty();
    }

    /**
     * The value that must reach the threshold for a positioner to follow the drone, besides the pixels that it needs
     * ({@code lockPixels}); empty where those pixels alone decide. Unless stated otherwise, what is not detected is not
     * followed.
     */
    default OptionalDouble followingValue(DroneView view) {
        return OptionalDouble.of(value(view));
    }

    /**
     * Conditions of the site that would matter to a real camera but not to this decision; none by default.
     *
     * @return by condition what to do instead, in words
     */
    default Map<Condition, String> ignoredConditions() {
        return Map.of();
    }

    /** Unit of value and threshold. */
    String unit();
}
