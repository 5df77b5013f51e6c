package org.dronewatch.sensor.optics;

/** The background behind drones in an image. */
@FunctionalInterface
interface Background {
    /** No background: every drone is seen whole. */
    Background NOTHING = (column, row) -> Float.POSITIVE_INFINITY;

    /** The distance of the background along a pixel's ray, m; infinity if there is none. */
    float distance(int column, int row);
}
