package org.dronewatch.bvh;

import java.util.Arrays;
import org.dronewatch.kdtree.LeafOrderTriangles;

/**
 * The triangles of a small mesh, such as an empty room, for {@link FewTrianglesTraversal}: blocks of four, so that one
 * vector holds the same coordinate of all four. All blocks are stored three times, once for each axis that the triangle
 * test may choose as that of the ray, with the coordinates in the order in which the test then reads them: x, y, z of
 * the first, second and third corners. Immutable, shared by all threads.
 */
final class FewTriangles {
    /** Maximum number of triangles. */
    static final int MOST = 16;

    /** Triangles of a block. */
    static final int LANES = 4;

    /** Numbers from the coordinates of a corner to those of the next one. */
    static final int CORNER = 3 * LANES;

    /** Numbers of a block. */
    static final int BLOCK = 3 * CORNER;

    private final double[] coordinates;
    private final int[] numbers;

    /** The number of triangles, and of the lanes of blocks that hold nothing. */
    private final int lanes;

    FewTriangles(LeafOrderTriangles triangles) {
        this.lanes = (triangles.count() + LANES - 1) / LANES * LANES;
        this.numbers = Arrays.copyOf(triangles.numbers(), lanes);
        this.coordinates = new double[3 * 9 * lanes];
        for (int axis = 0; axis < 3; axis++) {
            for (int triangle = 0; triangle < triangles.count(); triangle++) {
                for (int k = 0; k < 9; k++) {
                    int coordinate = k / 3 * 3 + (k + axis + 1) % 3;
                    coordinates[index(axis, triangle, k)] = triangles.corners()[9 * triangle + coordinate];
                }
            }
        }
    }

    /** All coordinates; unused lanes hold triangles without extent, which no ray hits. */
    double[] coordinates() {
        return coordinates;
    }

    /** Index of the first block for an axis. */
    int first(int axis) {
        return 9 * lanes * axis;
    }

    /** A coordinate of a triangle in the order for an axis: 0 to 8, corner by corner. */
    double coordinate(int axis, int lane, int k) {
        return coordinates[index(axis, lane, k)];
    }

    private int index(int axis, int lane, int k) {
        return first(axis) + lane / LANES * BLOCK + k * LANES + lane % LANES;
    }

    /** The number of triangles, and of unused lanes. */
    int lanes() {
        return lanes;
    }

    /** The number in the mesh of a triangle. */
    int number(int lane) {
        return numbers[lane];
    }
}
