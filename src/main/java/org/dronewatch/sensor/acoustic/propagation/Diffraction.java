package org.dronewatch.sensor.acoustic.propagation;

import org.dronewatch.sound.Barrier;

/**
 * A method for the diffraction of sound around edges into a shadow. All methods but {@link #OFF} are approximations
 * without a step at the shadow boundary, where the attenuation is 4.77 dB. Where the source is visible above the edge,
 * the attenuation falls to 0 as the magnitude of the path difference grows to {@link #reach}.
 */
public enum Diffraction {
    /** No diffraction: sound reaches a shadow zone only by transmission through walls. */
    OFF {
        @Override
        public double attenuation(double pathDifference, double span, double wavelength) {
            return pathDifference < 0.0 ? 0.0 : Double.POSITIVE_INFINITY;
        }

        @Override
        public double reach(double wavelength) {
            return 0.0;
        }
    },
    /**
     * The curve through Maekawa's measurements, with the total path difference for several edges:
     * {@link Barrier#maekawa}.
     */
    MAEKAWA {
        @Override
        public double attenuation(double pathDifference, double span, double wavelength) {
            return Barrier.maekawa(pathDifference, wavelength);
        }

        @Override
        public double reach(double wavelength) {
            return Barrier.MAEKAWA_REACH * wavelength;
        }
    },
    /**
     * The engineering method of ISO 9613-2, at most 20 dB at one edge and 25 dB at several: {@link Barrier#iso9613}.
     */
    ISO9613 {
        @Override
        public double attenuation(double pathDifference, double span, double wavelength) {
            return Barrier.iso9613(pathDifference, span, wavelength);
        }

        @Override
        public double reach(double wavelength) {
            return Barrier.ISO_REACH * wavelength;
        }
    },
    /** The method of the European Union for noise maps (CNOSSOS-EU), at most 25 dB: {@link Barrier#cnossos}. */
    CNOSSOS {
        @Override
        public boolean measuresArcs() {
            return true;
        }

        @Override
        public double attenuation(double pathDifference, double span, double wavelength) {
            return Barrier.cnossos(pathDifference, span, wavelength);
        }

        @Override
        public double reach(double wavelength) {
            return Barrier.MAEKAWA_REACH * wavelength;
        }
    };

    /**
     * The attenuation by edges, relative to the sound without the obstacle.
     *
     * @param pathDifference length of the path over the edges minus that of the straight one, m; negative if the source
     *     is visible
     * @param span length of that path from the first edge to the last, m; 0 for one edge
     * @param wavelength above 0, m
     * @return 0 or more, dB; infinite if no sound is diffracted
     */
    public abstract double attenuation(double pathDifference, double span, double wavelength);

    /**
     * Whether the path difference of sound that bends down is computed from the lengths of the arcs, as in CNOSSOS-EU's
     * favourable conditions, instead of from travel times.
     */
    public boolean measuresArcs() {
        return false;
    }

    /**
     * The magnitude of the path difference, which is negative where the source is visible, up to which an edge
     * attenuates sound there.
     *
     * @param wavelength above 0, m
     * @return 0 or more, m
     */
    public abstract double reach(double wavelength);
}
