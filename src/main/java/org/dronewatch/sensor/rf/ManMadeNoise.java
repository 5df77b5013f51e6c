package org.dronewatch.sensor.rf;

/**
 * Man-made radio noise by type of surroundings: the median external noise figure for a lossless antenna,
 * {@code Fam = c - d lg f} dB above the thermal noise {@code k T0 B} at T0 = 290 K, where f is the frequency in MHz and
 * c and d are constants of the surroundings, from 0.3 to 250 MHz (ITU-R P.372-17, section on man-made noise). In half
 * of all locations it is higher. The recommendation gives no figures above 250 MHz; those of {@link #BUSINESS} areas,
 * up to 900 MHz, are from the older P.372-8.
 */
public enum ManMadeNoise {
    /** City: 76.8 - 27.7 lg f. */
    CITY(76.8, 27.7),
    /**
     * Business area, from the older ITU-R P.372-8: as for a city, but {@code 44.3 - 12.3 lg f} from 129 MHz to 900 MHz.
     * Measured in the 1970s.
     */
    BUSINESS(76.8, 27.7),
    /** Residential area: 72.5 - 27.7 lg f. */
    RESIDENTIAL(72.5, 27.7),
    /** Rural area: 67.2 - 27.7 lg f. */
    RURAL(67.2, 27.7),
    /** Quiet rural area, far from electrical equipment: 53.6 - 28.6 lg f. */
    QUIET_RURAL(53.6, 28.6);

    private static final double MEGAHERTZ = 1e6;
    private static final double LOWEST = 0.3e6;
    private static final double HIGHEST = 250e6;
    private static final double HIGHEST_OF_BUSINESS = 900e6;

    private final double level;
    private final double slope;

    ManMadeNoise(double level, double slope) {
        this.level = level;
        this.slope = slope;
    }

    /** The highest frequency with a figure, Hz. */
    public double highestFrequency() {
        return this == BUSINESS ? HIGHEST_OF_BUSINESS : HIGHEST;
    }

    /**
     * The ratio of the noise power received by an antenna to that of a resistor at 290 K: 1 or more, since ground and
     * air are about that warm, and 1 at frequencies without a figure.
     *
     * @param frequency frequency f, Hz
     */
    public double ratio(double frequency) {
        if (frequency < LOWEST || frequency > highestFrequency()) {
            return 1.0;
        }
        return Math.max(1.0, Math.pow(10.0, 0.1 * median(frequency)));
    }

    private double median(double frequency) {
        double decades = Math.log10(frequency / MEGAHERTZ);
        double figure = level - slope * decades;
        return this == BUSINESS ? Math.max(figure, 44.3 - 12.3 * decades) : figure;
    }
}
