package org.dronewatch.bvh;

import org.dronewatch.geometry.AABB;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.RayTracer;

/**
 * Determines which of many segments with a common origin are blocked: the lines of sight from a sensor to many points.
 * The answers are those of {@link RayTracer#isOccluded} for each segment, except for segments that begin or end on a
 * triangle if nothing is skipped at their ends: rounding decides whether these are blocked, as it does for single rays.
 * Segments of similar directions are traced together, in whatever order they are given; those that single precision
 * cannot decide are traced again, one by one. For use by one thread.
 */
public final class SegmentFan {
    private final RayTracer single;
    private final FanOrder order = new FanOrder();

    /** The segments that are traced together; null to trace all of them one by one. */
    private final FanBeam beam;

    private final FanTracer tracer;

    private double ox;
    private double oy;
    private double oz;

    /**
     * Segments in a tree.
     *
     * @param single traces one segment
     * @param byVectors whether the processor's vector instructions can be used
     */
    SegmentFan(KDTree tree, RayTracer single, boolean byVectors) {
        this.single = single;
        boolean areTogether = byVectors && isBounded(tree.bounds());
        this.beam = areTogether ? new FanBeam() : null;
        this.tracer = areTogether ? new FanTracer(tree, beam) : null;
    }

    private static boolean isBounded(AABB box) {
        return isBounded(box.minX(), box.minY(), box.minZ()) && isBounded(box.maxX(), box.maxY(), box.maxZ());
    }

    private static boolean isBounded(double x, double y, double z) {
        return Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z))) < FanOrder.FARTHEST;
    }

    /**
     * Determines which segments are blocked.
     *
     * @param originX x of the common origin, m
     * @param originY y of the common origin, m
     * @param originZ z of the common origin, m
     * @param vectors vectors of the segments from the origin to their ends: x, y and z of each, m
     * @param count number of segments
     * @param skipped triangles within this distance of either end of a segment do not count, m; 0 or more, and more
     *     than 0 for ends on surfaces
     * @param hidden receives, for each segment, whether any triangle blocks it; nothing blocks a segment without length
     */
    public void trace(
            double originX,
            double originY,
            double originZ,
            double[] vectors,
            int count,
            double skipped,
            boolean[] hidden) {
        ox = originX;
        oy = originY;
        oz = originZ;
        if (tracer == null || !isBounded(ox, oy, oz)) {
            for (int segment = 0; segment < count; segment++) {
                hidden[segment] = isHidden(vectors, segment, skipped);
            }
            return;
        }
        for (int from = 0; from < count; from += FanOrder.MOST) {
            traceSorted(vectors, from, Math.min(FanOrder.MOST, count - from), skipped, hidden);
        }
    }

    private void traceSorted(double[] vectors, int first, int count, double skipped, boolean[] hidden) {
        order.sort(vectors, first, count);
        int from = 0;
        while (from < count) {
            from = beam.take(order, from, count);
            boolean isTraced = beam.isTraceable();
            if (isTraced) {
                tracer.trace(ox, oy, oz, skipped);
            }
            for (int lane = 0; lane < beam.lanes(); lane++) {
                int segment = first + beam.segment(lane);
                hidden[segment] = isTraced && beam.isHidden(lane)
                        || !(isTraced && beam.isClear(lane)) && isHidden(vectors, segment, skipped);
            }
        }
    }

    private boolean isHidden(double[] vectors, int segment, double skipped) {
        double x = vectors[3 * segment];
        double y = vectors[3 * segment + 1];
        double z = vectors[3 * segment + 2];
        double start = skipped == 0.0 ? 0.0 : skipped / Math.sqrt(x * x + y * y + z * z);
        return (x != 0.0 || y != 0.0 || z != 0.0) && single.isOccluded(ox, oy, oz, x, y, z, start, 1.0 - start);
    }
}
