package org.dronewatch.sensor.radar;

import org.dronewatch.positioner.Direction;
import org.dronewatch.sensor.radio.AntennaPattern;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * The beam of an antenna, in transmission and in reception: the gain relative to the maximum is
 * {@code -min(12 (a/A)^2 + 12 (e/E)^2, sideLobes)} dB at the angles a in azimuth and e in elevation from its centre,
 * where A and E are the half-power beamwidths (3GPP TR 38.901, table 7.3-1). The angles are measured in the frame of
 * the beam, as for the antenna of a radio receiver, so the shape of the beam does not depend on its elevation. An array
 * that steers its beam away from its axis by the angle s has less gain, by the factor {@code cos(s)^scanLoss} (R. J.
 * Mailloux, Phased Array Antenna Handbook).
 *
 * @param azimuthBeamwidth half-power beamwidth A in azimuth, pi/18000 (0.01 degrees) to 2 pi rad
 * @param elevationBeamwidth half-power beamwidth E in elevation, pi/18000 (0.01 degrees) to pi rad
 * @param sideLobes level of the side lobes below that of the main lobe, 0 to 100 dB one way
 * @param steering planes (azimuth, elevation) in which the beam is steered towards its target; in any other plane it
 *     stays on the axis of the radar
 * @param scanLoss exponent of the scan loss one way, 0 to 5; 0 for an antenna that is rotated mechanically
 */
public record BeamPattern(
        @In(value = Quantity.ANGLE, from = In.NARROWEST, to = 2 * Math.PI) double azimuthBeamwidth,
        @In(value = Quantity.ANGLE, from = In.NARROWEST, to = Math.PI) double elevationBeamwidth,
        @In(value = Quantity.LEVEL, from = 0, to = 100) double sideLobes,
        Steering steering,
        @In(value = Quantity.NUMBER, from = 0, to = 5) double scanLoss) {
    /**
     * The least cosine of the angle from an array's axis, so that the gain stays finite where an array no longer
     * radiates.
     */
    private static final double LEAST_COSINE = 1e-3;

    /** The planes in which a beam is steered. */
    public enum Steering {
        /** No steering: the beam stays on the axis. */
        NONE,
        /** Steering in azimuth: a fan beam that covers all elevations at once. */
        AZIMUTH,
        /** Steering in azimuth and elevation: a pencil beam. */
        BOTH
    }

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public BeamPattern {
        Limits.check(BeamPattern.class, azimuthBeamwidth, elevationBeamwidth, sideLobes, steering, scanLoss);
    }

    /**
     * A beam with the given half-power beamwidths, rad, steered in both planes, with side lobes 30 dB below the main
     * lobe (3GPP TR 38.901, table 7.3-1) and a scan loss with the exponent 1.5 (an assumption).
     */
    @Defaults({"azimuthBeamwidth", "elevationBeamwidth"})
    public static BeamPattern of(double azimuthBeamwidth, double elevationBeamwidth) {
        return new BeamPattern(azimuthBeamwidth, elevationBeamwidth, 30.0, Steering.BOTH, 1.5);
    }

    /** This beam with other side lobes, dB below the main lobe. */
    public BeamPattern withSideLobes(double decibels) {
        return SettingsForm.with(this, "sideLobes", decibels);
    }

    /** This beam, steered in other planes. */
    public BeamPattern withSteering(Steering other) {
        return SettingsForm.with(this, "steering", other);
    }

    /** This beam with another exponent of the scan loss. */
    public BeamPattern withScanLoss(double exponent) {
        return SettingsForm.with(this, "scanLoss", exponent);
    }

    /**
     * The largest possible gain of a beam with the half-power beamwidths A and E, without losses and side lobes:
     * {@code 10 lg(4 pi / (A E))} dBi (Skolnik, Radar Handbook).
     */
    public double largestGain() {
        return AntennaPattern.largestGain(azimuthBeamwidth, elevationBeamwidth);
    }

    /**
     * The gain in a direction relative to that on the axis, one way, dB; 0 or less.
     *
     * @param axis axis of the radar
     * @param target the direction towards which the beam is steered, as far as possible
     * @param seen the direction in which the gain is sought
     */
    double gain(Direction axis, Direction target, Direction seen) {
        Direction centre = new Direction(
                steering == Steering.NONE ? axis.azimuth() : target.azimuth(),
                steering == Steering.BOTH ? target.elevation() : axis.elevation());
        return scanGain(axis, centre) - loss(centre, seen);
    }

    private double scanGain(Direction axis, Direction centre) {
        double cosine =
                Math.cos(centre.elevation()) * Math.cos(axis.elevation()) * Math.cos(centre.azimuth() - axis.azimuth())
                        + Math.sin(centre.elevation()) * Math.sin(axis.elevation());
        return 10.0 * scanLoss * Math.log10(Math.min(1.0, Math.max(LEAST_COSINE, cosine)));
    }

    private double loss(Direction centre, Direction seen) {
        // Exactly 0 where the beam is steered in the direction that is seen; unit vectors would leave 1e-30 dB.
        return seen.equals(centre)
                ? 0.0
                : AntennaPattern.loss(centre.unit(), seen.unit(), azimuthBeamwidth, elevationBeamwidth, sideLobes);
    }
}
