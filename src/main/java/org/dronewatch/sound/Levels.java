package org.dronewatch.sound;

/** Arithmetic of levels in decibels. */
public final class Levels {
    private Levels() {}

    /** The level of a ratio of powers or energies, dB; minus infinity for 0. */
    public static double ofRatio(double ratio) {
        return 10.0 * Math.log10(ratio);
    }

    /** The ratio of powers or energies that corresponds to a level, dB. */
    public static double toRatio(double level) {
        return Math.pow(10.0, 0.1 * level);
    }

    /** The total level of incoherent sounds, dB; minus infinity if there are none. */
    public static double sum(double... levels) {
        double ratio = 0.0;
        for (double level : levels) {
            ratio += toRatio(level);
        }
        return ofRatio(ratio);
    }

    /**
     * The sound power level of a source (dB re 1 pW) minus its sound pressure level (dB re 20 uPa) at a distance of r
     * metres, due to spherical spreading: {@code 10 lg(4 pi r^2)}, for the reference impedance of 400 Pa s/m.
     *
     * @param distance distance r, above 0, m
     * @return the difference, dB
     */
    public static double sphericalSpreading(double distance) {
        return ofRatio(4.0 * Math.PI * distance * distance);
    }
}
