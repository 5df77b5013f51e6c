package org.dronewatch.sensor.acoustic.propagation;

import org.dronewatch.sound.Barrier;

/**
 * How sound bends round edges into a shadow. All are approximations; none has a step at the shadow boundary, where the
 * attenuation is 4.77 dB: it fades to zero where the source is visible above the edge, within {@link #reach}.
 */
public enum Diffraction {
    /** No diffraction: only transmission through walls reaches the shadow zone. */
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
     * The curve through Maekawa's measurements, over the whole detour where there are several edges:
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
     * The attenuation by edges of the sound that would arrive without the obstacle.
     *
     * @param pathDifference how much longer the path over the edges is than the straight one, m; negative where the
     *     source is visible
     * @param span how long that path is from the first edge to the last, m; 0 for one edge
     * @param wavelength above 0, m
     * @return 0 or more, dB
     */
    public abstract double attenuation(double pathDifference, double span, double wavelength);

    /**
     * Whether the path difference of sound that bends down is that of the arcs' lengths, as in CNOSSOS-EU's favourable
     * conditions, rather than that of the times which sound takes.
     */
    public boolean measuresArcs() {
        return false;
    }

    /**
     * How far above the edge a line of sight is free of it.
     *
     * @param wavelength above 0, m
     * @return how much longer the path that touches the edge then is than the line, m
     */
    public abstract double reach(double wavelength);
}
