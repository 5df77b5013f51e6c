package org.dronewatch.sound.surface;

/**
 * The coherence of direct and ground-reflected sound in turbulent air: the factor by which turbulence reduces their
 * interference, on average over time. The refractive index fluctuates with the variance {@code m2} and the correlation
 * {@code exp(-r^2 / L^2)} between points at a distance r; the coherence of two paths of length R, whose distance from
 * each other grows to h, is then {@code exp(-sqrt(pi) m2 k^2 R L (1 - rho))} where
 * {@code rho = (sqrt(pi) / 2) (L / h) erf(h / L)} and k is the wavenumber.
 *
 * <p>This includes the fluctuations of phase and of amplitude, as in the mean of the product of two waves (S. F.
 * Clifford and R. J. Lataitis, JASA 73, 1545, 1983): near the source all of the variance is in the phase; far from it,
 * beyond {@code k L^2}, half is in the phase and half in the logarithm of the amplitude, with the same sum. With the
 * phase alone, as in G. A. Daigle (JASA 65, 45, 1979), the exponent would be half as large beyond {@code k L^2}.
 *
 * @param strength variance m2 of the acoustic refractive index: 0 without turbulence, about 1e-8 in calm air, 1e-4 in
 *     very turbulent air
 * @param scale correlation length L, m, above 0
 */
public record TurbulentCoherence(double strength, double scale) {
    /** Moderate turbulence near the ground. */
    public static final TurbulentCoherence MODERATE = new TurbulentCoherence(5e-6, 1.1);

    /** Below this ratio h / L, the difference between 1 and rho is taken from its series, to avoid cancellation. */
    private static final double SMALL = 1e-3;

    /** Above this ratio, the error function is 1. */
    private static final double LARGE = 10.0;

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException when the strength is negative or the scale is not above 0
     */
    public TurbulentCoherence {
        if (!(strength >= 0.0) || !(scale > 0.0)) {
            throw new IllegalArgumentException("turbulence of strength " + strength + " and scale " + scale
                    + " m: the strength must be 0 or" + " more, the scale above 0");
        }
    }

    /**
     * The exponent of the coherence divided by the square of the wavenumber, m2: the coherence is
     * {@code exp(-exponent k^2)}.
     *
     * @param length length of the paths, m
     * @param separation greatest distance between the two paths, as given by {@link #separation}, m, 0 or more
     */
    double exponent(double length, double separation) {
        return separation == 0.0
                ? 0.0
                : Math.sqrt(Math.PI) * strength * length * scale * uncorrelated(separation / scale);
    }

    /**
     * The distance between the direct and the reflected path above the point of reflection, m.
     *
     * @param sourceHeight height of the source above the ground, m, 0 or more
     * @param receiverHeight height of the receiver above the ground, m, 0 or more
     */
    public static double separation(double sourceHeight, double receiverHeight) {
        return sourceHeight == 0.0 || receiverHeight == 0.0
                ? 0.0
                : 2.0 * sourceHeight * receiverHeight / (sourceHeight + receiverHeight);
    }

    private static double uncorrelated(double apart) {
        if (apart < SMALL) {
            return apart * apart / 3.0;
        }
        return 1.0 - 0.5 * Math.sqrt(Math.PI) / apart * (apart > LARGE ? 1.0 : Faddeeva.erf(apart));
    }

    /**
     * The coherence of direct and reflected sound, 0 to 1.
     *
     * @param frequency frequency of the sound, Hz
     * @param soundSpeed speed of sound, m/s
     * @param length length of the paths, m
     * @param sourceHeight height of the source above the ground, m, 0 or more
     * @param receiverHeight height of the receiver above the ground, m, 0 or more
     */
    public double at(double frequency, double soundSpeed, double length, double sourceHeight, double receiverHeight) {
        double waveNumber = 2.0 * Math.PI * frequency / soundSpeed;
        return Math.exp(-exponent(length, separation(sourceHeight, receiverHeight)) * waveNumber * waveNumber);
    }
}
