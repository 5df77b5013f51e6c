package org.dronewatch.route.proof;

import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.dronewatch.positioner.PositionerSettings;
import org.dronewatch.positioner.SearchPattern;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.SensorSettings;

/**
 * When a route begins. Nobody knows at which moment of a scan an attacker comes, and a drone covers a long distance
 * between two looks of a slow sensor. So the route begins at several moments, spread evenly over the longest period of
 * any sensor: the period of its looks or, on a positioner, that of its search.
 */
public final class RouteBegins {
    /** The maximum number of moments. */
    public static final int MOST = 8;

    /** Between two looks this far apart or less, a drone hardly leaves a cell of the search, s. */
    private static final double SHORT = 0.5;

    private RouteBegins() {}

    /** The moments, s since the start of the run, beginning with 0; only 0 if all sensors look often. */
    public static List<Double> of(Collection<SensorSettings<?>> sensors) {
        double period = period(sensors);
        int count = period > SHORT ? MOST : 1;
        return IntStream.range(0, count).mapToObj(i -> i * period / count).toList();
    }

    /** The longest period of a sensor, s; 0 without sensors. */
    public static double period(Collection<SensorSettings<?>> sensors) {
        return sensors.stream().mapToDouble(RouteBegins::period).max().orElse(0.0);
    }

    /** The name of the sensor with the longest period; empty if all sensors look often. */
    public static Optional<String> slowest(Map<String, SensorSettings<?>> sensors) {
        return sensors.entrySet().stream()
                .filter(sensor -> period(sensor.getValue()) > SHORT)
                .max(Comparator.comparingDouble(sensor -> period(sensor.getValue())))
                .map(Map.Entry::getKey);
    }

    private static double period(SensorSettings<?> sensor) {
        double searching = Mounted.positioner(sensor)
                .map(PositionerSettings::search)
                .map(SearchPattern::period)
                .orElse(0.0);
        return Math.max(1.0 / sensor.rate(), searching);
    }
}
