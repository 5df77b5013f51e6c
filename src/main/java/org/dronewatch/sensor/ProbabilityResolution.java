package org.dronewatch.sensor;

/**
 * How finely a probability of detection has to be resolved. A sensor may skip work that would only make a smaller
 * difference.
 *
 * @param high a limit, above 0 and at most 1: probabilities from the limit up to 1, exclusive, count as equal
 * @param isSideOnly whether the probabilities below the limit count as equal, too: then only the side of the limit on
 *     which a probability lies matters, and an estimate need only be accurate enough to show that side
 */
public record ProbabilityResolution(double high, boolean isSideOnly) {
    /** Checks the limits. */
    public ProbabilityResolution {
        if (!(high > 0.0 && high <= 1.0)) {
            throw new IllegalArgumentException(high + ": must be above 0 and at most 1");
        }
    }

    /**
     * A resolution that distinguishes all probabilities below a limit; those from the limit up to 1, exclusive, count
     * as equal.
     */
    public static ProbabilityResolution upTo(double high) {
        return new ProbabilityResolution(high, false);
    }

    /** A resolution that distinguishes only the two sides of a boundary; the boundary itself is on the upper side. */
    public static ProbabilityResolution sideOf(double boundary) {
        return new ProbabilityResolution(boundary, true);
    }
}
