package org.dronewatch.terrain;

/** The surface that an elevation file describes. */
public enum ElevationSurface {
    /** Bare ground: a digital terrain model. */
    DTM,
    /** The highest surface, including roofs and treetops: a digital surface model. */
    DSM
}
