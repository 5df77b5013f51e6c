package org.dronewatch.route;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.sensor.Cause;

/**
 * The weakest route from a sector, and what the sensors see of it.
 *
 * @param sector its number, from 0 for the north clockwise
 * @param route with the bracket of the exposure that counts
 * @param profile of the whole route
 * @param bySensor the exposure along the whole route to each sensor, in the order of the scene
 * @param causes for how long each cause is the dominant one along the route, s
 */
public record SectorRoute(
        int sector, WeakestRoute route, RouteProfile profile, Map<String, Double> bySensor, Map<Cause, Double> causes) {
    /** Copies the maps. */
    public SectorRoute {
        bySensor = Collections.unmodifiableMap(new LinkedHashMap<>(bySensor));
        causes = Collections.unmodifiableMap(new LinkedHashMap<>(causes));
    }

    /** The bearing of the middle of a sector, clockwise from north, rad. */
    public double bearing() {
        return 2.0 * Math.PI * sector / SiteRoutes.SECTORS;
    }

    /** Where it begins, turns and ends. */
    public List<RoutePoint> corners() {
        return profile.points().stream().filter(RoutePoint::isCorner).toList();
    }

    /** The last moment at which a detection leaves the time that a response takes, s since the start; 0 or more. */
    public double critical(double response) {
        return Math.max(0.0, profile.end().time() - response);
    }

    /** The time from the median first detection to the arrival, s; empty if the drone is not detected. */
    public OptionalDouble left() {
        OptionalDouble detected = profile.medianDetection();
        return detected.isPresent()
                ? OptionalDouble.of(profile.end().time() - detected.getAsDouble())
                : OptionalDouble.empty();
    }

    /** The sensor to which the drone is most exposed; empty if it is not exposed to any. */
    public Optional<String> mostExposedTo() {
        return bySensor.entrySet().stream()
                .filter(one -> one.getValue() > 0.0)
                .reduce((a, b) -> b.getValue() > a.getValue() ? b : a)
                .map(Map.Entry::getKey);
    }

    /** The fraction of the exposure that is that to a sensor, 0 to 1. */
    public double share(String sensor) {
        double all = bySensor.values().stream().mapToDouble(Double::doubleValue).sum();
        return all > 0.0 ? bySensor.get(sensor) / all : 0.0;
    }

    /** What keeps the sensors from detecting the drone for most of the time; empty if it is always detected. */
    public Optional<Cause> dominantCause() {
        return causes.entrySet().stream()
                .filter(one -> one.getKey() != Cause.DETECTED && one.getValue() > 0.0)
                .reduce((a, b) -> b.getValue() > a.getValue() ? b : a)
                .map(Map.Entry::getKey);
    }

    /** For which fraction of the flight a cause is the dominant one, 0 to 1. */
    public double share(Cause cause) {
        double all = causes.values().stream().mapToDouble(Double::doubleValue).sum();
        return all > 0.0 ? causes.getOrDefault(cause, 0.0) / all : 0.0;
    }
}
