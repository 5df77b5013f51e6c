package org.dronewatch.placement.route;

import java.util.Optional;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.search.WeakestRoute;

/**
 * The weakest route from one direction, in the scene as it is or under one of the conditions of a plan.
 *
 * @param sector number of the sector from which the route comes, clockwise from 0 for the north
 * @param condition name of the condition; empty for the scene as it is
 * @param route the least exposed route
 */
public record DirectedRoute(int sector, Optional<String> condition, WeakestRoute route) {
    /** This route past other sensors, with the exposure to them and its lower bound for all routes past them. */
    DirectedRoute exposed(double exposure, double lower) {
        return new DirectedRoute(sector, condition, new WeakestRoute(route.path(), exposure, lower, route.seconds()));
    }

    /** The exposure on the part of the route on which a detection counts. */
    public double exposure() {
        return route.exposure();
    }

    /** The bearing of the centre of the sector, clockwise from north, rad. */
    public double bearing() {
        return SectorRoute.bearing(sector);
    }
}
