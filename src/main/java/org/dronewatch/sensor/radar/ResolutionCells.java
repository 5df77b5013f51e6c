package org.dronewatch.sensor.radar;

import java.util.Optional;
import java.util.OptionalDouble;

/**
 * The cells on which a radar decides in each scan, as far as they follow from its settings.
 *
 * @param azimuthWidth of its field of view, rad
 * @param elevationWidth of its field of view, rad
 * @param minRange m
 * @param maxRange m
 * @param minSpeed least radial speed, m/s
 * @param maxSpeed greatest radial speed, m/s
 * @param frequency carrier frequency, Hz
 * @param beam its shape; without one the gain of the antenna gives the number of beams
 */
record ResolutionCells(
        double azimuthWidth,
        double elevationWidth,
        double minRange,
        double maxRange,
        double minSpeed,
        double maxSpeed,
        double frequency,
        Optional<BeamPattern> beam) {
    private static final double LIGHT = 299_792_458.0;

    /** How many there are with a hardware budget: range cells times beams times Doppler cells. */
    double count(LinkBudget.Hardware hardware) {
        return rangeCells(hardware) * beams(hardware.lowerGain()).orElseThrow() * dopplerCells(hardware);
    }

    /** Cells of {@code c / 2B} each between the least and the greatest range. */
    double rangeCells(LinkBudget.Hardware hardware) {
        return whole((maxRange - minRange) * 2.0 * hardware.sweepBandwidth() / LIGHT);
    }

    /**
     * Positions of the beam in a scan: as many as fill the field of view.
     *
     * @param gain that of the narrower antenna, dBi, which gives their number where there is no beam
     * @return empty with neither a beam nor a gain
     */
    OptionalDouble beams(OptionalDouble gain) {
        if (beam.isPresent()) {
            return OptionalDouble.of(positions());
        }
        return gain.isPresent()
                ? OptionalDouble.of(ScanTime.beams(azimuthWidth, elevationWidth, gain.getAsDouble()))
                : gain;
    }

    private double positions() {
        BeamPattern shape = beam.get();
        double across = whole(azimuthWidth / shape.azimuthBeamwidth());
        double upwards = whole(elevationWidth / shape.elevationBeamwidth());
        return switch (shape.steering()) {
            case NONE -> 1.0;
            case AZIMUTH -> across;
            case BOTH -> across * upwards;
        };
    }

    /** Cells of {@code lambda / 2T} each between the least and the greatest radial speed, approaching and receding. */
    double dopplerCells(LinkBudget.Hardware hardware) {
        double fastest = Math.min(maxSpeed, hardware.migrationSpeed());
        double cell = LIGHT / frequency / (2.0 * hardware.integrationTime());
        return whole(2.0 * (fastest - minSpeed) / cell);
    }

    private static double whole(double number) {
        return Math.max(1.0, Math.ceil(number - 1e-9));
    }
}
