package org.dronewatch.sensor.acoustic.energy;

import java.util.Arrays;
import java.util.OptionalDouble;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;

/**
 * The decay of sound at a sensor after the source stops, in each octave band and in all bands together: received energy
 * by time of arrival, integrated backward (Schroeder, "New method of measuring reverberation time", JASA 37, 1965).
 */
public final class DecayCurve {
    /** Width of a time bin, s. */
    public static final double BIN = 2e-3;

    private static final int BANDS = OctaveBands.COUNT;
    private static final int BINS = 8192;
    private static final double FROM = -5.0;
    private static final double SPAN = 30.0;

    /** The energy received, by bin and, within each bin, by band, since each arrival adds to all bands at once. */
    private final double[] received = new double[BINS * BANDS];

    /** The bins from this one on are empty. */
    private int used;

    /** Adds energy in each band that arrives at a time, s; energy after the last bin, 16 s, is left out. */
    void add(double time, double[] inBand) {
        int bin = (int) (time / BIN);
        if (bin < BINS) {
            used = Math.max(used, bin + 1);
            for (int band = 0; band < BANDS; band++) {
                received[bin * BANDS + band] += inBand[band];
            }
        }
    }

    /** Adds all of another curve. */
    void add(DecayCurve other) {
        add(other, 1.0);
    }

    /** Adds a multiple of another curve. */
    void add(DecayCurve other, double factor) {
        used = Math.max(used, other.used);
        for (int i = 0; i < other.used * BANDS; i++) {
            received[i] += factor * other.received[i];
        }
    }

    /** This curve minus another one that is part of it. */
    DecayCurve without(DecayCurve part) {
        DecayCurve rest = scaled(1.0);
        for (int i = 0; i < part.used * BANDS; i++) {
            // Rounding must not leave negative energy.
            rest.received[i] = Math.max(0.0, rest.received[i] - part.received[i]);
        }
        return rest;
    }

    void clear() {
        Arrays.fill(received, 0, used * BANDS, 0.0);
        used = 0;
    }

    /** A new curve with all energies scaled by a factor. */
    DecayCurve scaled(double factor) {
        DecayCurve scaled = new DecayCurve();
        scaled.add(this, factor);
        return scaled;
    }

    /**
     * Remaining (backward-integrated) energy of all bands at the start of each bin, dB relative to the total; minus
     * infinity after the last arrival and for silence.
     */
    public double[] levels() {
        return levels(0, BANDS);
    }

    private double[] levels(int firstBand, int endBand) {
        double[] levels = new double[BINS];
        double toCome = 0.0;
        for (int i = BINS - 1; i >= 0; i--) {
            for (int band = firstBand; band < endBand; band++) {
                toCome += received[i * BANDS + band];
            }
            levels[i] = toCome;
        }
        for (int i = 0; i < BINS; i++) {
            levels[i] = toCome > 0.0 ? Levels.ofRatio(levels[i] / toCome) : Double.NEGATIVE_INFINITY;
        }
        return levels;
    }

    /**
     * Reverberation time T30 of all bands, s: twice the time in which the regression line falls from -5 to -35 dB (ISO
     * 3382-1); empty when the curve does not fall that far.
     */
    public OptionalDouble t30() {
        return t30(levels());
    }

    /**
     * Reverberation time T30 of an octave band, s; empty when the band's curve does not fall far enough.
     *
     * @param band 0 for 63 Hz to 7 for 8 kHz
     */
    public OptionalDouble t30(int band) {
        return t30(levels(band, band + 1));
    }

    private static OptionalDouble t30(double[] levels) {
        double n = 0;
        double sumT = 0;
        double sumL = 0;
        double sumTt = 0;
        double sumTl = 0;
        for (int i = 0; i < BINS && levels[i] >= FROM - SPAN; i++) {
            if (levels[i] <= FROM) {
                double t = i * BIN;
                n++;
                sumT += t;
                sumL += levels[i];
                sumTt += t * t;
                sumTl += t * levels[i];
            }
        }
        double slope = (n * sumTl - sumT * sumL) / (n * sumTt - sumT * sumT);
        boolean reached =
                Arrays.stream(levels).anyMatch(level -> level < FROM - SPAN && level > Double.NEGATIVE_INFINITY);
        return reached && slope < 0 ? OptionalDouble.of(-60.0 / slope) : OptionalDouble.empty();
    }
}
