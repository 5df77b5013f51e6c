package org.dronewatch.sensor;

import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.world.Obstacle;

/**
 * A cause with its evidence.
 *
 * @param cause why a drone is not detected
 * @param obstacle the obstacle that hides the drone; present if and only if the cause is
 *     {@link Cause#isHidden() that the drone is hidden}
 * @param limit the limit that the drone violates: range in m where it is out of range, radial speed in m/s where it is
 *     too slow or too fast, frequency in Hz where it is silent only because the sensor does not receive its carrier;
 *     empty for other causes, and where the limit is unknown
 */
public record Explanation(Cause cause, Optional<Obstacle> obstacle, OptionalDouble limit) {
    /** The explanation for a drone that is detected. */
    public static final Explanation DETECTED = of(Cause.DETECTED);

    /**
     * Checks that an obstacle is named if, and only if, one hides the drone.
     *
     * @throws IllegalArgumentException when an obstacle is named for another cause, or none is named for a hidden drone
     */
    public Explanation {
        if (obstacle.isPresent() != cause.isHidden()) {
            throw new IllegalArgumentException(
                    "cause " + cause + (cause.isHidden() ? " needs" : " must not have") + " an obstacle");
        }
    }

    /** A cause without further details. */
    public static Explanation of(Cause cause) {
        return new Explanation(cause, Optional.empty(), OptionalDouble.empty());
    }

    /** The explanation for a hidden drone. */
    public static Explanation hiddenBy(Obstacle obstacle) {
        return new Explanation(Cause.hiddenBy(obstacle.model().role()), Optional.of(obstacle), OptionalDouble.empty());
    }

    /**
     * The explanation for a drone beyond a limit.
     *
     * @param limit the limit, m, m/s or Hz
     */
    public static Explanation beyond(Cause cause, double limit) {
        return new Explanation(cause, Optional.empty(), OptionalDouble.of(limit));
    }
}
