package org.dronewatch.raster;

import java.util.Arrays;

/**
 * Rasterises the triangles of leaves into a tile, each of them only once, unless it has been forgotten in the meantime.
 * For use by one thread.
 */
final class LeafRasteriser {
    /** How many triangles are remembered as rasterised, a power of two. */
    private static final int REMEMBERED = 1024;

    private final int[] leafTriangles;
    private final TriangleSetup setup;

    /**
     * Indices of triangles that were recently rasterised into this tile, each in the slot of its lowest bits: triangles
     * are in many leaves. One that was forgotten is rasterised again, which changes nothing, and counts as met again.
     */
    private final int[] recent = new int[REMEMBERED];

    /** Indices of those that come next. */
    private final int[] batch = new int[TriangleSetup.MOST];

    private int met;

    /**
     * A rasteriser of leaves.
     *
     * @param leafTriangles indices of a tree's triangles in leaf order, leaf by leaf
     * @param setup rasterises them
     */
    LeafRasteriser(int[] leafTriangles, TriangleSetup setup) {
        this.leafTriangles = leafTriangles;
        this.setup = setup;
    }

    /** Begins a tile, after {@link TileBuffer#begin}. */
    void begin() {
        setup.begin();
        met = 0;
        Arrays.fill(recent, -1);
    }

    /** How many triangles the tile has met. */
    int met() {
        return met;
    }

    /** Whether there was a triangle that cannot be rasterised. */
    boolean isUnable() {
        return setup.isUnable();
    }

    /**
     * Rasterises the triangles of neighbouring leaves.
     *
     * @param from the first of the leaves' entries
     * @param to the entry after their last
     */
    void rasterise(int from, int to) {
        for (int begin = from; begin < to; begin += TriangleSetup.MOST) {
            rasteriseBatch(begin, Math.min(to, begin + TriangleSetup.MOST));
        }
    }

    private void rasteriseBatch(int from, int to) {
        int count = 0;
        for (int i = from; i < to; i++) {
            int index = leafTriangles[i];
            int slot = index & (REMEMBERED - 1);
            batch[count] = index;
            // No branch: writing what is not needed costs less than a misprediction.
            count += recent[slot] == index ? 0 : 1;
            recent[slot] = index;
        }
        met += count;
        setup.rasterise(batch, count);
    }
}
