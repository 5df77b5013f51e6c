package org.dronewatch.kdtree;

import java.util.Arrays;

/**
 * The triangles of a tree, in leaf order: the order in which they first occur in the leaves. Triangles that are close
 * together in space are thus close together in memory, whatever the order of faces in a model's file. Immutable, shared
 * by all threads.
 */
public final class LeafOrderTriangles {
    private final float[] corners;
    private final int[] numbers;

    /**
     * Triangles in leaf order; the arrays are kept, not copied.
     *
     * @param corners nine coordinates per triangle
     * @param numbers of the triangles in the mesh
     */
    LeafOrderTriangles(float[] corners, int[] numbers) {
        this.corners = corners;
        this.numbers = numbers;
    }

    /**
     * Sorts triangles into leaf order. Those in no leaf, which no ray can hit, come last.
     *
     * @param leaves the triangles' numbers, leaf by leaf; is overwritten with their indices in leaf order
     * @param corners nine coordinates a triangle, by number
     */
    static LeafOrderTriangles of(int[] leaves, float[] corners) {
        int[] indices = new int[corners.length / 9];
        int[] numbers = new int[indices.length];
        Arrays.fill(indices, -1);
        int next = 0;
        for (int i = 0; i < leaves.length; i++) {
            int number = leaves[i];
            if (indices[number] < 0) {
                indices[number] = next;
                numbers[next++] = number;
            }
            leaves[i] = indices[number];
        }
        for (int number = 0; next < numbers.length; number++) {
            if (indices[number] < 0) {
                numbers[next++] = number;
            }
        }
        float[] moved = new float[corners.length];
        for (int index = 0; index < numbers.length; index++) {
            System.arraycopy(corners, 9 * numbers[index], moved, 9 * index, 9);
        }
        return new LeafOrderTriangles(moved, numbers);
    }

    /**
     * Nine coordinates per triangle: x, y and z of each corner, m; for the ray-tracing packages of this library, which
     * do not write to the array.
     */
    public float[] corners() {
        return corners;
    }

    /**
     * The triangles' indices in the mesh; for the ray-tracing packages of this library, which do not write to the
     * array.
     */
    public int[] numbers() {
        return numbers;
    }

    /** The number of triangles. */
    public int count() {
        return numbers.length;
    }
}
