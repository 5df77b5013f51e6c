package org.dronewatch.sensor.acoustic.propagation;

import java.util.List;
import java.util.Map;

/**
 * The sound of a drone at a microphone in one look.
 *
 * @param value the value that is compared with the threshold, dB
 * @param threshold the threshold that the value must reach for detection, dB
 * @param figures further results for reports, by names that include their units
 * @param ratios signal-to-noise ratio at one microphone in each octave band, dB; empty for a model without bands
 */
public record Heard(double value, double threshold, Map<String, Double> figures, List<Double> ratios) {

    /** A result of a model without bands. */
    public Heard(double value, double threshold, Map<String, Double> figures) {
        this(value, threshold, figures, List.of());
    }
}
