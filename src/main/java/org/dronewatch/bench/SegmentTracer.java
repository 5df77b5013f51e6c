package org.dronewatch.bench;

import org.dronewatch.kdtree.RayTracer;

/** Tests segments for obstacles one at a time. */
final class SegmentTracer implements Tracer {
    private static final int PIECE = 4096;

    private final RayTracer traversal;
    private final RaySet set;

    SegmentTracer(RayTracer traversal, RaySet set) {
        this.traversal = traversal;
        this.set = set;
    }

    @Override
    public int pieces() {
        return (set.count() + PIECE - 1) / PIECE;
    }

    /** The distances stay as they are; the number of the triangle is 0 for any. */
    @Override
    public void trace(int piece, float[] distances, int[] triangles) {
        float[] r = set.rays();
        int to = Math.min((piece + 1) * PIECE, set.count());
        for (int ray = piece * PIECE; ray < to; ray++) {
            int i = ray * RaySet.FLOATS;
            boolean hidden = traversal.isOccluded(r[i], r[i + 1], r[i + 2], r[i + 3], r[i + 4], r[i + 5], 0.0, 1.0);
            triangles[ray] = hidden ? 0 : -1;
        }
    }
}
