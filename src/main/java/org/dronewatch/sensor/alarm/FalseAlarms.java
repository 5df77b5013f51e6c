package org.dronewatch.sensor.alarm;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Minor;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.world.Weather;

/**
 * The rate at which a sensor mistakes other things for drones, as stated by its manufacturer or counted in a trial.
 *
 * @param perHour number of false alarms that begin per hour in the whole field of view, 0 to 1e7
 * @param cells number of cells of the field of view that the sensor distinguishes, 1 to 1e9: only false alarms in the
 *     same cell confirm each other; with 1, the most cautious value, all false alarms confirm each other
 * @param duration duration of a false alarm, 0 to 600 s; 0 for one look, as for noise. A false alarm that lasts is
 *     confirmed like a drone
 * @param weather rates for particular weather or light: the highest rate whose conditions the site meets replaces
 *     {@code perHour}; unless set, the rate is the same in all weather
 */
public record FalseAlarms(
        @In(value = Quantity.NUMBER, from = 0, to = 1e7) double perHour,
        @In(value = Quantity.NUMBER, from = 1, to = 1e9) int cells,
        @In(value = Quantity.DURATION, from = 0, to = 600) double duration,
        @Minor List<WeatherRate> weather) {
    private static final double HOUR = 3600.0;

    /** Rounding must not make a whole number of looks one look longer. */
    private static final double ROUNDING = 1e-9;

    /** Checks the limits. */
    public FalseAlarms {
        Limits.check(FalseAlarms.class, perHour, cells, duration, weather);
        weather = List.copyOf(weather);
    }

    /** False alarms with the same rate in all weather. */
    public FalseAlarms(double perHour, int cells, double duration) {
        this(perHour, cells, duration, List.of());
    }

    /**
     * A number of false alarms per hour, all in one cell, so that they confirm each other. Each lasts for 5 seconds.
     * This duration is assumed, because most false alarms are caused by something that is present for a while, such as
     * a bird, an aircraft, a lorry, or another transmitter.
     */
    @Defaults("perHour")
    public static FalseAlarms of(double perHour) {
        return new FalseAlarms(perHour, 1, 5.0);
    }

    /** These false alarms with another number of cells. */
    public FalseAlarms withCells(int number) {
        return SettingsForm.with(this, "cells", number);
    }

    /** These false alarms with another duration, s. */
    public FalseAlarms withDuration(double seconds) {
        return SettingsForm.with(this, "duration", seconds);
    }

    /** These false alarms with other rates for some kinds of weather. */
    public FalseAlarms withWeather(List<WeatherRate> rates) {
        return SettingsForm.with(this, "weather", rates);
    }

    /** These false alarms in given weather: with the highest of the rates that apply in it, and no others. */
    public FalseAlarms in(Weather given) {
        double applies = weather.stream()
                .filter(one -> one.appliesIn(given))
                .mapToDouble(WeatherRate::perHour)
                .max()
                .orElse(perHour);
        return new FalseAlarms(applies, cells, duration);
    }

    /** One sentence for each entry of {@code weather} that always applies, or that never makes a difference. */
    public List<String> advice() {
        List<String> lines = new ArrayList<>();
        for (int i = 0; i < weather.size(); i++) {
            String entry = "falseAlarms.weather." + i;
            OptionalInt stronger = stronger(i);
            if (stronger.isPresent()) {
                lines.add(entry + " makes no difference: whenever it applies, so does weather." + stronger.getAsInt()
                        + ", whose rate is at least as high");
            } else if (weather.get(i).isUnconditional()) {
                lines.add(entry + " has no conditions, so it always applies and perHour never does: set rain,"
                        + " wind, visibility or illuminance");
            }
        }
        return lines;
    }

    /**
     * The first other entry that applies whenever the given one does, with a rate that is at least as high; of two
     * equal entries, only the first makes the other superfluous.
     */
    private OptionalInt stronger(int index) {
        WeatherRate one = weather.get(index);
        return IntStream.range(0, weather.size())
                .filter(i -> i != index && weather.get(i).appliesWhenever(one))
                .filter(i -> weather.get(i).perHour() > one.perHour()
                        || weather.get(i).perHour() == one.perHour()
                                && (i < index || !one.appliesWhenever(weather.get(i))))
                .findFirst();
    }

    /**
     * The rate of these false alarms for a sensor's looks, in weather for which no other rate is stated.
     *
     * @param lookRate looks per second, above 0, Hz
     * @throws IllegalArgumentException when more than {@link FalseAlarmRate#MOST_PER_LOOK} are expected in a look, in
     *     any weather
     */
    public FalseAlarmRate rate(double lookRate) {
        weather.forEach(one -> new FalseAlarms(one.perHour(), cells, duration).rate(lookRate));
        int looks = (int) Math.max(1.0, Math.ceil(duration * lookRate - ROUNDING));
        return new FalseAlarmRate(perHour / (HOUR * lookRate), cells, looks, lookRate);
    }
}
