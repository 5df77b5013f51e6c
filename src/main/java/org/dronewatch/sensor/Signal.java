package org.dronewatch.sensor;

/**
 * The signal that a sensor receives from a drone, before any random decision.
 *
 * @param probability probability that one look detects the drone or, for a sensor of {@link Chance#PER_ENCOUNTER}, that
 *     its observer can detect it, given enough time, 0 to 1
 * @param quantity the measured quantity, in {@code unit}; minus infinity where nothing reaches the sensor and the unit
 *     is dB
 * @param unit unit of the quantity, the threshold and the standard error; empty for a ratio
 * @param threshold the value that the quantity must reach; for a probabilistic sensor, the value at which the detection
 *     probability is 0.5
 * @param standardError standard error of the quantity, in its unit; 0 where it is exact
 * @param probabilityError standard error of the probability; 0 where it is exact
 */
public record Signal(
        double probability,
        double quantity,
        String unit,
        double threshold,
        double standardError,
        double probabilityError) {
    private static final String DECIBELS = "dB";

    /** The signal of a sensor that compares an exact quantity with a threshold. */
    public static Signal certain(double quantity, String unit, double threshold) {
        return new Signal(quantity >= threshold ? 1.0 : 0.0, quantity, unit, threshold, 0.0, 0.0);
    }

    /** An exact signal of a sensor that detects with a probability. */
    public static Signal of(double probability, double quantity, String unit, double threshold) {
        return new Signal(probability, quantity, unit, threshold, 0.0, 0.0);
    }

    /** Whether the quantity reaches the threshold; if it does, the probability is at least 0.5. */
    public boolean isDetected() {
        return quantity >= threshold;
    }

    /**
     * Quantity minus threshold in dB, so that sensors of different kinds can be compared:
     * {@code 10 lg(quantity / threshold)} where the unit is not dB.
     */
    public double marginDb() {
        return unit.equals(DECIBELS) ? quantity - threshold : 10.0 * Math.log10(quantity / threshold);
    }
}
