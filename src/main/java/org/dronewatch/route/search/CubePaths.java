package org.dronewatch.route.search;

/**
 * The simplices into which Kuhn's triangulation cuts a cube, or a square: one for each order of the axes, with the
 * corners that one passes when walking along the axes in this order. On a linear function, the components of the
 * gradient are the differences of successive corners, each divided by the edge between them.
 */
final class CubePaths {
    /** Orders of the axes in the plane. */
    private static final int[][] PLANE = {{0, 1}, {1, 0}};

    /** Orders of the axes in space. */
    private static final int[][] SPACE = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};

    private CubePaths() {}

    /** The orders of the axes for a number of dimensions, 2 or 3. */
    static int[][] orders(int dimensions) {
        return dimensions == 2 ? PLANE : SPACE;
    }
}
