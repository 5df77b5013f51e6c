package org.dronewatch.fusion;

import java.util.List;
import java.util.Optional;
import org.dronewatch.fusion.FalseAlertRate.Confirmed;
import org.dronewatch.sensor.alarm.AzimuthSpan;

/**
 * The rate at which confirmed false alarms of several sensors coincide by chance: at which one is confirmed while the
 * number of other sensors with a false alarm that still counts, and agrees in bearing, is one less than the rule
 * requires. A false alarm counts for as long as it stays confirmed, and for the rule's time after that. For two sensors
 * with a and b confirmed false alarms per second, each of which counts for the time T, this is the rate of accidental
 * coincidences, {@code 2 a b T}; it is lower where false alarms are so frequent that one of them meets several.
 */
final class Coincidences {
    /** Number of looks over which the number of another sensor's looks within a given time is averaged. */
    private static final int LOOKS = 1000;

    /** The number of bearings over which the mean is taken. */
    private static final int BEARINGS = 180;

    /** Tolerance within which looks count as taken at the same time. */
    private static final double ROUNDING = 1e-9;

    private final AlertRule.SeveralSensors rule;
    private final List<Confirmed> sensors;

    Coincidences(AlertRule.SeveralSensors rule, List<Confirmed> sensors) {
        this.rule = rule;
        this.sensors = sensors;
    }

    double perSecond() {
        double sum = 0.0;
        for (int last = 0; last < sensors.size(); last++) {
            sum += sensors.get(last).perSecond() * enoughOthers(last);
        }
        return sum;
    }

    /**
     * The probability that a false alarm of a sensor completes the number of sensors that the rule requires, averaged
     * over its bearing.
     */
    private double enoughOthers(int last) {
        if (rule.count() == 1) {
            return 1.0;
        }
        Optional<AzimuthSpan> bearings = sensors.get(last).bearings();
        double[] counting = new double[sensors.size()];
        for (int i = 0; i < counting.length; i++) {
            counting[i] = i == last ? 0.0 : counting(last, i);
        }
        int steps = bearings.isPresent() ? BEARINGS : 1;
        double sum = 0.0;
        for (int step = 0; step < steps; step++) {
            double fraction = (step + 0.5) / steps;
            sum += exactly(rule.count() - 1, last, counting, bearings.map(span -> span.at(fraction)));
        }
        return sum / steps;
    }

    /** Expected number of a sensor's false alarms that count at a look of another sensor. */
    private double counting(int last, int other) {
        Confirmed sensor = sensors.get(other);
        // Of two false alarms that are confirmed at the same time, only one is the last.
        boolean isWithPresent = other < last;
        double looks = looksWithin(
                rule.within() + sensor.duration(), sensors.get(last).lookRate(), sensor.lookRate(), isWithPresent);
        return sensor.perSecond() / sensor.lookRate() * looks;
    }

    /** The mean number of looks of a sensor in a number of seconds before a look of another. */
    private static double looksWithin(double seconds, double rate, double otherRate, boolean isWithPresent) {
        double sum = 0.0;
        double start = Math.ceil((seconds + 1.0) * rate);
        for (int i = 0; i < LOOKS; i++) {
            double now = (start + i) / rate * otherRate;
            double latest = isWithPresent ? Math.floor(now + ROUNDING) : Math.ceil(now - ROUNDING) - 1.0;
            sum += Math.max(0.0, latest - Math.ceil(now - seconds * otherRate - ROUNDING) + 1.0);
        }
        return sum / LOOKS;
    }

    /**
     * The probability that exactly a given number of the other sensors have a false alarm that counts and agrees in
     * bearing.
     */
    private double exactly(int number, int last, double[] counting, Optional<Double> bearing) {
        double[] chances = new double[number + 1];
        chances[0] = 1.0;
        for (int i = 0; i < counting.length; i++) {
            if (i != last) {
                Optional<AzimuthSpan> span = sensors.get(i).bearings();
                double agree = bearing.isPresent() && span.isPresent()
                        ? span.get().probabilityWithin(rule.gate(), bearing.get())
                        : 1.0;
                double one = -Math.expm1(-counting[i] * agree);
                for (int k = number; k >= 0; k--) {
                    chances[k] = chances[k] * (1.0 - one) + (k > 0 ? chances[k - 1] * one : 0.0);
                }
            }
        }
        return chances[number];
    }
}
