package org.dronewatch.fusion;

import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * How often a sensor must detect a drone before it counts: in a given number of its last looks.
 *
 * @param hits how many looks must detect the drone, 1 to 100
 * @param looks out of how many, not fewer than hits, 1 to 100
 */
public record Confirmation(
        @In(value = Quantity.NUMBER, from = 1, to = 100) int hits,
        @In(value = Quantity.NUMBER, from = 1, to = 100) int looks) {
    /** One look is enough. */
    public static final Confirmation DEFAULT = new Confirmation(1, 1);

    /** Checks the limits. */
    public Confirmation {
        Limits.check(Confirmation.class, hits, looks);
        if (hits > looks) {
            throw new IllegalArgumentException("hits " + hits + " must be at most looks " + looks);
        }
    }
}
