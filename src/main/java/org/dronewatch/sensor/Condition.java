package org.dronewatch.sensor;

import java.util.Optional;

/**
 * A condition that a scene sets for the whole site, weather and light, or for its drones, and that a sensor's model may
 * or may not take into account.
 */
public enum Condition {
    /** Visibility: {@code world.light.visibility} and {@code world.light.contrastAtVisibility}. */
    VISIBILITY,
    /** Illuminance: {@code world.light.illuminance}. */
    ILLUMINANCE,
    /** Where the sun is: {@code world.light.sun}. */
    SUN,
    /** Turbulence of the air: {@code world.light.cn2}. */
    TURBULENCE,
    /** How bright the ground is behind a drone: {@code world.light.skyToGroundRatio}. */
    GROUND_BRIGHTNESS,
    /** How hard it rains: {@code world.rain}. */
    RAIN,
    /** Temperature, humidity and pressure of the air: {@code world.atmosphere}. */
    AIR,
    /**
     * Wind, and how the temperature changes with height: {@code world.atmosphere.wind}, {@code temperatureGradient}.
     */
    WIND,
    /** What makes noise on the site: {@code world.noiseSources} that state no level for the level model. */
    NOISE_SOURCES,
    /** How loud a drone is by its calibrated level: {@code drones.ID.soundLevel}, where only that is set. */
    SOUND_LEVEL("soundLevel"),
    /** How loud a drone is by its sound power: {@code drones.ID.soundPowerLevel}, where only that is set. */
    SOUND_POWER_LEVEL("soundPowerLevel"),
    /** The spectrum of a drone by its name in the library's table: {@code drones.ID.sound}. */
    SOUND("sound"),
    /** How a drone's sound depends on the direction: {@code drones.ID.directivity}. */
    DIRECTIVITY("directivity"),
    /** A drone's own spectrum: {@code drones.ID.spectrum}. */
    SPECTRUM("spectrum"),
    /** The lines in a drone's spectrum: {@code drones.ID.tones}. */
    TONES("tones");

    private final String droneSetting;

    Condition() {
        this("");
    }

    Condition(String droneSetting) {
        this.droneSetting = droneSetting;
    }

    /** The setting in {@code drones.ID} that is this condition; none for a condition of the whole site. */
    public Optional<String> droneSetting() {
        return Optional.of(droneSetting).filter(name -> !name.isEmpty());
    }
}
