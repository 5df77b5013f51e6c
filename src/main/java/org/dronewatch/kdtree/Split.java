package org.dronewatch.kdtree;

/**
 * A plane that cuts a cell in two.
 *
 * @param axis 0, 1 or 2
 * @param key the plane's number on the grid of {@link KDNode}, strictly inside the cell
 * @param planarLeft whether triangles that lie in the plane go to the left part
 * @param cost expected cost of the split, by {@link SahCost}
 */
record Split(int axis, int key, boolean planarLeft, double cost) {

    /** Whether a triangle of these bounds on the split's axis belongs to the left part. */
    boolean isLeft(int low, int high) {
        return low < key || planarLeft && low == key && high == key;
    }

    /** Whether a triangle of these bounds on the split's axis belongs to the right part. */
    boolean isRight(int low, int high) {
        return high > key || !planarLeft && low == key && high == key;
    }
}
