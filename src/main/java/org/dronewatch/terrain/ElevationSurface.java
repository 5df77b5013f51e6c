package org.dronewatch.terrain;

/** The surface that an elevation file describes. */
public enum ElevationSurface {
    /** Bare ground: a digital terrain model. */
    DTM,
    /** Roofs and treetops where there are any, as seen from above: a digital surface model. */
    DSM
}
