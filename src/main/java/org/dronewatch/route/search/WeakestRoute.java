package org.dronewatch.route.search;

/**
 * The least exposed route that was found, with a bracket of the exposure of the least exposed route that there is.
 *
 * @param path the route, m
 * @param exposure along it, as far as it counts: the upper end of the bracket
 * @param lower a certified lower bound of the exposure of all routes from the same starts
 * @param seconds how long the route takes, s
 */
public record WeakestRoute(RoutePath path, double exposure, double lower, double seconds) {
    /** The probability that a drone on this route is detected at least once where it counts, 0 to 1. */
    public double detection() {
        return -Math.expm1(-exposure);
    }
}
