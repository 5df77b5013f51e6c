package org.dronewatch.mesh.io;

/** The axis of a model file that points up. The world frame has z up, x east and y north. */
public enum UpAxis {
    /** The file has y up: its x points east, its -z north. */
    Y,
    /** The file has z up, like the world. */
    Z
}
