package org.dronewatch.sound;

import org.dronewatch.setting.Check;

/**
 * What a source sends out.
 *
 * @param power sound power levels by octave band without weighting, dB re 1 pW
 * @param directivity how it depends on the direction
 */
public record EmissionSettings(BandLevels power, Directivity directivity) {

    /**
     * Checks that both are there.
     *
     * @throws IllegalArgumentException when one is missing
     */
    public EmissionSettings {
        Check.present("power", power);
        Check.present("directivity", directivity);
    }

    /**
     * The sound of a kind of drone in the library's table at its own loudness, the same in all directions.
     *
     * @param name such as {@code c1-quadrotor}; see {@link DroneSounds#names()}
     * @throws org.dronewatch.setting.InputException when there is none; names the nearest ones
     */
    public static EmissionSettings ofClass(String name) {
        DroneSound sound = DroneSounds.get(name);
        return new EmissionSettings(BandLevels.of(sound.octaves(sound.level())), Directivity.OMNIDIRECTIONAL);
    }

    /** This source with another spectrum, dB re 1 pW. */
    public EmissionSettings withPower(BandLevels levels) {
        return new EmissionSettings(levels, directivity);
    }

    /** This source with another directivity. */
    public EmissionSettings withDirectivity(Directivity other) {
        return new EmissionSettings(power, other);
    }

    /** This source as loud as an A-weighted sound power level says, dB re 1 pW, with the same spectrum. */
    public EmissionSettings withAWeighted(double level) {
        return withPower(power.plus(level - power.aWeighted()));
    }

    /**
     * Sound power level that a source alike in all directions would need to be as loud in this one, dB re 1 pW.
     *
     * @param band 0 for 63 Hz to 7 for 8 kHz
     * @param elevation from the rotors' plane, -pi/2 to pi/2 rad
     */
    public double level(int band, double elevation) {
        return power.level(band) + directivity.index(band, elevation);
    }
}
