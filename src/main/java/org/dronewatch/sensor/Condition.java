package org.dronewatch.sensor;

import java.util.Optional;

/**
 * A condition that the model of a sensor may or may not take into account: the weather and the light at the site, or
 * the sound of the drones.
 */
public enum Condition {
    /** Visibility: {@code world.light.visibility} and {@code world.light.contrastAtVisibility}. */
    VISIBILITY,
    /** Illuminance: {@code world.light.illuminance}. */
    ILLUMINANCE,
    /** The position of the sun: {@code world.light.sun}. */
    SUN,
    /** Turbulence of the air: {@code world.light.cn2}. */
    TURBULENCE,
    /**
     * The luminance of the ground behind a drone, relative to that of the sky: {@code world.light.skyToGroundRatio}.
     */
    GROUND_BRIGHTNESS,
    /** The rain rate: {@code world.rain}. */
    RAIN,
    /** Temperature, humidity and pressure of the air: {@code world.atmosphere}. */
    AIR,
    /** Wind, and the change of temperature with height: {@code world.atmosphere.wind}, {@code temperatureGradient}. */
    WIND,
    /** The noise sources of the site: those of {@code world.noiseSources} that state no level for the level model. */
    NOISE_SOURCES,
    /**
     * The source level of a drone in the level model: {@code drones.ID.soundLevel}, set without
     * {@code soundPowerLevel}.
     */
    SOUND_LEVEL("soundLevel"),
    /** The sound power level of a drone: {@code drones.ID.soundPowerLevel}, set without {@code soundLevel}. */
    SOUND_POWER_LEVEL("soundPowerLevel"),
    /** The spectrum of a drone, chosen by name from the library's table: {@code drones.ID.sound}. */
    SOUND("sound"),
    /** The dependence of a drone's sound on direction: {@code drones.ID.directivity}. */
    DIRECTIVITY("directivity"),
    /** A spectrum given for a drone: {@code drones.ID.spectrum}. */
    SPECTRUM("spectrum"),
    /** The tones in a drone's spectrum: {@code drones.ID.tones}. */
    TONES("tones");

    private final String droneSetting;

    Condition() {
        this("");
    }

    Condition(String droneSetting) {
        this.droneSetting = droneSetting;
    }

    /** The setting in {@code drones.ID} that states this condition; empty for a condition of the whole site. */
    public Optional<String> droneSetting() {
        return Optional.of(droneSetting).filter(name -> !name.isEmpty());
    }
}
