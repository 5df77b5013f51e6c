package org.dronewatch.sensor.acoustic.propagation;

import org.dronewatch.geometry.Position;

/**
 * The properties of a microphone for propagation models.
 *
 * @param position position of the microphone, or of the array's centre, m
 * @param radius distance within which a ray must pass to be received, above 0, m
 * @param threshold level above the background that a sound must reach, dB
 * @param arrayGain gain of an array over a single microphone, 0 or more, dB
 */
public record Microphone(Position position, double radius, double threshold, double arrayGain) {

    /**
     * The level at and above which a sound is detected over a background, dB with the same reference as the background.
     */
    public double detectionLevel(double background) {
        return background + threshold - arrayGain;
    }
}
