package org.dronewatch.sensor.acoustic.propagation;

import org.dronewatch.sound.Barrier;

/**
 * How sound bends round an edge into a shadow. Both are approximations for a single edge, applied in the shadow only:
 * at its border they step from 0 to 5 dB.
 */
public enum Diffraction {
    /** No diffraction: only transmission through walls reaches the shadow zone. */
    OFF {
        @Override
        public double attenuation(double pathDifference, double wavelength) {
            return Double.POSITIVE_INFINITY;
        }
    },
    /** The curve through Maekawa's measurements: {@link Barrier#maekawa}. */
    MAEKAWA {
        @Override
        public double attenuation(double pathDifference, double wavelength) {
            return Barrier.maekawa(pathDifference, wavelength);
        }
    },
    /** The engineering method of ISO 9613-2, at most 20 dB: {@link Barrier#iso9613}. */
    ISO9613 {
        @Override
        public double attenuation(double pathDifference, double wavelength) {
            return Barrier.iso9613(pathDifference, wavelength);
        }
    };

    /**
     * The attenuation by the edge of the sound that would arrive without the obstacle.
     *
     * @param pathDifference how much longer the path over the edge is than the straight one, 0 or more, m
     * @param wavelength above 0, m
     * @return dB
     */
    public abstract double attenuation(double pathDifference, double wavelength);
}
