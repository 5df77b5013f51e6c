package org.dronewatch.sensor.acoustic.energy;

import java.util.Arrays;
import java.util.OptionalDouble;
import org.dronewatch.sound.Levels;

/**
 * How sound dies away at a sensor after the source stops: received energy by time of arrival, integrated backward
 * (Schroeder, "New method of measuring reverberation time", JASA 37, 1965).
 */
public final class DecayCurve {
    /** Width of a bin, s. */
    public static final double BIN = 2e-3;

    private static final int BINS = 8192;
    private static final double FROM = -5.0;
    private static final double SPAN = 30.0;

    private final double[] received = new double[BINS];

    /** Adds energy that arrives at a time, s; what comes after the last bin, 16 s, is left out. */
    void add(double time, double energy) {
        int bin = (int) (time / BIN);
        if (bin < BINS) {
            received[bin] += energy;
        }
    }

    /** Adds all of another curve. */
    void add(DecayCurve other) {
        for (int bin = 0; bin < BINS; bin++) {
            received[bin] += other.received[bin];
        }
    }

    void clear() {
        Arrays.fill(received, 0.0);
    }

    /** A new curve with all energies scaled by a factor. */
    DecayCurve scaled(double factor) {
        DecayCurve scaled = new DecayCurve();
        for (int bin = 0; bin < BINS; bin++) {
            scaled.received[bin] = factor * received[bin];
        }
        return scaled;
    }

    /**
     * Remaining (backward-integrated) energy at the start of each bin, dB re the total; minus infinity after the last
     * arrival and for silence.
     */
    public double[] levels() {
        double[] levels = new double[BINS];
        double toCome = 0.0;
        for (int i = BINS - 1; i >= 0; i--) {
            toCome += received[i];
            levels[i] = toCome;
        }
        for (int i = 0; i < BINS; i++) {
            levels[i] = toCome > 0.0 ? Levels.ofRatio(levels[i] / toCome) : Double.NEGATIVE_INFINITY;
        }
        return levels;
    }

    /**
     * Reverberation time T30, s: twice the time that the regression line from -5 to -35 dB takes (ISO 3382-1); empty
     * when the curve does not reach so far down.
     */
    public OptionalDouble t30() {
        double[] levels = levels();
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
