package org.dronewatch.sensor.radio;

/** Diffraction at a knife edge (ITU-R P.526-15, section 4.1). */
public final class KnifeEdge {
    /** At this diffraction parameter and below, an edge causes no loss (P.526-15, equation (31)). */
    private static final double CLEAR = -0.78;

    private KnifeEdge() {}

    /**
     * Loss at a knife edge (P.526-15, equation (31)).
     *
     * @param v diffraction parameter, dimensionless; negative for an edge below the straight line between the antennas
     * @return loss, dB; 0 for an edge far below that line
     */
    public static double loss(double v) {
        return v <= CLEAR ? 0.0 : 6.9 + 20.0 * Math.log10(Math.sqrt((v - 0.1) * (v - 0.1) + 1.0) + v - 0.1);
    }

    /**
     * The diffraction parameter v of an edge: its height in radii of the first Fresnel zone, times the square root of
     * two (P.526-15, equation (26)). Distances below a wavelength count as a wavelength: the formula does not hold
     * nearer to an antenna.
     *
     * @param height height above the line, perpendicular to it, m
     * @param one distance from one end, m
     * @param other distance from the other end, m
     * @param wavelength wavelength, m
     */
    static double parameter(double height, double one, double other, double wavelength) {
        double d1 = Math.max(wavelength, one);
        double d2 = Math.max(wavelength, other);
        return height * Math.sqrt(2.0 * (d1 + d2) / (wavelength * d1 * d2));
    }
}
