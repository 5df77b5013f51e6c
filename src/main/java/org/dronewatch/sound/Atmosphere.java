package org.dronewatch.sound;

import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * The air of a site. Absorption of sound is computed for the same temperature, humidity and pressure everywhere; wind
 * and a change of temperature with height bend the paths of sound.
 *
 * @param temperature air temperature, 213.15 to 333.15 K (-60 to 60 degrees Celsius)
 * @param humidity relative humidity, 0 to 1
 * @param pressure air pressure, 50,000 to 120,000 Pa
 * @param temperatureGradient change of temperature with height, -1 to 1 K/m: about -0.01 in a windy or cloudy
 *     atmosphere, 0.05 or more near the ground on a clear night, -0.1 or less in sunshine
 * @param wind the wind
 */
public record Atmosphere(
        @In(value = Quantity.TEMPERATURE, from = 213.15, to = 333.15) double temperature,
        @In(value = Quantity.RATIO, from = 0, to = 1) double humidity,
        @In(value = Quantity.PRESSURE, from = 50_000, to = 120_000) double pressure,
        @In(value = Quantity.TEMPERATURE_GRADIENT, from = -1, to = 1) double temperatureGradient,
        Wind wind) {
    /**
     * 20 degrees Celsius, 70 % relative humidity, one standard atmosphere; no wind, and the same temperature at all
     * heights.
     */
    @Defaults
    public static final Atmosphere STANDARD = new Atmosphere(293.15, 0.7, 101_325.0);

    private static final double REFERENCE_TEMPERATURE = 293.15;
    private static final double TRIPLE_POINT = 273.16;
    private static final double REFERENCE_PRESSURE = 101_325.0;

    /** Gas constant of dry air, J/(kg K). */
    private static final double DRY_AIR = 287.05;

    /** One minus the ratio of the molar mass of water to that of dry air. */
    private static final double VAPOUR_IS_LIGHTER = 0.378;

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public Atmosphere {
        Limits.check(Atmosphere.class, temperature, humidity, pressure, temperatureGradient, wind);
    }

    /**
     * Air without wind, and with the same temperature at all heights.
     *
     * @param temperature air temperature, K
     * @param humidity relative humidity, 0 to 1
     * @param pressure air pressure, Pa
     * @throws IllegalArgumentException if a value is out of range
     */
    public Atmosphere(double temperature, double humidity, double pressure) {
        this(temperature, humidity, pressure, 0.0, Wind.CALM);
    }

    /** This air at another temperature, K. */
    public Atmosphere withTemperature(double kelvin) {
        return SettingsForm.with(this, "temperature", kelvin);
    }

    /** This air with another relative humidity, 0 to 1. */
    public Atmosphere withHumidity(double share) {
        return SettingsForm.with(this, "humidity", share);
    }

    /** This air at another pressure, Pa. */
    public Atmosphere withPressure(double pascal) {
        return SettingsForm.with(this, "pressure", pascal);
    }

    /** This air with another change of temperature with height, K/m. */
    public Atmosphere withTemperatureGradient(double kelvinPerMetre) {
        return SettingsForm.with(this, "temperatureGradient", kelvinPerMetre);
    }

    /** This air in wind. */
    public Atmosphere withWind(Wind other) {
        return SettingsForm.with(this, "wind", other);
    }

    /** Whether the paths of sound are straight, since there is neither wind nor a change of temperature with height. */
    public boolean isUniform() {
        return temperatureGradient == 0.0 && wind.speed() == 0.0;
    }

    /** This air without wind, and without a change of temperature with height. */
    public Atmosphere uniform() {
        return new Atmosphere(temperature, humidity, pressure);
    }

    /** Speed of sound, m/s: ISO 9613-1, equation (A.5). */
    public double speedOfSound() {
        return 343.2 * Math.sqrt(temperature / REFERENCE_TEMPERATURE);
    }

    /**
     * Characteristic impedance, Pa s/m: density times speed of sound, 413 at 20 degrees Celsius. The density is that of
     * humid air as an ideal gas, with the partial pressure of water vapour from ISO 9613-1, equations (B.1) to (B.3).
     */
    public double impedance() {
        double lighter = 1.0 - VAPOUR_IS_LIGHTER * 0.01 * vapour();
        return pressure * lighter / (DRY_AIR * temperature) * speedOfSound();
    }

    /** Molar concentration of water vapour, percent: ISO 9613-1, annex B. */
    private double vapour() {
        double saturation = Math.pow(10.0, -6.8346 * Math.pow(TRIPLE_POINT / temperature, 1.261) + 4.6151);
        return 100.0 * humidity * saturation / (pressure / REFERENCE_PRESSURE);
    }

    /**
     * Loss of a pure tone by absorption in the air: ISO 9613-1, equations (3) to (5), (B.1) to (B.3).
     *
     * @param frequency frequency, above 0, Hz
     * @return dB/m
     */
    public double attenuation(double frequency) {
        double relativePressure = pressure / REFERENCE_PRESSURE;
        double relativeTemperature = temperature / REFERENCE_TEMPERATURE;
        double vapour = vapour();
        double oxygen = relativePressure * (24.0 + 4.04e4 * vapour * (0.02 + vapour) / (0.391 + vapour));
        double nitrogen = relativePressure
                / Math.sqrt(relativeTemperature)
                * (9.0 + 280.0 * vapour * Math.exp(-4.170 * (Math.cbrt(1.0 / relativeTemperature) - 1.0)));
        double squared = frequency * frequency;
        double classical = 1.84e-11 * Math.sqrt(relativeTemperature) / relativePressure;
        double ofOxygen = 0.01275 * Math.exp(-2239.1 / temperature) / (oxygen + squared / oxygen);
        double ofNitrogen = 0.1068 * Math.exp(-3352.0 / temperature) / (nitrogen + squared / nitrogen);
        return 8.686 * squared * (classical + Math.pow(relativeTemperature, -2.5) * (ofOxygen + ofNitrogen));
    }

    /** Loss in each octave band at its exact midband frequency, dB/m. */
    public double[] attenuations() {
        double[] losses = new double[OctaveBands.COUNT];
        for (int band = 0; band < losses.length; band++) {
            losses[band] = attenuation(OctaveBands.midband(band));
        }
        return losses;
    }
}
