package org.dronewatch.sensor;

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
    /** How hard it rains: {@code world.rain}. */
    RAIN,
    /** Temperature, humidity and pressure of the air: {@code world.atmosphere}. */
    AIR,
    /** Wind, and how the temperature changes with height: {@code world.atmosphere.wind}, {@code temperatureGradient}. */
    WIND,
    /** What makes noise on the site: {@code world.noiseSources} that state no level for the level model. */
    NOISE_SOURCES,
    /** A drone's own spectrum: {@code drones.ID.spectrum}. */
    SPECTRUM,
    /** The lines in a drone's spectrum: {@code drones.ID.tones}. */
    TONES
}
