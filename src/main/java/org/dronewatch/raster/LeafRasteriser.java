package org.dronewatch.raster;

import java.util.Arrays;

/** Paints the triangles of leaves into a tile, each of them once, as far as it remembers. One per thread. */
final class LeafRasteriser {
    /** How many triangles are remembered as painted, a power of two. */
    private static final int REMEMBERED = 1024;

    private final int[] leafTriangles;
    private final TriangleSetup painter;

    /**
     * Places of triangles that were painted into this tile lately, each in the slot of its lowest bits: they lie in many leaves.
     * One that was forgotten is painted again, which changes nothing, and counts as met again.
     */
    private final int[] painted = new int[REMEMBERED];

    /** Places of those that come next. */
    private final int[] unpainted = new int[TriangleSetup.MOST];

    private int met;

    /**
     * A painter of leaves.
     *
     * @param leafTriangles places of a tree's triangles, leaf by leaf
     * @param painter paints them
     */
    LeafRasteriser(int[] leafTriangles, TriangleSetup painter) {
        this.leafTriangles = leafTriangles;
        this.painter = painter;
    }

    /** Begins a tile, after its pixels have. */
    void begin() {
        painter.begin();
        met = 0;
        Arrays.fill(painted, -1);
    }

    /** How many triangles the tile has met. */
    int met() {
        return met;
    }

    /** Whether a triangle came that cannot be painted. */
    boolean isLost() {
        return painter.isLost();
    }

    /**
     * Paints the triangles of neighbouring leaves.
     *
     * @param from the first of the leaves' entries
     * @param to the entry after their last
     */
    void paint(int from, int to) {
        for (int begin = from; begin < to; begin += TriangleSetup.MOST) {
            paintUnpainted(begin, Math.min(to, begin + TriangleSetup.MOST));
        }
    }

    private void paintUnpainted(int from, int to) {
        int count = 0;
        for (int i = from; i < to; i++) {
            int place = leafTriangles[i];
            int slot = place & (REMEMBERED - 1);
            unpainted[count] = place;
            // No branch: writing what is not needed costs less than guessing wrong.
            count += painted[slot] == place ? 0 : 1;
            painted[slot] = place;
        }
        met += count;
        painter.paint(unpainted, count);
    }
}
