package org.dronewatch.drone;

import java.util.List;
import org.dronewatch.sound.BandLevels;
import org.dronewatch.sound.Tone;

/**
 * A model of the sound that a drone radiates, given its settings and its flight; how the sound travels is left to the
 * propagation model of each microphone. Implementations are immutable records, and may be called by any thread;
 * {@link org.dronewatch.setting.Kind} explains how scene files can choose a new one. They are given the drone as it was
 * when the sound left it: its velocity, its attitude, and whether its motors run.
 *
 * <p>Each emission defines the meaning of a drone's sound settings. An emission that changes only the level can take
 * the rest from {@link SteadyEmission}; the dependence on direction is always set by {@code directivity}.
 */
public interface SoundEmission {

    /**
     * Whether the drone's settings alone determine its sound, however it flies, except that the motors may be off.
     * False unless overridden: the sound may depend on the position, the velocity, the attitude, and on settings of the
     * emission itself.
     */
    default boolean isStatedBySettings() {
        return false;
    }

    /**
     * Sound power levels by octave band without weighting, dB re 1 pW, for the energy model.
     *
     * @param drone the drone, as it was when the sound left it
     */
    BandLevels soundPower(Drone drone);

    /**
     * The source level for the level model, dB on the calibrated scale of that model: unless overridden, that of the
     * settings, less the glide reduction when the motors are off. Always finite.
     *
     * @param drone the drone, as it was when the sound left it
     */
    default double soundLevel(Drone drone) {
        return SteadyEmission.DEFAULT.soundLevel(drone);
    }

    /**
     * The tones in the drone's sound, which are part of its sound power: unless overridden, those of the settings, and
     * none when the motors are off.
     *
     * @param drone the drone, as it was when the sound left it
     */
    default List<Tone> tones(Drone drone) {
        return SteadyEmission.DEFAULT.tones(drone);
    }
}
