package org.dronewatch.sensor.acoustic.tone;

import org.dronewatch.sound.NarrowBand;

/**
 * A tone at a microphone.
 *
 * @param harmonic number of the harmonic: 1 for the blade-passing frequency
 * @param band the band of the tone, as wide as the tone, and Doppler-shifted by the drone's motion
 * @param snr signal-to-noise ratio in that band, dB: the signal is the tone and the drone's broadband sound
 */
public record HeardTone(int harmonic, NarrowBand band, double snr) {}
