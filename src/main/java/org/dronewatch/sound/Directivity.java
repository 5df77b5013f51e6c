package org.dronewatch.sound;

/** The dependence of a source's level on the elevation at which the sound is radiated. */
public enum Directivity {
    /** The sound is the same in all directions. */
    OMNIDIRECTIONAL {
        @Override
        public double publishedGain(int band, double elevation) {
            return 0.0;
        }
    },
    /**
     * Directivity of rotors: from 500 Hz upwards, lower levels near their plane and higher levels above and below it.
     * The gain is a high shelf of {@code -0.0011 t^2 + 0.194 |t| - 4.9} dB, where t is the elevation from the rotors'
     * plane in degrees (Heutschi and others, Acta Acustica 4, 24, 2020); how a shelf at 500 Hz is apportioned among
     * octave bands is assumed: none of its gain up to 250 Hz, half of it (in dB) at 500 Hz, and all of it from 1 kHz
     * upwards.
     */
    ROTOR {
        @Override
        public double publishedGain(int band, double elevation) {
            double degrees = Math.abs(Math.toDegrees(elevation));
            return shelf(band) * (-0.0011 * degrees * degrees + 0.194 * degrees - 4.9);
        }
    },
    /**
     * Directivity of a DJI Matrice 300 in flight at 5 m/s, measured below it up to 60 degrees from the vertical
     * (Ramos-Romero and others, Aerospace Science and Technology 140, 108537, 2023). Nearer to the plane of the rotors,
     * the directivity is extrapolated; above the plane, the sound is assumed to be the same as below. The published
     * gain is the level at 1 m relative to the level straight below.
     */
    M300 {
        @Override
        public double publishedGain(int band, double elevation) {
            double fromVertical = Math.max(0.0, 0.5 * Math.PI - Math.abs(elevation));
            return Measured.M300.level(band, fromVertical) - Measured.M300.level(band, 0.0);
        }
    };

    /** Holds the tables, which are read when they are first needed. */
    private static final class Measured {
        private static final NoiseHemisphere M300 = new NoiseHemisphere("m300_hemisphere.csv");
    }

    private static final int SHELF = 3;
    private static final double HALFWAY = 0.5;
    private static final int STEPS = 2000;

    /** The means of the gains; null until they are needed, since they take as long as reading a site. */
    private volatile double[] mean;

    /**
     * Gain as published, dB, relative to a level that need not be the mean over all directions; {@link #index} is
     * relative to that mean.
     *
     * @param band 0 for 63 Hz to 7 for 8 kHz
     * @param elevation elevation from the rotors' plane, -pi/2 to pi/2 rad; the same above and below
     */
    public abstract double publishedGain(int band, double elevation);

    /**
     * Directivity index, dB, to be added to the sound power level for a direction. Its energy mean over all directions
     * is 0 dB, so that the sound power is unchanged.
     *
     * @param band 0 for 63 Hz to 7 for 8 kHz
     * @param elevation elevation from the rotors' plane, -pi/2 to pi/2 rad; the same above and below
     */
    public double index(int band, double elevation) {
        return publishedGain(band, elevation) - mean()[band];
    }

    private double[] mean() {
        double[] known = mean;
        if (known == null) {
            known = meanGains();
            mean = known;
        }
        return known;
    }

    private static double shelf(int band) {
        if (band == SHELF) {
            return HALFWAY;
        }
        return band > SHELF ? 1.0 : 0.0;
    }

    /**
     * The energy means of the gains over the sphere: equal steps of the sine of the elevation correspond to equal
     * areas.
     */
    private double[] meanGains() {
        double[] means = new double[OctaveBands.COUNT];
        for (int band = 0; band < means.length; band++) {
            double energy = 0.0;
            for (int i = 0; i < STEPS; i++) {
                energy += Levels.toRatio(publishedGain(band, Math.asin((i + HALFWAY) / STEPS)));
            }
            means[band] = Levels.ofRatio(energy / STEPS);
        }
        return means;
    }
}
