package org.dronewatch.sound;

import java.util.OptionalDouble;

/**
 * A tone in a drone's spectrum.
 *
 * @param harmonic number of the harmonic: 1 for the blade-passing frequency
 * @param frequency frequency emitted by the drone, Hz, above 0
 * @param share fraction of the power in its octave band that is in the tone, 0 to 1
 */
public record Tone(int harmonic, double frequency, double share) {

    /**
     * The frequency at which the tone is heard, Hz: {@code f / (1 - v / c)} (Doppler), where f is the emitted
     * frequency, v the speed of approach and c the speed of sound. Empty at and above the speed of sound, where a shock
     * wave forms.
     *
     * @param approach speed of the drone towards the listener when it emitted the sound, m/s; negative when it flies
     *     away
     * @param soundSpeed speed of sound in the air, m/s, above 0
     */
    public OptionalDouble heard(double approach, double soundSpeed) {
        double compressed = 1.0 - approach / soundSpeed;
        return compressed > 0.0 ? OptionalDouble.of(frequency / compressed) : OptionalDouble.empty();
    }
}
