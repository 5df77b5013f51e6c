package org.dronewatch.sensor.acoustic.propagation;

import org.dronewatch.geometry.Position;

/**
 * What a propagation model needs to know of a microphone.
 *
 * @param position its centre, m
 * @param radius rays that pass within this distance are heard, above 0, m
 * @param threshold how far above the background a sound must be, dB
 * @param arrayGain gain of an array over a single microphone, 0 or more, dB
 */
public record Microphone(Position position, double radius, double threshold, double arrayGain) {

    /** The level at and above which a sound is detected over a background: dB, as the background. */
    public double detectionLevel(double background) {
        return background + threshold - arrayGain;
    }
}
