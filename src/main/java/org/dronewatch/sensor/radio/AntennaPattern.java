package org.dronewatch.sensor.radio;

import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * The pattern of a directional antenna: the gain relative to the maximum is
 * {@code -min(12 (a/A)^2 + 12 (e/E)^2, sideLobes)} dB at the angles a in azimuth and e in elevation from its axis,
 * where A and E are the half-power beamwidths (3GPP TR 38.901, table 7.3-1).
 *
 * @param azimuthBeamwidth horizontal half-power beamwidth A, pi/18000 (0.01 degrees) to 2 pi rad
 * @param elevationBeamwidth vertical half-power beamwidth E, pi/18000 (0.01 degrees) to pi rad
 * @param sideLobes level of the side lobes and of the back lobe below that of the main lobe, 0 to 100 dB
 */
public record AntennaPattern(
        @In(value = Quantity.ANGLE, from = In.NARROWEST, to = 2 * Math.PI) double azimuthBeamwidth,
        @In(value = Quantity.ANGLE, from = In.NARROWEST, to = Math.PI) double elevationBeamwidth,
        @In(value = Quantity.LEVEL, from = 0, to = 100) double sideLobes) {
    private static final double HALF_POWER = 12.0;

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public AntennaPattern {
        Limits.check(AntennaPattern.class, azimuthBeamwidth, elevationBeamwidth, sideLobes);
    }

    /**
     * An antenna with the given half-power beamwidths, rad, and side lobes 30 dB below the main lobe (3GPP TR 38.901,
     * table 7.3-1).
     */
    @Defaults({"azimuthBeamwidth", "elevationBeamwidth"})
    public static AntennaPattern of(double azimuthBeamwidth, double elevationBeamwidth) {
        return new AntennaPattern(azimuthBeamwidth, elevationBeamwidth, 30.0);
    }

    /** This antenna with other side lobes, dB below the main lobe. */
    public AntennaPattern withSideLobes(double decibels) {
        return SettingsForm.with(this, "sideLobes", decibels);
    }

    /**
     * The largest possible gain of a beam with the half-power beamwidths A and E, without losses and side lobes:
     * {@code 10 lg(4 pi / (A E))} dBi (Skolnik, Radar Handbook).
     *
     * @param azimuthBeamwidth half-power beamwidth A in azimuth, rad
     * @param elevationBeamwidth half-power beamwidth E in elevation, rad
     */
    public static double largestGain(double azimuthBeamwidth, double elevationBeamwidth) {
        return 10.0 * Math.log10(4.0 * Math.PI / (azimuthBeamwidth * elevationBeamwidth));
    }

    /** The largest possible gain of this antenna, dBi. */
    public double largestGain() {
        return largestGain(azimuthBeamwidth, elevationBeamwidth);
    }

    /**
     * The gain of this antenna in a direction, relative to that on the axis, dB; 0 or less.
     *
     * @param axis direction of the axis, of any length above 0
     * @param seen the direction, of any length above 0
     */
    public double gain(Position axis, Position seen) {
        return -loss(axis, seen, azimuthBeamwidth, elevationBeamwidth, sideLobes);
    }

    /**
     * The loss of an antenna off its axis, dB; 0 or more. The angles are measured in the antenna's frame, without roll,
     * so the shape of the beam does not depend on its tilt.
     *
     * @param axis direction of the axis, of any length above 0
     * @param seen the direction, of any length above 0
     * @param azimuthBeamwidth half-power beamwidth A in azimuth, rad
     * @param elevationBeamwidth half-power beamwidth E in elevation, rad
     * @param sideLobes level of the side lobes below that of the main lobe, dB
     */
    public static double loss(
            Position axis, Position seen, double azimuthBeamwidth, double elevationBeamwidth, double sideLobes) {
        double level = Math.hypot(axis.x(), axis.y());
        double length = axis.length();
        // For a direction straight up or down, north is used as the azimuth, as in Aim.Direction.
        double east = level > 0.0 ? axis.x() / level : 0.0;
        double north = level > 0.0 ? axis.y() / level : 1.0;
        double ahead = seen.x() * east + seen.y() * north;
        double right = seen.x() * north - seen.y() * east;
        double forward = (ahead * level + seen.z() * axis.z()) / length;
        double above = (seen.z() * level - ahead * axis.z()) / length;
        double across = Math.atan2(right, forward) / azimuthBeamwidth;
        double upwards = Math.atan2(above, Math.hypot(right, forward)) / elevationBeamwidth;
        return Math.min(sideLobes, HALF_POWER * (across * across + upwards * upwards));
    }
}
