package org.dronewatch.route;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import org.dronewatch.analysis.field.InboundTarget;
import org.dronewatch.route.search.WeakestRoute;
import org.dronewatch.run.Stage;

/**
 * The weakest routes past any layout of sensors. Each sensor has been assessed by itself, since the detection rates of
 * independent sensors add. Routes lead to the protected zone, like those of {@link SiteRoutes}. Not thread-safe.
 */
public final class LayoutRoutes {
    private final RouteSite site;
    private final Map<String, SiteExposure> exposures = new LinkedHashMap<>();

    /**
     * The routes of a site.
     *
     * @param sensors the sensors, at least one, with distinct names
     * @param stage stage of the sensors' scene, which has a protected zone; the response time is that of the scene's
     *     alerts
     * @param drone name of the drone
     * @throws IllegalArgumentException if there is no sensor, or the drone cannot be anywhere on the edge of the
     *     field's known ground, or anywhere in the zone or next to it
     */
    public LayoutRoutes(Collection<SensorFields> sensors, Stage stage, String drone) {
        SensorFields first = sensors.stream()
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("0 sensors: there must be at least one"));
        this.site = RouteSite.of(
                first.modes(),
                first.settings(),
                stage,
                drone,
                Optional.empty(),
                InboundTarget.of(first.settings(), stage.protection()));
        sensors.forEach(sensor -> exposures.put(sensor.name(), SiteExposure.of(sensor.modes(), sensor.settings())));
    }

    /**
     * Searches for the weakest routes past some of the sensors.
     *
     * @param names names of these sensors, in the order of the layout; empty if the drone meets no sensor at all
     * @throws CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public SiteRoutes past(List<String> names) {
        SiteExposure any = exposures.values().iterator().next();
        return site.past(any.toAll(names.stream().map(exposures::get).toList()), names);
    }

    /**
     * The exposure to a sensor, whether it is in the layout or not, along the part of a route on which a detection
     * still leaves enough time for the response.
     *
     * @param routes the routes to which the given route belongs
     * @param sensor name of the sensor
     */
    public double exposure(SiteRoutes routes, WeakestRoute route, String sensor) {
        return routes.counted(route, exposures.get(sensor));
    }
}
