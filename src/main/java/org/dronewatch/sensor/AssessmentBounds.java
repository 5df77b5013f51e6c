package org.dronewatch.sensor;

/**
 * Bounds on an {@link Assessment}, found at less cost than the assessment itself.
 *
 * @param least the probability is at least this, 0 to 1
 * @param greatest it is at most this
 * @param cause the cause, which is certain
 */
public record AssessmentBounds(double least, double greatest, Cause cause) {}
