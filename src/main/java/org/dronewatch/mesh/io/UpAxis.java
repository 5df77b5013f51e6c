package org.dronewatch.mesh.io;

/** Which axis of a model file points up. The world's own frame has z up, x east and y north. */
public enum UpAxis {
    /** The file has y up: its x becomes east, its -z north. */
    Y,
    /** The file has z up, as the world. */
    Z
}
