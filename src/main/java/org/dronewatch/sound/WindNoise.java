package org.dronewatch.sound;

/**
 * The noise that wind causes at a microphone in a windscreen: {@code L = 40 lg V - 23 lg(f D / V) + 15} in each
 * third-octave band, where L is the level in dB re 20 uPa, V the wind speed in m/s, f the midband frequency in Hz and D
 * the screen's diameter in m (M. Strasberg, JASA 83, 544, 1988, from the measurements of four authors, within about 3
 * dB for Strouhal numbers f D / V of 0.1 to 5; in SI units in G. P. van den Berg, "The sounds of high winds", Groningen
 * 2006, equation VIII.2). Outside this range of Strouhal numbers, the formula is extrapolated. The measurements were
 * made in smooth flow: natural wind, which is gusty, causes more noise at low frequencies.
 */
public final class WindNoise {
    /** Diameter of a common foam windscreen, m. */
    public static final double SCREEN = 0.09;

    private static final double THIRD_OF_AN_OCTAVE = 0.1;

    private WindNoise() {}

    /**
     * The level in an octave band, dB re 20 uPa; minus infinity in still air.
     *
     * @param band 0 for 63 Hz to 7 for 8 kHz
     * @param speed speed of the wind at the microphone, m/s, 0 or more
     */
    public static double level(int band, double speed) {
        if (!(speed > 0.0)) {
            return Double.NEGATIVE_INFINITY;
        }
        double[] thirds = new double[3];
        for (int third = 0; third < thirds.length; third++) {
            double frequency = OctaveBands.midband(band) * Math.pow(10.0, THIRD_OF_AN_OCTAVE * (third - 1));
            thirds[third] = 40.0 * Math.log10(speed) - 23.0 * Math.log10(frequency * SCREEN / speed) + 15.0;
        }
        return Levels.sum(thirds);
    }
}
