package org.dronewatch.route.proof;

import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.dronewatch.positioner.PositionerSettings;
import org.dronewatch.positioner.SearchPattern;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.SensorSettings;

/**
 * When a route begins. Nobody knows at which moment of a scan an attacker comes, and a drone covers some distance
 * between two looks. So the route begins at several moments, spread evenly over the longest period of any sensor: the
 * period of its looks or, on a positioner, that of its search. There is one moment in each of several equal parts of
 * the longest period. If slow sensors have different periods, the moments are shifted within these parts so that they
 * are spread as evenly as possible over each of the periods, even where one period is a multiple of another. There are
 * fewer moments if no sensor has a period of more than half a second.
 */
public final class RouteStarts {
    /** The maximum number of moments. */
    public static final int MOST = 8;

    /** The number of moments if no sensor is slow. */
    static final int FEW = 4;

    /** A sensor with a longer period is slow, s. */
    private static final double SLOW = 0.5;

    /** Between two looks this far apart or less, a drone hardly moves, s. */
    private static final double SHORT = 0.1;

    /** The number of ways that are tried to shift the moments within their intervals; the best one is taken. */
    private static final int WAYS = 64;

    private RouteStarts() {}

    /**
     * The moments, s since the start of the run, beginning with 0; only 0 if no sensor has a period longer than 0.1 s.
     */
    public static List<Double> of(Collection<SensorSettings<?>> sensors) {
        double longest = period(sensors);
        if (longest <= SHORT) {
            return List.of(0.0);
        }
        boolean isSlow = longest > SLOW;
        double[] periods = sensors.stream()
                .flatMapToDouble(RouteStarts::periods)
                .filter(period -> period > (isSlow ? SLOW : SHORT))
                .distinct()
                .toArray();
        return IntStream.range(0, WAYS)
                .mapToObj(way -> moments(longest, isSlow ? MOST : FEW, (double) way / WAYS))
                .min(Comparator.comparingDouble(moments -> Arrays.stream(periods)
                        .map(period -> unevenness(moments, period))
                        .max()
                        .orElseThrow()))
                .orElseThrow();
    }

    /** One moment in each part of a period, each moved on by a fraction of a part more than the one before. */
    private static List<Double> moments(double period, int count, double more) {
        return IntStream.range(0, count)
                .mapToObj(i -> (i + i * more % 1.0) * period / count)
                .toList();
    }

    /**
     * The greatest difference, for any part of a period, between its length relative to the period and the fraction of
     * the moments that fall in it (the discrepancy on the circle).
     */
    static double unevenness(List<Double> moments, double period) {
        double[] phases = moments.stream()
                .mapToDouble(moment -> moment / period % 1.0)
                .sorted()
                .toArray();
        double most = Double.NEGATIVE_INFINITY;
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < phases.length; i++) {
            double ahead = phases[i] - (double) i / phases.length;
            most = Math.max(most, ahead);
            least = Math.min(least, ahead);
        }
        return most - least + 1.0 / phases.length;
    }

    /** The longest period of any sensor, s; 0 without sensors. */
    public static double period(Collection<SensorSettings<?>> sensors) {
        return sensors.stream().mapToDouble(RouteStarts::period).max().orElse(0.0);
    }

    /** The name of the sensor with the longest period; empty if no sensor has a period longer than 0.1 s. */
    public static Optional<String> slowest(Map<String, SensorSettings<?>> sensors) {
        return sensors.entrySet().stream()
                .filter(sensor -> period(sensor.getValue()) > SHORT)
                .max(Comparator.comparingDouble(sensor -> period(sensor.getValue())))
                .map(Map.Entry::getKey);
    }

    private static double period(SensorSettings<?> sensor) {
        return periods(sensor).max().orElseThrow();
    }

    private static DoubleStream periods(SensorSettings<?> sensor) {
        double searching = Mounted.positioner(sensor)
                .map(PositionerSettings::search)
                .map(SearchPattern::period)
                .orElse(0.0);
        return DoubleStream.of(1.0 / sensor.rate(), searching);
    }
}
