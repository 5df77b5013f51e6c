package org.dronewatch.sensor.camera;

import java.util.Map;
import java.util.OptionalDouble;
import java.util.random.RandomGenerator;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.Condition;

/**
 * The detection function of a camera: a value computed from the view of a drone, and the threshold that it must reach.
 */
public interface DetectionFunction {

    /** The value that is compared with the threshold. */
    double value(DroneView view);

    /**
     * The value at and above which the drone counts as detected; for a probabilistic function, the value at which the
     * detection probability is 0.5.
     */
    double threshold();

    /**
     * The threshold in one frame; the same in all frames unless the function is probabilistic.
     *
     * @param random the frame's random numbers
     */
    default double threshold(RandomGenerator random) {
        return threshold();
    }

    /**
     * Whether the number of pixels alone decides: then the rest of a view need not be known. False unless overridden.
     */
    default boolean countsPixelsOnly() {
        return false;
    }

    /**
     * Whether neither value nor probability ever decreases when more pixels show the drone and all else is equal: then
     * an assessment need not count all of them. False unless overridden.
     */
    default boolean growsWithPixels() {
        return false;
    }

    /** Whether the function is probabilistic, and {@link #probability} is known. */
    default boolean byChance() {
        return false;
    }

    /**
     * Whether chance decides anew in each frame or once per encounter, if the function is probabilistic. Unless
     * overridden, it decides in each frame, by {@link #threshold(RandomGenerator)}. If it decides once per encounter,
     * the value is the probability, and the camera models the observer.
     */
    default Chance chance() {
        return Chance.PER_LOOK;
    }

    /**
     * The probability that the drone is detected, 0 to 1: in one frame or, where chance decides once per encounter, by
     * an observer; empty if it is not known.
     */
    default OptionalDouble probability(DroneView view) {
        return OptionalDouble.empty();
    }

    /**
     * The value that must reach the threshold for a positioner to follow the drone, in addition to the number of pixels
     * that the positioner requires ({@code lockPixels}); empty where that number alone decides. Unless overridden, a
     * drone that is not detected is not followed.
     */
    default OptionalDouble followingValue(DroneView view) {
        return OptionalDouble.of(value(view));
    }

    /**
     * Conditions of the site that would matter to a real camera but not to this decision; none by default.
     *
     * @return the advice for the user, by condition
     */
    default Map<Condition, String> ignoredConditions() {
        return Map.of();
    }

    /** Unit of the value and the threshold. */
    String unit();
}
