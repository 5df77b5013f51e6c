package org.dronewatch.route;

import org.dronewatch.geometry.Position;

/**
 * A point of a route as it is flown.
 *
 * @param time time since the start of the route, s
 * @param distance distance along the path from the start of the route, m
 * @param position position of the point, m
 * @param above height of the point above the ground, m
 * @param mode number of the mode in which the drone flies on from here; at the end of the route, of the mode in which
 *     it arrives
 * @param exposure exposure along the route up to this point
 * @param isCorner whether the route begins, turns or ends here
 */
public record RoutePoint(
        double time, double distance, Position position, double above, int mode, double exposure, boolean isCorner) {
    /** A point on the straight line to another one, in this mode. */
    RoutePoint towards(RoutePoint next, double share) {
        return new RoutePoint(
                time + share * (next.time - time),
                distance + share * (next.distance - distance),
                position.plus(next.position.minus(position).times(share)),
                above + share * (next.above - above),
                mode,
                exposure + share * (next.exposure - exposure),
                isCorner && share == 0.0);
    }

    /** This point with another exposure so far. */
    RoutePoint withExposure(double other) {
        return new RoutePoint(time, distance, position, above, mode, other, isCorner);
    }
}
