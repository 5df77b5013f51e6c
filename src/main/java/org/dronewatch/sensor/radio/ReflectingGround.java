package org.dronewatch.sensor.radio;

import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Minor;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * Ground that reflects radio waves, which interfere with the direct wave.
 *
 * @param permittivity relative permittivity, 1 to 100: 3 for very dry, 15 for medium dry, 30 for wet ground, 80 for
 *     water (ITU-R P.527)
 * @param conductivity conductivity, 0 to 100 S/m: 0.001 for medium dry, 0.01 for wet ground, 5 for sea water
 * @param roughness standard deviation of the ground's height from the mesh, 0 to 100 m
 * @param roundEarth whether the reflecting surface is a sphere of 4/3 of the earth's radius, which spreads the
 *     reflected wave; the meshes of the site are not curved
 */
public record ReflectingGround(
        @In(value = Quantity.NUMBER, from = 1, to = 100) double permittivity,
        @In(value = Quantity.NUMBER, from = 0, to = 100) double conductivity,
        @In(value = Quantity.LENGTH, from = 0, to = 100) double roughness,
        @Minor boolean roundEarth) {
    /** Medium dry ground with a roughness of 5 cm, such as short grass. */
    @Defaults
    public static final ReflectingGround DEFAULT = new ReflectingGround(15.0, 0.001, 0.05, false);

    private static final double LIGHT = 299_792_458.0;
    private static final double ROUGHNESS_FACTOR = 8.0;

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public ReflectingGround {
        Limits.check(ReflectingGround.class, permittivity, conductivity, roughness, roundEarth);
    }

    /** Ground on a flat earth. */
    public ReflectingGround(double permittivity, double conductivity, double roughness) {
        this(permittivity, conductivity, roughness, false);
    }

    /** This ground on a round earth or a flat one. */
    public ReflectingGround withRoundEarth(boolean isRound) {
        return SettingsForm.with(this, "roundEarth", isRound);
    }

    /** This ground with another roughness, m. */
    public ReflectingGround withRoughness(double metres) {
        return SettingsForm.with(this, "roughness", metres);
    }

    /**
     * The field at an antenna relative to that of the direct wave alone: {@code 20 lg |1 + A rho G exp(-j k d)|} with
     * Fresnel's reflection coefficient G for the complex permittivity {@code e - j 60 s lambda} and the loss of
     * coherence on a rough surface, {@code rho = exp(-8 (pi h sin(psi) / lambda)^2)} (W. S. Ament, Proceedings of the
     * IRE 41, 1953; M. I. Skolnik, Radar Handbook, chapter on propagation). A is the amplitude of the reflected wave,
     * without the losses of the reflection, relative to that of the direct wave,
     * {@code share direct / (direct + longer)}, k the wavenumber, d the path difference {@code longer}, lambda the
     * wavelength, e the permittivity, s the conductivity, psi the grazing angle, and h^2 the sum of the squares of the
     * roughness and of {@code uneven}.
     *
     * @param direct length of the direct path, m
     * @param longer length by which the reflected path is longer, 0 or more, m
     * @param grazing angle between the reflected path and the surface, above 0 to pi/2, rad
     * @param uneven standard deviation of the heights that the mesh shows, m
     * @param frequency frequency, Hz
     * @param isVertical whether the wave is polarised vertically, not horizontally
     * @param share amplitude of the antenna towards the point of reflection relative to that towards the other end, 0
     *     or more
     * @return relative field, dB, one way; at most 6 if {@code share} is at most 1
     */
    double factor(
            double direct,
            double longer,
            double grazing,
            double uneven,
            double frequency,
            boolean isVertical,
            double share) {
        double wavelength = LIGHT / frequency;
        double sine = Math.sin(grazing);
        double cosine = Math.cos(grazing);
        double imaginary = -60.0 * conductivity * wavelength;
        // The square root of e - cos^2 that has a positive real part.
        double re = permittivity - cosine * cosine;
        double size = Math.hypot(re, imaginary);
        double rootRe = Math.sqrt(0.5 * (size + re));
        double rootIm = -Math.sqrt(Math.max(0.0, 0.5 * (size - re)));
        double firstRe = isVertical ? permittivity * sine : sine;
        double firstIm = isVertical ? imaginary * sine : 0.0;
        double upRe = firstRe - rootRe;
        double upIm = firstIm - rootIm;
        double downRe = firstRe + rootRe;
        double downIm = firstIm + rootIm;
        double down = downRe * downRe + downIm * downIm;
        double gammaRe = (upRe * downRe + upIm * downIm) / down;
        double gammaIm = (upIm * downRe - upRe * downIm) / down;
        double heights = Math.PI * sine / wavelength;
        double rough = Math.exp(-ROUGHNESS_FACTOR * heights * heights * (roughness * roughness + uneven * uneven));
        double amplitude = share * rough * direct / (direct + longer);
        double phase = -2.0 * Math.PI * longer / wavelength;
        double c = amplitude * Math.cos(phase);
        double s = amplitude * Math.sin(phase);
        double real = 1.0 + gammaRe * c - gammaIm * s;
        double other = gammaRe * s + gammaIm * c;
        return 10.0 * Math.log10(real * real + other * other);
    }
}
