package org.dronewatch.sensor.acoustic.tone;

import org.dronewatch.sound.NarrowBand;

/**
 * A line as a microphone hears it.
 *
 * @param harmonic its number: 1 for the blade-passing frequency
 * @param band where it is heard, shifted by the drone's motion, and how wide it is
 * @param snr how far the drone's sound in that band, line and broadband part, is above the noise there, dB
 */
public record HeardTone(int harmonic, NarrowBand band, double snr) {}
