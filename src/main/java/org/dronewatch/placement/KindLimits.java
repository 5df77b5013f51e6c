package org.dronewatch.placement;

/**
 * How many candidates of a kind may be chosen.
 *
 * @param atLeast minimum number, 0 or more
 * @param atMost maximum number, no less than {@code atLeast}
 */
public record KindLimits(int atLeast, int atMost) {
    /** Checks the limits. */
    public KindLimits {
        if (atLeast < 0 || atMost < atLeast) {
            throw new IllegalArgumentException("at least " + atLeast + ", at most " + atMost
                    + ": must be 0 or more, and must not contradict each other");
        }
    }
}
