package org.dronewatch.bench;

import org.dronewatch.bvh.SegmentFan;

/** Tests segments for obstacles; consecutive segments with a common origin are tested together. */
final class FanSetTracer implements Tracer {
    private static final int PIECE = 1 << 16;

    private final SegmentFan fan;
    private final RaySet set;
    private final double[] vectors;
    private final boolean[] hidden;

    FanSetTracer(SegmentFan fan, RaySet set) {
        this.fan = fan;
        this.set = set;
        int most = Math.min(PIECE, set.count());
        this.vectors = new double[3 * most];
        this.hidden = new boolean[most];
    }

    @Override
    public int pieces() {
        return (set.count() + PIECE - 1) / PIECE;
    }

    @Override
    public void trace(int piece, float[] distances, int[] triangles) {
        int to = Math.min((piece + 1) * PIECE, set.count());
        int begin = piece * PIECE;
        while (begin < to) {
            int end = take(begin, to);
            float[] r = set.rays();
            int at = begin * RaySet.FLOATS;
            fan.trace(r[at], r[at + 1], r[at + 2], vectors, end - begin, 0.0, hidden);
            for (int ray = begin; ray < end; ray++) {
                triangles[ray] = hidden[ray - begin] ? 0 : -1;
            }
            begin = end;
        }
    }

    /** Takes the segments with the origin of the first; returns the first one that has another. */
    private int take(int begin, int to) {
        float[] r = set.rays();
        int first = begin * RaySet.FLOATS;
        int ray = begin;
        int at = first;
        while (ray < to && r[at] == r[first] && r[at + 1] == r[first + 1] && r[at + 2] == r[first + 2]) {
            int i = 3 * (ray - begin);
            vectors[i] = r[at + 3];
            vectors[i + 1] = r[at + 4];
            vectors[i + 2] = r[at + 5];
            ray++;
            at += RaySet.FLOATS;
        }
        return ray;
    }
}
