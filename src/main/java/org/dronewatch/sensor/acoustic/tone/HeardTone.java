package org.dronewatch.sensor.acoustic.tone;

import org.dronewatch.sound.NarrowBand;

/**
 * A tone at a microphone.
 *
 * @param harmonic its number: 1 for the blade-passing frequency
 * @param band its band, shifted by the drone's motion, and as wide as the tone
 * @param snr level of the drone's sound in that band, tone and broadband part, above the noise there, dB
 */
public record HeardTone(int harmonic, NarrowBand band, double snr) {}
