package org.dronewatch.sensor.radar;

import java.util.Optional;
import java.util.OptionalDouble;

/**
 * The resolution cells for which a radar decides in each scan whether they contain a target, as far as these cells
 * follow from its settings.
 *
 * @param azimuthWidth horizontal width of the field of view, rad
 * @param elevationWidth vertical width of the field of view, rad
 * @param minRange minimum range, m
 * @param maxRange maximum range, m
 * @param minSpeed least radial speed, m/s
 * @param maxSpeed greatest radial speed, m/s
 * @param frequency carrier frequency, Hz
 * @param beam shape of the beam; without one, the gain of the antenna gives the number of beams
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

    /** The number of cells with a hardware budget: range cells times beams times Doppler cells. */
    double count(LinkBudget.Hardware hardware) {
        return rangeCells(hardware) * beams(hardware.lowerGain()).orElseThrow() * dopplerCells(hardware);
    }

    /** The number of range cells between the least and the greatest range, each {@code c / 2B} deep. */
    double rangeCells(LinkBudget.Hardware hardware) {
        return whole((maxRange - minRange) * 2.0 * hardware.sweepBandwidth() / LIGHT);
    }

    /**
     * The number of positions of the beam in a scan: as many as fill the field of view.
     *
     * @param gain gain of the antenna with the lower gain, dBi, which gives their number if no beam is stated
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

    /**
     * The number of Doppler cells between the least and the greatest radial speed, approaching and receding, each
     * {@code lambda / 2T} wide.
     */
    double dopplerCells(LinkBudget.Hardware hardware) {
        double fastest = Math.min(maxSpeed, hardware.migrationSpeed());
        double cell = LIGHT / frequency / (2.0 * hardware.integrationTime());
        return whole(2.0 * (fastest - minSpeed) / cell);
    }

    private static double whole(double number) {
        return Math.max(1.0, Math.ceil(number - 1e-9));
    }
}
