package org.dronewatch.sensor;

/**
 * A condition of weather or light that a scene sets for the whole site, and that a sensor's model may or may not take
 * into account.
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
    NOISE_SOURCES
}
