package org.dronewatch.sensor.optics;

import java.util.OptionalDouble;

/**
 * The lens of a camera, with its diffraction.
 *
 * @param aperture diameter of its entrance pupil, above 0, m; empty for a lens that does not blur
 * @param wavelength wavelength of the light or thermal radiation that it images, above 0, m
 */
public record Lens(OptionalDouble aperture, double wavelength) {
    /** Wavelength of the eye's peak sensitivity, m. */
    public static final double GREEN = 550e-9;

    /** A lens that does not blur, at a wavelength in m. */
    public static Lens perfect(double wavelength) {
        return new Lens(OptionalDouble.empty(), wavelength);
    }

    /**
     * The modulation transfer of a circular aperture of diameter D, limited by diffraction:
     * {@code 2/pi (acos x - x sqrt(1 - x^2))} with {@code x = wavelength f / D}, and 0 for x above 1 (Goodman,
     * "Introduction to Fourier Optics", section 6.3).
     *
     * @param frequency frequency f of the pattern, 0 or more, cycles per radian
     * @return 0 to 1
     */
    public double transfer(double frequency) {
        if (aperture.isEmpty()) {
            return 1.0;
        }
        double x = wavelength * frequency / aperture.getAsDouble();
        return x < 1.0 ? 2.0 / Math.PI * (Math.acos(x) - x * Math.sqrt(1.0 - x * x)) : 0.0;
    }
}
