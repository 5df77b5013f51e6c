package org.dronewatch.sound;

/**
 * The attenuation of sound by a single edge. The path difference is the path from the source over the edge to the
 * receiver less the straight path, m: positive where the edge hides the source, 0 at the shadow's border, negative
 * where the source is seen above the edge.
 */
public final class Barrier {
    /** Upper limit of the attenuation by a single edge in ISO 9613-2, dB. */
    public static final double ISO_SINGLE_EDGE_LIMIT = 20.0;

    private static final double AT_THE_BORDER = 3.0;
    private static final double SLOPE = 20.0;

    private Barrier() {}

    /**
     * Fresnel number: path difference in half wavelengths, with its sign.
     *
     * @param pathDifference m
     * @param wavelength above 0, m
     */
    public static double fresnelNumber(double pathDifference, double wavelength) {
        return 2.0 * pathDifference / wavelength;
    }

    /**
     * Attenuation by a thin half-plane, {@code 10 lg(3 + 20 N)}: the curve through Maekawa's measurements (Applied
     * Acoustics 1, 157, 1968) for a point source. Nothing below N = -0.1, where the formula reaches 0.
     *
     * @param pathDifference m
     * @param wavelength above 0, m
     * @return 0 or more, dB
     */
    public static double maekawa(double pathDifference, double wavelength) {
        return attenuation(SLOPE * fresnelNumber(pathDifference, wavelength));
    }

    /**
     * Attenuation by a single edge after ISO 9613-2:1996, equation (14), with C2 = 20 (reflections from the ground
     * included), C3 = 1 (one edge) and Kmet = 1 (no bending by wind or temperature), at most
     * {@value #ISO_SINGLE_EDGE_LIMIT} dB.
     *
     * @param pathDifference m
     * @param wavelength above 0, m
     * @return 0 to 20 dB
     */
    public static double iso9613(double pathDifference, double wavelength) {
        return Math.min(ISO_SINGLE_EDGE_LIMIT, attenuation(SLOPE * pathDifference / wavelength));
    }

    private static double attenuation(double beyondTheBorder) {
        return Levels.ofRatio(Math.max(1.0, AT_THE_BORDER + beyondTheBorder));
    }
}
