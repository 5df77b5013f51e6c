package org.dronewatch.bench;

import org.dronewatch.kdtree.RayTracer;

/** Traces rays, or tests segments for obstacles, one at a time. */
final class RaySetTracer implements Tracer {
    private static final int PIECE = 4096;

    private final RayTracer traversal;
    private final RaySet set;

    RaySetTracer(RayTracer traversal, RaySet set) {
        this.traversal = traversal;
        this.set = set;
    }

    @Override
    public int pieces() {
        return (set.count() + PIECE - 1) / PIECE;
    }

    @Override
    public void trace(int piece, float[] distances, int[] triangles) {
        int to = Math.min((piece + 1) * PIECE, set.count());
        for (int ray = piece * PIECE; ray < to; ray++) {
            if (set.query() == RaySet.Query.OCCLUDED) {
                triangles[ray] = isOccluded(ray) ? 0 : -1;
            } else {
                traceRay(ray, distances, triangles);
            }
        }
    }

    private boolean isOccluded(int ray) {
        float[] r = set.rays();
        int i = ray * RaySet.FLOATS;
        return traversal.isOccluded(r[i], r[i + 1], r[i + 2], r[i + 3], r[i + 4], r[i + 5], 0.0, 1.0);
    }

    /** Finds the nearest triangle along one ray. */
    void traceRay(int ray, float[] distances, int[] triangles) {
        float[] r = set.rays();
        int i = ray * RaySet.FLOATS;
        boolean hit = traversal.closestHit(
                r[i], r[i + 1], r[i + 2], r[i + 3], r[i + 4], r[i + 5], 0.0, Double.POSITIVE_INFINITY);
        distances[ray] = hit ? (float) traversal.distance() : Float.POSITIVE_INFINITY;
        triangles[ray] = hit ? traversal.triangle() : -1;
    }
}
