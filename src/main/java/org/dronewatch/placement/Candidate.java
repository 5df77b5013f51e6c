package org.dronewatch.placement;

/**
 * A sensor that may be bought, with its position and aim. Immutable.
 *
 * @param name name, unique in its table, not empty
 * @param cost cost, 0 or more, in any currency
 * @param kind kind, such as {@code radar}; empty if kinds do not matter
 * @param exclusive the position that the candidate occupies, as a text: at most one of the candidates with the same
 *     text is chosen; empty if the candidate excludes no other
 * @param fixed whether the sensor is already there and so is always chosen; its cost still counts
 */
public record Candidate(String name, double cost, String kind, String exclusive, boolean fixed) {
    /** Checks the limits. */
    public Candidate {
        if (name.isEmpty()) {
            throw new IllegalArgumentException("name: is empty");
        }
        if (!(cost >= 0.0) || Double.isInfinite(cost)) {
            throw new IllegalArgumentException("cost " + cost + ": must be 0 or more");
        }
    }

    /** A candidate of no particular kind, which excludes no other and is not fixed. */
    public Candidate(String name, double cost) {
        this(name, cost, "", "", false);
    }
}
