package org.dronewatch.sensor;

import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.world.Obstacle;

/**
 * A cause with its evidence.
 *
 * @param cause why a drone is not detected
 * @param obstacle what hides it; present exactly for the causes that are {@link Cause#isHidden() hidden}
 * @param limit that it is beyond: range in m where it is out of range, radial speed in m/s where it is too slow or too
 *     fast; empty for other causes, and for a sensor that does not know
 */
public record Explanation(Cause cause, Optional<Obstacle> obstacle, OptionalDouble limit) {
    /** Of a drone that is detected. */
    public static final Explanation DETECTED = of(Cause.DETECTED);

    /**
     * Checks that an obstacle is named where one hides the drone, and only there.
     *
     * @throws IllegalArgumentException otherwise
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

    /** A drone that is hidden. */
    public static Explanation hiddenBy(Obstacle obstacle) {
        return new Explanation(Cause.hiddenBy(obstacle.model().role()), Optional.of(obstacle), OptionalDouble.empty());
    }

    /**
     * A drone beyond a limit.
     *
     * @param limit m or m/s
     */
    public static Explanation beyond(Cause cause, double limit) {
        return new Explanation(cause, Optional.empty(), OptionalDouble.of(limit));
    }
}
