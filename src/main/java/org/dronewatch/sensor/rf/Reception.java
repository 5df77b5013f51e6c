package org.dronewatch.sensor.rf;

import java.util.stream.DoubleStream;

/**
 * What a receiver receives from a drone and its pilot in one look, before any random draw: the strengths of the two
 * signals, the probability that the receiver intercepts them at all, and the probability that others transmit in their
 * band at the same time.
 *
 * @param drone signal-to-noise ratio of the drone's signal while nobody else transmits, dB; minus infinity if nothing
 *     arrives
 * @param pilot signal-to-noise ratio of the pilot's signal, likewise, dB
 * @param interception probability that the look intercepts one of them, and, independently, the other, 0 to 1
 * @param rise rise of the noise while others transmit, dB
 * @param occupancy probability that others transmit, 0 to 1
 */
record Reception(double drone, double pilot, double interception, double rise, double occupancy) {
    private static final double EVEN = 0.5;

    /** Whether chance has nothing to decide, so that all looks are alike. */
    boolean isCertain() {
        return interception == 1.0 && (occupancy == 0.0 || occupancy == 1.0);
    }

    /**
     * The probability that the stronger of the signals that a look intercepts reaches a given signal-to-noise ratio,
     * dB.
     */
    double probability(double ratio) {
        double clear = occupancy < 1.0 ? (1.0 - occupancy) * either(ratio) : 0.0;
        double disturbed = occupancy > 0.0 ? occupancy * either(ratio + rise) : 0.0;
        return clear + disturbed;
    }

    private double either(double ratio) {
        double ofDrone = drone >= ratio ? interception : 0.0;
        double ofPilot = pilot >= ratio ? interception : 0.0;
        return 1.0 - (1.0 - ofDrone) * (1.0 - ofPilot);
    }

    /** The signal-to-noise ratio that half of all looks reach, dB; minus infinity if most looks intercept nothing. */
    double median() {
        double least = occupancy > 0.0 ? rise : 0.0;
        return DoubleStream.of(drone, pilot, drone - least, pilot - least)
                .filter(ratio -> ratio > Double.NEGATIVE_INFINITY && reached(ratio))
                .max()
                .orElse(Double.NEGATIVE_INFINITY);
    }

    /** Whether at least half of all looks reach a value, apart from rounding. */
    private boolean reached(double ratio) {
        return probability(ratio - 1e-9) >= EVEN;
    }
}
