package org.dronewatch.sensor;

import org.dronewatch.setting.Quantity;

/**
 * Settings of a sensor whose detection threshold can be fitted to a known detection range. This is a capability,
 * queried by {@link SensorSettings#as}.
 */
public interface Thresholded {

    /** The setting that holds the threshold, and the values that it may take. */
    Scale thresholdScale();

    /**
     * These settings with another threshold: a higher one is harder to reach.
     *
     * @param value a value of the scale
     */
    SensorSettings<?> withThreshold(double value);

    /**
     * The values of a threshold.
     *
     * @param setting path of the setting within those of the sensor, such as {@code detection.pixels}
     * @param quantity its quantity
     * @param lowest least value, in the unit of the quantity
     * @param highest greatest value, in the unit of the quantity
     * @param step distance from one value to the next, above 0; 1 for whole numbers
     */
    record Scale(String setting, Quantity quantity, double lowest, double highest, double step) {
        /** A step of a millionth of a decibel, which changes a range of 100 m by less than a tenth of a millimetre. */
        public static final double FINE = 1e-6;

        /**
         * Checks that the range is not empty.
         *
         * @throws IllegalArgumentException when the highest is not above the lowest, or the step not above 0
         */
        public Scale {
            if (!(highest > lowest) || !(step > 0.0)) {
                throw new IllegalArgumentException("scale of " + setting + " from " + lowest + " to " + highest
                        + " in steps of " + step + " has no values");
            }
        }

        /** The index of its highest value; the lowest value has index 0. */
        public long last() {
            return Math.round((highest - lowest) / step);
        }

        /**
         * The value at an index from 0 to {@link #last()}, without the rounding error that adding up steps would cause.
         */
        public double value(long number) {
            double perUnit = 1.0 / step;
            return (Math.rint(lowest * perUnit) + number) / perUnit;
        }
    }
}
