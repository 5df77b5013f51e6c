package org.dronewatch.sensor.optics;

/**
 * The blur that turbulent air causes in the image of a target at a finite distance, in an exposure that is long
 * compared with the time scale of the air's motion: an upper bound for a single short exposure, in which part of the
 * blur is a shift of the whole image.
 *
 * @param coherenceDiameter Fried's parameter r0: with a lens of this diameter, the air blurs the image about as much as
 *     diffraction does, above 0, m; infinite without turbulence
 * @param wavelength wavelength of the light or thermal radiation, above 0, m
 */
public record Turbulence(double coherenceDiameter, double wavelength) {
    /** Factor of the integral of {@code Cn2 (s/L)^(5/3)} along the path, in Fried's parameter. */
    private static final double FRIED = 0.423;

    /** The mean of {@code (s/L)^(5/3)} over the path. */
    private static final double SPHERICAL = 3.0 / 8.0;

    /** Full width at half maximum of a blurred point, in units of {@code wavelength / r0}. */
    private static final double WIDTH = 0.98;

    private static final double LONG_EXPOSURE = 3.44;

    /**
     * The turbulence between a camera and a target. The wave from a point at a finite distance is spherical, so
     * turbulence near the camera has the greatest effect: {@code r0 = (0.423 k^2 integral Cn2 (s/L)^(5/3) ds)^(-3/5)}
     * where {@code k = 2 pi / wavelength}, and s is the distance from the point along the path of length L (Fried,
     * Journal of the Optical Society of America 56, 1372, 1966). With the same Cn2 everywhere, the integral is
     * {@code 3/8 Cn2 L}, which gives {@code r0 = (0.159 k^2 Cn2 L)^(-3/5)}.
     *
     * @param structure refractive-index structure constant Cn2, 0 or more, m^(-2/3)
     * @param wavelength wavelength of the light or thermal radiation, above 0, m
     * @param range distance L of the target, 0 or more, m
     */
    public static Turbulence of(double structure, double wavelength, double range) {
        double k = 2.0 * Math.PI / wavelength;
        return new Turbulence(Math.pow(FRIED * SPHERICAL * k * k * structure * range, -0.6), wavelength);
    }

    /** The full width at half maximum of a blurred point: {@code 0.98 wavelength / r0}, rad. */
    public double blur() {
        return WIDTH * wavelength / coherenceDiameter;
    }

    /**
     * The modulation transfer of the air for a pattern: {@code exp(-3.44 (wavelength f / r0)^(5/3))} (Fried 1966;
     * Goodman, "Statistical Optics", chapter 8).
     *
     * @param frequency frequency f of the pattern, 0 or more, cycles per radian
     * @return 0 to 1
     */
    public double transfer(double frequency) {
        return Math.exp(-LONG_EXPOSURE * Math.pow(wavelength * frequency / coherenceDiameter, 5.0 / 3.0));
    }
}
