package org.dronewatch.mesh.io;

/** What kind of object a model is on the site. */
public enum ModelRole {
    /** The ground: hills, dams, pits. */
    TERRAIN,
    /** What was built: houses, walls, masts. */
    BUILDING,
    /** What grows: trees, hedges. */
    VEGETATION,
    /** Anything else, such as parked vehicles. */
    OTHER
}
