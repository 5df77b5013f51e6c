package org.dronewatch.route;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.route.search.WeakestRoute;

/**
 * The weakest route from a sector, and how exposed a drone on it is to the sensors: as estimated by the search or, once
 * every look along the route has been assessed, as flown.
 *
 * @param sector number of the sector, clockwise from 0 for the north
 * @param route the route, with bounds on its exposure while a detection still counts ({@link #counted})
 * @param searched profile of the whole route, with the exposure in the cells of the search
 * @param bySensor exposure to each sensor along the whole route, in the cells of the search, in the order of the scene
 * @param causes what keeps the sensors from detecting the drone, according to the search
 * @param flown exposure to all looks along the route; empty if these looks have not been assessed
 */
public record SectorRoute(
        int sector,
        WeakestRoute route,
        RouteProfile searched,
        Map<String, Double> bySensor,
        RouteCauses causes,
        Optional<FlownExposure> flown) {
    /**
     * The search has misjudged a route if the probability of detection that it expected differs by more than this from
     * that of the route as flown.
     */
    public static final double MISJUDGED = 0.2;

    /** Probabilities below this count as 0, as in tables. */
    private static final double RARELY = 1e-3;

    /** Copies the map. */
    public SectorRoute {
        bySensor = Collections.unmodifiableMap(new LinkedHashMap<>(bySensor));
    }

    /** This route after every look along it has been assessed. */
    public SectorRoute with(FlownExposure exposure) {
        return new SectorRoute(sector, route, searched, bySensor, causes, Optional.of(exposure));
    }

    /**
     * The profile of the whole route, for pictures only: once the looks along it have been assessed, the mean number of
     * looks that detect the drone takes the place of the exposure, and {@link RouteProfile#detection} does not apply.
     */
    public RouteProfile profile() {
        return flown.map(searched::with).orElse(searched);
    }

    /** The probability that the drone is detected on the route, in time or not, 0 to 1. */
    public double detection() {
        return flown.map(looks -> looks.detection(Double.POSITIVE_INFINITY)).orElse(searched.detection());
    }

    /**
     * The probability that the drone is detected early enough for a response, 0 to 1.
     *
     * @param response time that the response takes, s; 0 if none is required
     */
    public double inTime(double response) {
        return flown.map(looks -> looks.detection(counted(response))).orElse(route.detection());
    }

    /**
     * The probability that an alert comes early enough for a response, by the scene's rule, where the times of the
     * flight and of the response vary, 0 to 1; empty if it is not known.
     */
    public OptionalDouble alertInTime() {
        return flown.map(FlownExposure::alertInTime).orElse(OptionalDouble.empty());
    }

    /**
     * Whether the drone is detected, early enough for a response, with a probability that is more than 20 percentage
     * points higher than the search expected.
     *
     * @param response time that the response takes, s; 0 if none is required
     */
    public boolean isUnderestimated(double response) {
        return inTime(response) - route.detection() > MISJUDGED;
    }

    /**
     * Whether the drone is detected, in time or not, with a probability that is more than 20 percentage points higher
     * than the search expected.
     */
    public boolean isUnderestimatedThroughout() {
        return detection() - searched.detection() > MISJUDGED;
    }

    /**
     * Whether the drone may be detected on the route, but too late for a response.
     *
     * @param response time that the response takes, s; 0 if none is required
     */
    public boolean isDetectedTooLate(double response) {
        return detection() - inTime(response) > RARELY;
    }

    /**
     * Whether the sector may have a route on which the drone is much less likely to be detected: the lower bound on the
     * exposure is so low that the probability of a timely detection could be more than 20 percentage points below that
     * of this route as flown.
     *
     * @param response time that the response takes, s; 0 if none is required
     */
    public boolean isUnproven(double response) {
        return inTime(response) + Math.expm1(-route.lower()) > MISJUDGED;
    }

    /**
     * The last moment at which a detection counts, s since the start: infinite if no response is required.
     *
     * @param response time that the response takes, s; 0 if none is required
     */
    public double counted(double response) {
        return response > 0.0 ? critical(response) : Double.POSITIVE_INFINITY;
    }

    /** The probability that the drone is detected up to and including a time, s since the start; 0 to 1. */
    public double detectionUntil(double time) {
        return flown.map(looks -> looks.detection(time)).orElseGet(() -> -Math.expm1(-searched.exposureUntil(time)));
    }

    /** The exposure to each sensor along the whole route: as flown if that is known, otherwise as searched. */
    public Map<String, Double> sensors() {
        return flown.map(FlownExposure::bySensor).orElse(bySensor);
    }

    /** The bearing of the centre of the sector, clockwise from north, rad. */
    public double bearing() {
        return bearing(sector);
    }

    /** The bearing of the centre of any sector, given by its number, clockwise from north, rad. */
    public static double bearing(int sector) {
        return 2.0 * Math.PI * sector / SiteRoutes.SECTORS;
    }

    /** The points at which the route begins, turns and ends. */
    public List<RoutePoint> corners() {
        List<RoutePoint> corners =
                searched.points().stream().filter(RoutePoint::isCorner).toList();
        // The flight has no leg that is shorter than a leg can be, and neither has this list.
        return IntStream.range(0, corners.size())
                .filter(i -> i == corners.size() - 1
                        || corners.get(i).position().distance(corners.get(i + 1).position())
                                >= FlightPathSettings.SHORTEST)
                .mapToObj(corners::get)
                .toList();
    }

    /**
     * The last moment at which a detection still leaves enough time for the response, s since the start; negative if
     * the response, given in s, takes longer than the flight, so that no detection is in time.
     */
    public double critical(double response) {
        return searched.end().time() - response;
    }

    /**
     * The time from the median time of the first detection to the arrival, s; empty if the drone cannot be detected.
     */
    public OptionalDouble left() {
        OptionalDouble detected = flown.map(FlownExposure::medianDetection).orElseGet(searched::medianDetection);
        return detected.isPresent()
                ? OptionalDouble.of(searched.end().time() - detected.getAsDouble())
                : OptionalDouble.empty();
    }

    /** The sensor to which the drone is most exposed; empty if it is not exposed to any. */
    public Optional<String> mostExposedTo() {
        return sensors().entrySet().stream()
                .filter(one -> one.getValue() > 0.0)
                .reduce((a, b) -> b.getValue() > a.getValue() ? b : a)
                .map(Map.Entry::getKey);
    }

    /** The fraction of the exposure that is due to a sensor, 0 to 1. */
    public double share(String sensor) {
        double all =
                sensors().values().stream().mapToDouble(Double::doubleValue).sum();
        return all > 0.0 ? sensors().get(sensor) / all : 0.0;
    }
}
