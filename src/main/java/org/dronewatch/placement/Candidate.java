package org.dronewatch.placement;

/**
 * A sensor that may be bought, at a place and with an aim. Immutable.
 *
 * @param name unique in its table, not empty
 * @param cost 0 or more, in any currency
 * @param kind such as {@code radar}; empty if kinds do not matter
 * @param exclusive the place that it takes: at most one of the candidates with the same text is chosen; empty if it
 *     excludes none
 * @param fixed whether it is there already, and is always chosen; its cost counts
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

    /** A candidate of no kind, which excludes no other and is not fixed. */
    public Candidate(String name, double cost) {
        this(name, cost, "", "", false);
    }
}
