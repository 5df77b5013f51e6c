package org.dronewatch.bvh;

/** A method by which rays find triangles. All methods find the same hits, and differ in speed only. */
public enum RayTraversal {
    /** The fastest method for each use: tiles for images, a BVH for incoherent rays, a stack for single ones. */
    FASTEST,
    /** One ray at a time through the kd-tree, from cell to cell with a stack. */
    STACK,
    /** One ray at a time through the kd-tree, from cell to cell by a new descent from the root. */
    SEQUENTIAL
}
