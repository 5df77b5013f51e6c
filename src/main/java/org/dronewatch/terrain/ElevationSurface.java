package org.dronewatch.terrain;

/** What the heights of an elevation file are those of. */
public enum ElevationSurface {
    /** Bare ground: a digital terrain model. */
    DTM,
    /** Roofs and treetops where there are any, as seen from above: a digital surface model. */
    DSM
}
