package org.dronewatch.sound;

import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * The background noise of a site, without drones: its level and its spectrum.
 *
 * @param level A-weighted total sound pressure level, -20 to 140 dB re 20 uPa
 * @param shape levels of the bands relative to one another, dB
 */
public record BackgroundNoise(@In(value = Quantity.LEVEL, from = -20, to = 140) double level, BandLevels shape) {
    /**
     * A spectrum that falls by 4 dB per octave. The slope is assumed: it lies between that of wind in leaves, which is
     * flatter, and that of distant traffic, which is steeper. Detection in separate bands depends strongly on it, so
     * measure the spectrum at your site.
     */
    public static final BandLevels FALLING = BandLevels.of(0, -4, -8, -12, -16, -20, -24, -28);

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public BackgroundNoise {
        Limits.check(BackgroundNoise.class, level, shape);
    }

    /** Noise with the default spectrum and an A-weighted level, dB re 20 uPa. */
    public static BackgroundNoise of(double level) {
        return new BackgroundNoise(level, FALLING);
    }

    /** Noise with a measured spectrum: sound pressure levels by band, dB re 20 uPa, without weighting. */
    public static BackgroundNoise of(BandLevels spectrum) {
        return new BackgroundNoise(spectrum.aWeighted(), spectrum);
    }

    /** Sound pressure levels by band, dB re 20 uPa, without weighting. */
    public BandLevels spectrum() {
        return shape.plus(level - shape.aWeighted());
    }
}
