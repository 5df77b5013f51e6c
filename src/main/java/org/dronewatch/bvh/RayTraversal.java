package org.dronewatch.bvh;

/** How rays find triangles. All find the same hits, and differ in speed only. */
public enum RayTraversal {
    /** What is fastest for each use: tiles for pictures, a BVH for incoherent rays, a stack for single ones. */
    FASTEST,
    /** One ray at a time through the kd-tree, from cell to cell by a stack. */
    STACK,
    /** One ray at a time through the kd-tree, from cell to cell by a new descent from the root. */
    SEQUENTIAL
}
