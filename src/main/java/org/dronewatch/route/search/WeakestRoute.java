package org.dronewatch.route.search;

/**
 * The least exposed route that was found, with an interval that contains the exposure along the least exposed route
 * that exists.
 *
 * @param path path of the route
 * @param exposure exposure along the part of the route on which a detection counts: the upper end of the interval
 * @param lower a certified lower bound on the exposure along all routes from the same starts: the lower end of the
 *     interval
 * @param seconds how long the route takes, s
 */
public record WeakestRoute(RoutePath path, double exposure, double lower, double seconds) {
    /** The probability that a drone on this route is detected at least once where a detection counts, 0 to 1. */
    public double detection() {
        return -Math.expm1(-exposure);
    }
}
