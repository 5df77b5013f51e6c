package org.dronewatch.sensor.optics;

/** What is behind drones in an image. */
@FunctionalInterface
interface Background {
    /** Nothing: every drone is seen whole. */
    Background NOTHING = (column, row) -> Float.POSITIVE_INFINITY;

    /** Its distance along a pixel's ray, m; infinity for none. */
    float distance(int column, int row);
}
