package org.dronewatch.route;

import org.dronewatch.setting.Check;
import org.dronewatch.setting.Quantity;

/**
 * How long it takes from a detection until the intruder is stopped.
 *
 * @param mean expected duration, 0 or more, s
 * @param deviation standard deviation of the duration, 0 or more, s
 */
public record ResponseTime(double mean, double deviation) {
    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public ResponseTime {
        Check.notNegative("mean", mean, Quantity.DURATION);
        Check.notNegative("deviation", deviation, Quantity.DURATION);
    }
}
