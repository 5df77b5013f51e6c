package org.dronewatch.sensor;

/**
 * Bounds on an {@link Assessment}, found at less cost than the assessment itself.
 *
 * @param least the probability is at least this, 0 to 1
 * @param greatest it is at most this
 * @param leastMarginDb the {@link Signal#marginDb margin} is at least this, dB; NaN if it is not known
 * @param greatestMarginDb it is at most this, dB; NaN if it is not known
 * @param cause the cause, which is certain
 */
public record AssessmentBounds(
        double least, double greatest, double leastMarginDb, double greatestMarginDb, Cause cause) {

    /** A drone of which nothing can be said, since its line of sight leaves the known ground: it does not count. */
    static final AssessmentBounds UNKNOWN = new AssessmentBounds(0.0, 0.0, Double.NaN, Double.NaN, Cause.UNKNOWN);

    /** The bounds of a signal between two others. */
    public static AssessmentBounds between(Signal weakest, Signal strongest, Cause cause) {
        return new AssessmentBounds(
                weakest.probability(), strongest.probability(), weakest.marginDb(), strongest.marginDb(), cause);
    }
}
