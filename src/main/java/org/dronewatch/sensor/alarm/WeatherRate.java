package org.dronewatch.sensor.alarm;

import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.world.Weather;

/**
 * A rate of false alarms that applies if the weather and light of the site meet all of its conditions. A condition that
 * is left out is always met.
 *
 * @param perHour number of false alarms that begin per hour in the whole field of view, 0 to 1e7
 * @param rain minimum rain rate at which it applies, 0 to 500 mm/h
 * @param wind minimum wind speed, at a height of 10 m, at which it applies, 0 to 60 m/s
 * @param visibility maximum visibility at which it applies, above 0 and at most 1,000,000 m
 * @param illuminance maximum illuminance of the ground at which it applies, 1e-5 to 200,000 lx
 */
public record WeatherRate(
        @In(value = Quantity.NUMBER, from = 0, to = 1e7) double perHour,
        @In(value = Quantity.PRECIPITATION, from = 0, to = 500) double rain,
        @In(value = Quantity.SPEED, from = 0, to = 60) double wind,
        @In(value = Quantity.LENGTH, above = 0, to = 1e6) double visibility,
        @In(value = Quantity.ILLUMINANCE, from = 1e-5, to = 200_000) double illuminance) {
    /** Checks the limits. */
    public WeatherRate {
        Limits.check(WeatherRate.class, perHour, rain, wind, visibility, illuminance);
    }

    /** A rate that applies in any weather. */
    @Defaults("perHour")
    public static WeatherRate of(double perHour) {
        return new WeatherRate(perHour, 0.0, 0.0, 1e6, 200_000.0);
    }

    /** This rate in rain only, at and above a rain rate, mm/h. */
    public WeatherRate withRain(double millimetresPerHour) {
        return SettingsForm.with(this, "rain", millimetresPerHour);
    }

    /** This rate in wind only, at and above a speed, m/s. */
    public WeatherRate withWind(double metresPerSecond) {
        return SettingsForm.with(this, "wind", metresPerSecond);
    }

    /** This rate in haze only, up to a visibility, m. */
    public WeatherRate withVisibility(double metres) {
        return SettingsForm.with(this, "visibility", metres);
    }

    /** This rate in the dark only, up to an illuminance, lx. */
    public WeatherRate withIlluminance(double lux) {
        return SettingsForm.with(this, "illuminance", lux);
    }

    /** Whether this rate applies in any weather that a site can have. */
    boolean isUnconditional() {
        return appliesWhenever(of(perHour));
    }

    /** Whether all weather in which another rate applies meets the conditions of this one. */
    boolean appliesWhenever(WeatherRate other) {
        return rain <= other.rain
                && wind <= other.wind
                && visibility >= other.visibility
                && illuminance >= other.illuminance;
    }

    /** Whether this rate applies in given weather. */
    public boolean appliesIn(Weather weather) {
        return weather.rain() >= rain
                && weather.wind() >= wind
                && weather.visibility() <= visibility
                && weather.illuminance() <= illuminance;
    }
}
