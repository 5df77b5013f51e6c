package org.dronewatch.sensor;

/**
 * Bounds on an {@link Assessment}, found at less cost than the assessment itself.
 *
 * @param least lower bound on the probability, 0 to 1
 * @param greatest upper bound on the probability, 0 to 1
 * @param leastMarginDb lower bound on the {@link Signal#marginDb margin}, dB; NaN if it is not known
 * @param greatestMarginDb upper bound on the margin, dB; NaN if it is not known
 * @param cause why a look misses the drone, or {@link Cause#DETECTED}: exact, unlike the other values
 */
public record AssessmentBounds(
        double least, double greatest, double leastMarginDb, double greatestMarginDb, Cause cause) {

    /** A drone of which nothing is known, since its line of sight leaves the known ground; it does not count. */
    static final AssessmentBounds UNKNOWN = new AssessmentBounds(0.0, 0.0, Double.NaN, Double.NaN, Cause.UNKNOWN);

    /** The bounds for a signal that lies between two others. */
    public static AssessmentBounds between(Signal weakest, Signal strongest, Cause cause) {
        return new AssessmentBounds(
                weakest.probability(), strongest.probability(), weakest.marginDb(), strongest.marginDb(), cause);
    }
}
