package org.dronewatch.kdtree;

import java.util.Optional;

/**
 * The cheapest of the planes that have been tried in a cell, by the costs of {@link SahCost}. For use by one thread.
 */
final class CheapestSplit {
    private final SahCost costs;
    private int[] voxel = new int[SahSplitFinder.BOX];
    private double area;

    // The axis of the planes that come next: the cell's ends on it, and its section and half of its perimeter across
    // it.
    private int axis;
    private double lowest;
    private double highest;
    private double section;
    private double halfPerimeter;

    private double bestCost;
    private int bestAxis;
    private int bestKey;
    private boolean bestPlanarLeft;

    CheapestSplit(SahCost costs) {
        this.costs = costs;
    }

    /**
     * Begins a cell, in which no plane has been tried yet.
     *
     * @param voxel its box, as grid numbers
     * @return whether it has a surface; without one, planes have no cost
     */
    boolean begin(int[] voxel) {
        this.voxel = voxel;
        bestCost = Double.POSITIVE_INFINITY;
        setAxis(0);
        area = section + (highest - lowest) * halfPerimeter;
        return area > 0.0;
    }

    /** Sets the axis to which the next planes are perpendicular. */
    void setAxis(int axis) {
        int second = (axis + 1) % 3;
        int third = (axis + 2) % 3;
        this.axis = axis;
        lowest = KDNode.value(voxel[axis]);
        highest = KDNode.value(voxel[axis + 3]);
        double depth = (double) KDNode.value(voxel[second + 3]) - KDNode.value(voxel[second]);
        double height = (double) KDNode.value(voxel[third + 3]) - KDNode.value(voxel[third]);
        halfPerimeter = depth + height;
        section = depth * height;
    }

    /** The cell's lower end on the axis. */
    double lowest() {
        return lowest;
    }

    /** Its upper end. */
    double highest() {
        return highest;
    }

    /** Surface of what lies below a plane over that of the cell. */
    double leftShare(double plane) {
        return (section + (plane - lowest) * halfPerimeter) / area;
    }

    /** Surface of what lies above a plane over that of the cell. */
    double rightShare(double plane) {
        return (section + (highest - plane) * halfPerimeter) / area;
    }

    /**
     * Tries a plane; one that is not strictly inside the cell is left out. Of equally cheap planes, the one on the
     * first axis is kept, and there the lowest.
     *
     * @param left how many triangles reach below it
     * @param planar how many lie in it
     * @param right how many reach above it
     */
    void tryPlane(int key, int left, int planar, int right) {
        if (key <= voxel[axis] || key >= voxel[axis + 3]) {
            return;
        }
        double plane = KDNode.value(key);
        double leftShare = leftShare(plane);
        double rightShare = rightShare(plane);
        double planarLeftCost = costs.split(leftShare, rightShare, left + planar, right);
        double planarRightCost = costs.split(leftShare, rightShare, left, right + planar);
        double cost = Math.min(planarLeftCost, planarRightCost);
        if (cost < bestCost || cost == bestCost && (axis < bestAxis || axis == bestAxis && key < bestKey)) {
            bestCost = cost;
            bestAxis = axis;
            bestKey = key;
            bestPlanarLeft = planarLeftCost <= planarRightCost;
        }
    }

    /** What the cheapest plane costs; infinity while there is none. */
    double cost() {
        return bestCost;
    }

    /** The cheapest split, or empty when no plane inside the cell has been tried. */
    Optional<Split> split() {
        return bestCost < Double.POSITIVE_INFINITY
                ? Optional.of(new Split(bestAxis, bestKey, bestPlanarLeft, bestCost))
                : Optional.empty();
    }
}
