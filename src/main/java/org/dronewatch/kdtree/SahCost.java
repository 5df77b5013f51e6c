package org.dronewatch.kdtree;

import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * The surface area heuristic: the expected cost of a ray through a node, in any unit of work; only the ratio of the two
 * costs matters. The heuristic is that of equations 1 to 5 of Wald and Havran, "On building fast kd-trees for ray
 * tracing, and on doing that in O(N log N)" (2006), where the two costs are called KT and KI.
 *
 * @param traversal cost of one traversal step, 0.001 to 1000
 * @param intersection cost of one triangle test, 0.001 to 1000
 */
public record SahCost(
        @In(value = Quantity.NUMBER, from = SahCost.LEAST, to = SahCost.MOST) double traversal,
        @In(value = Quantity.NUMBER, from = SahCost.LEAST, to = SahCost.MOST) double intersection) {
    /** The least value of either cost. */
    public static final double LEAST = 0.001;
    /** The greatest value of either cost. */
    public static final double MOST = 1000.0;

    /**
     * A traversal cost of 4 and an intersection cost of 1.5: measured, not derived from operation counts. A step waits
     * for its node and for an unpredictable branch, while a triangle test is plain arithmetic; and the tiles of cameras
     * test a triangle once for many pixels. With a traversal cost of 3, single rays are up to 10 % faster, tiles slower
     * by as much, and trees take 25 % longer to build; 6 has the opposite effects.
     */
    public static final SahCost DEFAULT = new SahCost(4.0, 1.5);

    /** Factor on the cost of a split that cuts off empty space. */
    static final double EMPTY_BONUS = 0.8;

    /** Checks the limits. */
    public SahCost {
        Limits.check(SahCost.class, traversal, intersection);
    }

    /** The default costs. */
    @Defaults
    public static SahCost standard() {
        return DEFAULT;
    }

    /**
     * Cost of splitting a node.
     *
     * @param leftShare surface of the left part over that of the whole: the probability that a ray through the whole
     *     meets it
     * @param rightShare the same for the right part
     * @param left number of triangles in the left part
     * @param right number of triangles in the right part
     */
    double split(double leftShare, double rightShare, int left, int right) {
        double cost = traversal + intersection * (leftShare * left + rightShare * right);
        return left == 0 || right == 0 ? EMPTY_BONUS * cost : cost;
    }

    /** Cost of a leaf of a number of triangles. */
    double leaf(int triangles) {
        return intersection * triangles;
    }
}
