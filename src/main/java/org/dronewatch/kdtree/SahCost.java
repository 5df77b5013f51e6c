package org.dronewatch.kdtree;

/**
 * The surface area heuristic: the expected cost of a ray through a node, relative to a unit of work. After Wald and
 * Havran, "On building fast kd-trees for ray tracing, and on doing that in O(N log N)" (2006), equations 1 to 5.
 */
final class SahCost {
    /**
     * Cost of one traversal step. Measured, not counted: a step waits for its node and for an unpredictable
     * branch, a triangle test is plain arithmetic; and tiles of cameras test a triangle once for many pixels. With 3
     * instead of 4 single rays are up to a tenth faster, tiles slower by as much, and trees take a quarter longer to
     * build; with 6 it is the reverse.
     */
    static final double TRAVERSAL = 4.0;
    /** Cost of one triangle test. */
    static final double INTERSECTION = 1.5;
    /** Factor on the cost of a split that cuts off empty space. */
    static final double EMPTY_BONUS = 0.8;

    private SahCost() {}

    /**
     * Cost of splitting a node.
     *
     * @param leftShare surface of the left part over that of the whole: the probability that a ray through the whole
     *     meets it
     * @param rightShare the same for the right part
     * @param left number of triangles in the left part
     * @param right number of triangles in the right part
     */
    static double split(double leftShare, double rightShare, int left, int right) {
        double cost = TRAVERSAL + INTERSECTION * (leftShare * left + rightShare * right);
        return left == 0 || right == 0 ? EMPTY_BONUS * cost : cost;
    }

    /** Cost of a leaf of a number of triangles. */
    static double leaf(int triangles) {
        return INTERSECTION * triangles;
    }
}
