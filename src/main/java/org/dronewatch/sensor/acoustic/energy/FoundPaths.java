package org.dronewatch.sensor.acoustic.energy;

import java.util.Arrays;
import org.dronewatch.sound.OctaveBands;

/**
 * Paths that were found one by one: the sound that arrives along them, as intensity divided by the source's power in
 * all bands, 1/m2.
 */
final class FoundPaths {
    private static final int BANDS = OctaveBands.COUNT;

    private final double[] heard = new double[BANDS];
    private double[] lengths = new double[16];
    private double[] brought = new double[16 * BANDS];
    private final double[] arriving = new double[BANDS];
    private int count;

    void clear() {
        Arrays.fill(heard, 0.0);
        count = 0;
    }

    /**
     * Adds a path.
     *
     * @param length length of the path, m
     * @param inBand sound that arrives along it, by band
     */
    void add(double length, double[] inBand) {
        for (int band = 0; band < BANDS; band++) {
            heard[band] += inBand[band];
        }
        append(length, inBand, 0);
    }

    /** Adds all paths of another collection. */
    void add(FoundPaths others) {
        for (int i = 0; i < others.count; i++) {
            append(others.lengths[i], others.brought, i * BANDS);
        }
        for (int band = 0; band < BANDS; band++) {
            heard[band] += others.heard[band];
        }
    }

    private void append(double length, double[] inBand, int from) {
        if (count == lengths.length) {
            lengths = Arrays.copyOf(lengths, 2 * count);
            brought = Arrays.copyOf(brought, 2 * count * BANDS);
        }
        lengths[count] = length;
        System.arraycopy(inBand, from, brought, count * BANDS, BANDS);
        count++;
    }

    /** The sound heard along all paths in a band. */
    double heard(int band) {
        return heard[band];
    }

    /** Adds the sound of every path to a decay curve at its time of arrival. */
    void addTo(DecayCurve decay, double soundSpeed) {
        for (int i = 0; i < count; i++) {
            System.arraycopy(brought, i * BANDS, arriving, 0, BANDS);
            decay.add(lengths[i] / soundSpeed, arriving);
        }
    }
}
