package org.dronewatch.sensor;

/**
 * What a sensor has of a drone before chance decides.
 *
 * @param probability that one look detects the drone, 0 to 1
 * @param quantity what is measured, in the unit; minus infinity where nothing reaches the sensor and the unit is dB
 * @param unit of quantity, threshold and standard error; empty for a ratio
 * @param threshold that the quantity must reach; of a sensor that decides by chance, what detects every other time
 * @param standardError of the quantity, in its unit; 0 where it is exact
 * @param probabilityError standard error of the probability; 0 where it is exact
 */
public record Signal(
        double probability,
        double quantity,
        String unit,
        double threshold,
        double standardError,
        double probabilityError) {

    /** The signal of a sensor that compares an exact quantity with a threshold. */
    public static Signal certain(double quantity, String unit, double threshold) {
        return new Signal(quantity >= threshold ? 1.0 : 0.0, quantity, unit, threshold, 0.0, 0.0);
    }

    /** An exact signal of a sensor that knows how likely it is to detect. */
    public static Signal of(double probability, double quantity, String unit, double threshold) {
        return new Signal(probability, quantity, unit, threshold, 0.0, 0.0);
    }

    /** Whether the quantity reaches the threshold: then at least every other look detects the drone. */
    public boolean isDetected() {
        return quantity >= threshold;
    }
}
