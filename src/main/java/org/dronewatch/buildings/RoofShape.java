package org.dronewatch.buildings;

/** The roof shapes that are modelled; all other roofs are flat, at the full height of the building. */
enum RoofShape {
    FLAT,
    /** Two slopes, one on either side of a ridge. */
    GABLED,
    /** Four slopes of the same pitch. */
    HIPPED,
    /** Slopes from each side to one point. */
    PYRAMIDAL,
    /** Round, rising to one point. */
    DOME,
    /** One slope. */
    SKILLION
}
