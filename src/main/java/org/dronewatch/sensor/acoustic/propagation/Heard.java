package org.dronewatch.sensor.acoustic.propagation;

import java.util.Map;

/**
 * What a microphone hears of a drone in one look.
 *
 * @param value that is compared with the threshold, dB
 * @param threshold that it must reach, dB
 * @param figures for reports, by name with unit
 */
public record Heard(double value, double threshold, Map<String, Double> figures) {}
