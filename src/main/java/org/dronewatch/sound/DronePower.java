package org.dronewatch.sound;

import java.util.ArrayList;
import java.util.List;

/** How a drone's sound power is spread over the octave bands. */
public final class DronePower {
    /** The octave of 250 Hz, the lowest with sound in it. */
    private static final int LOWEST = 2;

    private DronePower() {}

    /**
     * Sound power levels by octave band, dB re 1 pW: equal after A-weighting from 250 Hz to 8 kHz, and nothing below. This
     * is assumed, as no octave spectrum of a named drone was at hand: propellers' tones lie above 150 Hz, and measured
     * A-weighted spectra are flat within some decibels over these octaves.
     *
     * @param aWeighted A-weighted sound power level of all bands together, dB re 1 pW
     */
    public static List<Double> octaves(double aWeighted) {
        double each = aWeighted - Levels.ofRatio(OctaveBands.COUNT - LOWEST);
        List<Double> levels = new ArrayList<>();
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            levels.add(band < LOWEST ? Double.NEGATIVE_INFINITY : each - OctaveBands.aWeight(band));
        }
        return levels;
    }
}
