package org.dronewatch.route;

import java.util.Collections;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.sensor.Cause;

/**
 * What keeps the sensors from detecting a drone along a route, according to the search.
 *
 * @param dominant the times of the dominant causes; at each moment, the dominant cause is that of the sensor that comes
 *     nearest to a detection
 * @param bySensor the times of each sensor's own causes, in the order of the scene
 */
public record RouteCauses(CauseTimes dominant, Map<String, CauseTimes> bySensor) {
    /** No causes, where nothing is known. */
    public static final RouteCauses NONE = new RouteCauses(new CauseTimes(Map.of()), Map.of());

    /** Copies the map. */
    public RouteCauses {
        bySensor = Collections.unmodifiableMap(new LinkedHashMap<>(bySensor));
    }

    /**
     * The causes along a route.
     *
     * @param sensors names of the sensors, in the order of the scene
     */
    static RouteCauses along(RouteProfile profile, List<String> sensors, SiteExposure exposure) {
        Map<Cause, Double> dominant = new EnumMap<>(Cause.class);
        Map<String, Map<Cause, Double>> bySensor = new LinkedHashMap<>();
        sensors.forEach(sensor -> bySensor.put(sensor, new EnumMap<>(Cause.class)));
        for (int i = 1; i < profile.points().size(); i++) {
            RoutePoint from = profile.points().get(i - 1);
            RoutePoint to = profile.points().get(i);
            double lasts = to.time() - from.time();
            List<SensorCause> causes = exposure.causes(from.position(), to.position(), from.mode());
            dominant.merge(SensorCause.dominant(causes), lasts, Double::sum);
            causes.forEach(one -> bySensor.get(one.sensor()).merge(one.cause(), lasts, Double::sum));
        }
        Map<String, CauseTimes> times = new LinkedHashMap<>();
        bySensor.forEach((sensor, its) -> times.put(sensor, new CauseTimes(its)));
        return new RouteCauses(new CauseTimes(dominant), times);
    }
}
