package org.dronewatch.sound;

/** The eight octave bands from 63 Hz to 8 kHz, numbered from 0. */
public final class OctaveBands {
    /** The number of bands. */
    public static final int COUNT = 8;

    /** Number of the band at 1 kHz. */
    public static final int ONE_KILOHERTZ = 4;

    private static final int[] NOMINAL = {63, 125, 250, 500, 1000, 2000, 4000, 8000};

    /** IEC 61672-1, table 3, rounded to 0.1 dB as usual. */
    private static final double[] A_WEIGHTS = {-26.2, -16.1, -8.6, -3.2, 0.0, 1.2, 1.0, -1.1};

    private OctaveBands() {}

    /** Exact midband frequency, Hz: {@code 1000 * 10^(0.3 k)} for the k-th band above 1 kHz (IEC 61260-1, base ten). */
    public static double midband(int band) {
        return 1000.0 * Math.pow(10.0, 0.3 * (band - ONE_KILOHERTZ));
    }

    /** The nominal midband frequency, Hz. */
    public static int nominal(int band) {
        return NOMINAL[band];
    }

    /** The A-weighting of a band, dB. */
    public static double aWeight(int band) {
        return A_WEIGHTS[band];
    }
}
