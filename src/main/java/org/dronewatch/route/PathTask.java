package org.dronewatch.route;

import org.dronewatch.setting.Check;
import org.dronewatch.setting.Quantity;

/**
 * One task on an intruder's path to what is protected, such as a leg of a flight.
 *
 * @param probability probability that the intruder is detected during this task, 0 to 1
 * @param mean expected duration, 0 or more, s
 * @param deviation standard deviation of the duration, 0 or more, s
 */
public record PathTask(double probability, double mean, double deviation) {
    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public PathTask {
        Check.between("probability", probability, 0.0, 1.0, Quantity.RATIO);
        Check.notNegative("mean", mean, Quantity.DURATION);
        Check.notNegative("deviation", deviation, Quantity.DURATION);
    }
}
