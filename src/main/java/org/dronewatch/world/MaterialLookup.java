package org.dronewatch.world;

/** Finds materials at points on triangles. */
@FunctionalInterface
public interface MaterialLookup {
    /**
     * The number of the material of a triangle at a point on it.
     *
     * @param x east, m
     * @param y north, m
     */
    int at(int triangle, double x, double y);
}
