package org.dronewatch.placement.plan;

/** The quantity that a placement maximises. */
public enum PlaceObjective {
    /** The fraction of the airspace that at least one sensor, or as many as the conditions require, covers. */
    COVERAGE,
    /** The time from the first detection of a drone that flies straight in to its arrival at the protected zone. */
    WARNING_TIME,
    /** The exposure on the least exposed route from the edge of the airspace to the protected zone. */
    WEAKEST_ROUTE
}
