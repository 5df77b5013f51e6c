package org.dronewatch.kdtree;

import java.util.Arrays;

/**
 * The triangles of a tree, each at its place in the order in which the tree's leaves come to it first. What lies together in
 * space then lies together in memory, however a model's file orders its faces. Immutable, shared by all threads.
 */
public final class LeafOrderTriangles {
    private final float[] corners;
    private final int[] numbers;

    private LeafOrderTriangles(float[] corners, int[] numbers) {
        this.corners = corners;
        this.numbers = numbers;
    }

    /**
     * Gives triangles their places. Those in no leaf, which no ray can hit, come last.
     *
     * @param leaves the triangles' numbers, leaf by leaf; is rewritten to their places
     * @param corners nine coordinates a triangle, by number
     */
    static LeafOrderTriangles of(int[] leaves, float[] corners) {
        int[] places = new int[corners.length / 9];
        int[] numbers = new int[places.length];
        Arrays.fill(places, -1);
        int placed = 0;
        for (int i = 0; i < leaves.length; i++) {
            int number = leaves[i];
            if (places[number] < 0) {
                places[number] = placed;
                numbers[placed++] = number;
            }
            leaves[i] = places[number];
        }
        for (int number = 0; placed < numbers.length; number++) {
            if (places[number] < 0) {
                numbers[placed++] = number;
            }
        }
        float[] moved = new float[corners.length];
        for (int place = 0; place < numbers.length; place++) {
            System.arraycopy(corners, 9 * numbers[place], moved, 9 * place, 9);
        }
        return new LeafOrderTriangles(moved, numbers);
    }

    /** Nine coordinates per triangle; for the kernel's packages, which do not write to it. */
    public float[] corners() {
        return corners;
    }

    /** The triangles' numbers in the mesh; for the kernel's packages, which do not write to it. */
    public int[] numbers() {
        return numbers;
    }

    /** How many there are. */
    public int count() {
        return numbers.length;
    }
}
