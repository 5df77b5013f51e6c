package org.dronewatch.placement.route;

import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.search.WeakestRoute;

/**
 * The weakest route from one direction.
 *
 * @param sector from which it comes, by its number, from 0 for the north clockwise
 * @param route that is least exposed
 */
record DirectedRoute(int sector, WeakestRoute route) {
    double exposure() {
        return route.exposure();
    }

    /** The bearing of the middle of the sector, clockwise from north, rad. */
    double bearing() {
        return SectorRoute.bearing(sector);
    }
}
