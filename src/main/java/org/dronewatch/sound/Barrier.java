package org.dronewatch.sound;

/**
 * The attenuation of sound by the edges of an obstacle. The path difference is the length of the path from the source
 * over the edges to the receiver minus that of the straight line, m: positive where the obstacle hides the source, 0 at
 * the shadow boundary, negative where the source is visible above the edge.
 */
public final class Barrier {
    /** Upper limit of the attenuation by a single edge in ISO 9613-2, dB. */
    public static final double ISO_SINGLE_EDGE_LIMIT = 20.0;

    /**
     * Upper limit of the attenuation by several edges in ISO 9613-2, and by any number of edges in the other methods,
     * dB.
     */
    public static final double LIMIT = 25.0;

    /**
     * Distance from the first edge to the last, m, up to which CNOSSOS-EU, section 2.5.6, treats several edges as one.
     */
    public static final double SINGLE_EDGE_SPAN = 0.3;

    /**
     * Magnitude of the negative path difference, in wavelengths, beyond which an edge causes no attenuation by
     * Maekawa's curve: a Fresnel number of -0.1, since the Fresnel number counts half wavelengths.
     */
    public static final double MAEKAWA_REACH = 0.05;

    /**
     * Magnitude of the negative path difference, in wavelengths, beyond which an edge causes no attenuation in ISO
     * 9613-2: a Fresnel number of -0.2.
     */
    public static final double ISO_REACH = 0.1;

    private static final double AT_THE_BORDER = 3.0;
    private static final double SLOPE = 20.0;

    private Barrier() {}

    /**
     * Fresnel number: path difference in half wavelengths, with its sign.
     *
     * @param pathDifference path difference, m
     * @param wavelength wavelength, above 0, m
     */
    public static double fresnelNumber(double pathDifference, double wavelength) {
        return 2.0 * pathDifference / wavelength;
    }

    /**
     * Attenuation by a thin half-plane, {@code 10 lg(3 + 20 N)} with the Fresnel number N: the curve through Maekawa's
     * measurements (Applied Acoustics 1, 157, 1968) for a point source. The attenuation is 0 below N = -0.1, where the
     * formula reaches 0, and at most {@value #LIMIT} dB, the limit of the standards, since scattering and turbulence
     * fill deeper shadows.
     *
     * @param pathDifference path difference, m
     * @param wavelength wavelength, above 0, m
     * @return 0 to 25 dB
     */
    public static double maekawa(double pathDifference, double wavelength) {
        return Math.min(LIMIT, attenuation(SLOPE * fresnelNumber(pathDifference, wavelength)));
    }

    /**
     * Attenuation according to ISO 9613-2:1996, equation (14), with C2 = 20 (reflections from the ground included) and
     * Kmet = 1 (the path is not bent by wind or temperature); C3 is 1 for one edge and that of equation (15) for
     * several. The attenuation is at most {@value #ISO_SINGLE_EDGE_LIMIT} dB for one edge, and {@value #LIMIT} dB for
     * several.
     *
     * @param pathDifference path difference, m
     * @param span distance from the first edge to the last along the path, 0 for one edge, m
     * @param wavelength wavelength, above 0, m
     * @return 0 to 25 dB
     */
    public static double iso9613(double pathDifference, double span, double wavelength) {
        double limit = span > 0.0 ? LIMIT : ISO_SINGLE_EDGE_LIMIT;
        return Math.min(limit, attenuation(SLOPE * ofSeveralEdges(span, wavelength) * pathDifference / wavelength));
    }

    /**
     * Attenuation according to CNOSSOS-EU (Directive (EU) 2015/996, section 2.5.6),
     * {@code 10 lg(3 + 40 C'' delta / lambda)}, where delta is the path difference and lambda the wavelength, in still
     * air (homogeneous conditions); for one edge, this is Maekawa's curve. The factor C'' for several edges is 1 for a
     * span of up to {@value #SINGLE_EDGE_SPAN} m. The attenuation is at most {@value #LIMIT} dB.
     *
     * @param pathDifference path difference, m
     * @param span distance from the first edge to the last along the path, 0 for one edge, m
     * @param wavelength wavelength, above 0, m
     * @return 0 to 25 dB
     */
    public static double cnossos(double pathDifference, double span, double wavelength) {
        double several = span > SINGLE_EDGE_SPAN ? ofSeveralEdges(span, wavelength) : 1.0;
        return Math.min(LIMIT, attenuation(SLOPE * several * fresnelNumber(pathDifference, wavelength)));
    }

    /**
     * The factor for several edges, C3 of ISO 9613-2 and C'' of CNOSSOS-EU: from 1 for edges close together to 3 for
     * edges many wavelengths apart.
     */
    private static double ofSeveralEdges(double span, double wavelength) {
        if (!(span > 0.0)) {
            return 1.0;
        }
        double square = 25.0 * wavelength * wavelength / (span * span);
        // For edges close together, the square may be infinite.
        return Double.isInfinite(square) ? 1.0 : (1.0 + square) / (1.0 / 3.0 + square);
    }

    private static double attenuation(double beyondTheBorder) {
        return Levels.ofRatio(Math.max(1.0, AT_THE_BORDER + beyondTheBorder));
    }
}
