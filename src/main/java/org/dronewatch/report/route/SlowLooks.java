package org.dronewatch.report.route;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.proof.RouteStarts;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.PlainText;

/** Sensors that look so rarely that it matters at which moment a drone arrives. */
final class SlowLooks {
    private static final double HUNDREDTHS = 100.0;

    private final Map<String, SensorSettings<?>> sensors;

    /** The slow ones among these sensors, given by name in the order of the scene. */
    SlowLooks(Map<String, SensorSettings<?>> sensors) {
        this.sensors = sensors;
    }

    /** The one with the longest period; empty if all look often. */
    Optional<String> slowest() {
        return RouteStarts.slowest(sensors);
    }

    /** The time between two looks of a sensor in the same direction, {@code 5 s}. */
    String period(String sensor) {
        return Numbers.text(Math.rint(HUNDREDTHS * RouteStarts.period(List.of(sensors.get(sensor)))) / HUNDREDTHS)
                + " s";
    }

    /** What the search assumes of the slow sensor that matters most on these routes. */
    String assumption(List<SectorRoute> routes) {
        return disagreeing(routes)
                .map(sensor -> "assumes that '" + PlainText.value(sensor)
                        + "' may look at any moment, whereas it looks only every " + period(sensor))
                .orElse("assumes that a sensor may look at any moment");
    }

    /**
     * The slow sensor whose looks disagree most with the search: the one with the greatest sum, over these routes, of
     * the differences in the probability that it detects the drone. Sums that are equal to a whole percentage point, as
     * where only the times of detections differ, count as equal; of such sensors, the one to which the drone is most
     * exposed is chosen.
     */
    private Optional<String> disagreeing(List<SectorRoute> routes) {
        return sensors.keySet().stream()
                .filter(sensor ->
                        RouteStarts.slowest(Map.of(sensor, sensors.get(sensor))).isPresent())
                .filter(sensor -> exposure(sensor, routes) > 0.0)
                .max(Comparator.comparingDouble((String sensor) -> Math.rint(HUNDREDTHS * disagreement(sensor, routes)))
                        .thenComparingDouble(sensor -> exposure(sensor, routes)));
    }

    private static double disagreement(String sensor, List<SectorRoute> routes) {
        return routes.stream()
                .mapToDouble(route -> Math.abs(Math.exp(-route.sensors().getOrDefault(sensor, 0.0))
                        - Math.exp(-route.bySensor().getOrDefault(sensor, 0.0))))
                .sum();
    }

    private static double exposure(String sensor, List<SectorRoute> routes) {
        return routes.stream()
                .mapToDouble(route -> route.sensors().getOrDefault(sensor, 0.0))
                .sum();
    }
}
