package org.dronewatch.fusion;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.alarm.AzimuthSpan;
import org.dronewatch.sensor.alarm.FalseAlarmRate;
import org.dronewatch.sensor.alarm.FalseAlarming;
import org.dronewatch.world.Weather;

/**
 * False alerts per day that result from a rule, in closed form.
 *
 * <p>Assumptions: false alarms begin independently of each other, from look to look, from cell to cell, and from sensor
 * to sensor. Those of one sensor confirm each other only if they lie in the same cell. Those of several sensors count
 * together if they agree in time and in bearing, whatever their range, their elevation, and the distance between the
 * sensors; a sensor without a bearing, or on a positioner, agrees with all. One alert is counted for each contact,
 * however long it lasts.
 *
 * <p>Let s be the probability that a false alarm begins in a given cell of the sensor's field of view in a given look,
 * K the number of these cells, f the looks per second, and let the confirmation require detections in M of N looks.
 * False alarms that last for one look are confirmed {@code K f C(N-1, M-1) s^M (1-s)^(N-M+1)} times a second (C is the
 * binomial coefficient): the rate of looks that confirm a false alarm which the look before did not confirm. If L is M
 * or more, those that last for L looks confirm themselves, {@code K f s (1-s)^(N+L-1)} times a second. If L is above
 * one but below M, J = M / L of them, rounded up, must begin in the same cell within N + L - 1 looks; an upper bound on
 * the rate is {@code K f s P(Poisson(s' (N+L-1)) >= J-1)} with s' = -ln(1-s).
 *
 * <p>Where false alarms are so frequent that they merge, the number of new ones that are confirmed would decrease as
 * they become more frequent, since the old ones never end. The rate is then taken at the formula's maximum: at
 * {@code s = M / (N+1)} for false alarms that last for one look, at {@code s = 1 / (N+L)} for those that confirm
 * themselves. Such a sensor reports false alarms more than half the time.
 *
 * @param perDay expected number of false alerts per day from the sensors whose rates are known
 * @param isUpperBound whether the number is an upper bound
 * @param known names of the sensors whose rates are known
 * @param unknown names of the sensors whose rates are not known
 * @param merging names of the sensors whose false alarms are so frequent that they merge
 */
public record FalseAlertRate(
        double perDay, boolean isUpperBound, List<String> known, List<String> unknown, List<String> merging) {
    /**
     * The maximum expected number of confirmed false alarms that a rule for several sensors may have to remember at the
     * same time.
     */
    public static final int MOST_AT_A_TIME = 200_000;

    private static final double DAY = 86_400.0;

    /** Copies the lists: later changes by the caller have no effect. */
    public FalseAlertRate {
        known = List.copyOf(known);
        unknown = List.copyOf(unknown);
        merging = List.copyOf(merging);
    }

    /** The rate that results from an alert rule and a scene's sensors in given weather. */
    public static FalseAlertRate of(AlertSettings alert, Map<String, SensorSettings<?>> sensors, Weather weather) {
        Map<String, Confirmed> known = new LinkedHashMap<>();
        List<String> unknown = new ArrayList<>();
        sensors.forEach((id, sensor) -> confirmed(alert.confirm(), sensor, weather)
                .ifPresentOrElse(confirmed -> known.put(id, confirmed), () -> unknown.add(id)));
        List<Confirmed> all = List.copyOf(known.values());
        boolean isBound = all.stream().anyMatch(Confirmed::isUpperBound);
        double perSecond;
        if (alert.rule() instanceof AlertRule.SeveralSensors several) {
            perSecond = new Coincidences(several, all).perSecond();
            isBound |= several.count() > 1;
        } else {
            perSecond = all.stream().mapToDouble(Confirmed::perSecond).sum();
        }
        List<String> merging =
                known.keySet().stream().filter(id -> known.get(id).isMerging()).toList();
        return new FalseAlertRate(DAY * perSecond, isBound, List.copyOf(known.keySet()), unknown, merging);
    }

    /**
     * Checks that a rule for several sensors does not have to remember more than {@link #MOST_AT_A_TIME} false alarms.
     *
     * @throws IllegalArgumentException if it does
     */
    public static void check(AlertSettings alert, Map<String, SensorSettings<?>> sensors, Weather weather) {
        if (alert.rule() instanceof AlertRule.SeveralSensors several) {
            double perSecond = sensors.values().stream()
                    .flatMap(sensor -> confirmed(alert.confirm(), sensor, weather).stream())
                    .mapToDouble(Confirmed::perSecond)
                    .sum();
            if (perSecond * several.within() > MOST_AT_A_TIME) {
                throw new IllegalArgumentException("alert.rule.within " + several.within() + " s with "
                        + brief(perSecond) + " confirmed false alarms a second gives "
                        + brief(perSecond * several.within()) + " that count at the same time; there must be at most "
                        + MOST_AT_A_TIME);
            }
        }
    }

    /** Whether no sensor's rate is known. */
    public boolean isUnknown() {
        return known.isEmpty();
    }

    /**
     * The rate in words: {@code 2.4 per day}; {@code at most 2.4 per day}; {@code 2.4 per day from a; unknown from b};
     * {@code unknown}; {@code 2000 per day; a raises false alarms most of the time}.
     */
    public String inWords() {
        if (isUnknown()) {
            return "unknown";
        }
        String number = (isUpperBound ? "at most " : "") + brief(perDay) + " per day";
        String from = unknown.isEmpty()
                ? number
                : number + " from " + String.join(", ", known) + "; unknown from " + String.join(", ", unknown);
        return merging.isEmpty()
                ? from
                : from + "; " + String.join(", ", merging) + (merging.size() == 1 ? " raises" : " raise")
                        + " false alarms most of the time";
    }

    /**
     * A number as text: to two decimal places below 10, one below 100, and none from 100; in exponential notation below
     * 0.01, except 0, and from 100,000.
     */
    public static String brief(double value) {
        if (value == 0.0 || value >= 0.01 && value < 1e5) {
            return String.format(Locale.ROOT, value >= 100.0 ? "%.0f" : value >= 10.0 ? "%.1f" : "%.2f", value);
        }
        return String.format(Locale.ROOT, "%.1e", value);
    }

    private static Optional<Confirmed> confirmed(Confirmation confirm, SensorSettings<?> sensor, Weather weather) {
        return sensor.as(FalseAlarming.class).flatMap(capability -> capability
                .falseAlarmRate(weather)
                .map(rate -> Confirmed.of(confirm, rate, capability.falseBearings())));
    }

    /**
     * The confirmed false alarms of one sensor.
     *
     * @param perSecond number of them per second
     * @param isUpperBound whether the number is an upper bound
     * @param duration time for which one of them stays confirmed, from the first to the last look, s
     * @param lookRate looks per second, Hz
     * @param bearings azimuths over which they are distributed, if these are known
     * @param isMerging whether they are so frequent that they merge
     */
    record Confirmed(
            double perSecond,
            boolean isUpperBound,
            double duration,
            double lookRate,
            Optional<AzimuthSpan> bearings,
            boolean isMerging) {
        /**
         * A Poisson variable with a mean greater than this is practically certain to reach any number for which the
         * probability is requested.
         */
        private static final double CERTAIN = 700.0;

        static Confirmed of(Confirmation confirm, FalseAlarmRate rate, Optional<AzimuthSpan> bearings) {
            double perLook = rate.cells() * rate.rate();
            int hits = confirm.hits();
            int looks = confirm.looks();
            int lasting = rate.looks();
            if (lasting == 1) {
                double most = hits / (looks + 1.0);
                double s = Math.min(most, rate.probability());
                double onset = confirm.onset(s);
                double confirmed = onset > 0.0 ? confirm.probability(s) / onset - 1.0 : 0.0;
                return new Confirmed(
                        perLook * onset,
                        false,
                        confirmed / rate.rate(),
                        rate.rate(),
                        bearings,
                        rate.probability() > most);
            }
            if (lasting >= hits) {
                double most = 1.0 / (looks + lasting);
                double s = Math.min(most, rate.probability());
                double alone = perLook * s * Math.pow(1.0 - s, looks + lasting - 1.0);
                double confirmed = lasting + looks - 2.0 * hits;
                return new Confirmed(
                        alone, false, confirmed / rate.rate(), rate.rate(), bearings, rate.probability() > most);
            }
            double s = rate.probability();
            int needed = (hits + lasting - 1) / lasting;
            double others = rate.perCell() * (looks + lasting - 1.0);
            return new Confirmed(
                    perLook * s * atLeast(needed - 1, others),
                    true,
                    (looks + lasting - 1.0) / rate.rate(),
                    rate.rate(),
                    bearings,
                    false);
        }

        /** The probability that a Poisson variable reaches a number. */
        private static double atLeast(int number, double mean) {
            if (mean > CERTAIN) {
                return 1.0;
            }
            double term = Math.exp(-mean);
            for (int k = 1; k <= number; k++) {
                term *= mean / k;
            }
            double sum = 0.0;
            for (int k = number; k < number + 1000 && term > 1e-18 * sum; k++) {
                sum += term;
                term *= mean / (k + 1);
            }
            return Math.min(1.0, sum);
        }
    }
}
