package org.dronewatch.bvh;

/**
 * Segments with a common origin and nearly the same direction, which are traced together. Each is a lane of the
 * processor's vectors: its direction, scaled to length 1 along that axis along which all are longest, and its length
 * along that axis. For the use of one thread.
 */
final class FanBeam {
    /** Lanes of a vector. */
    static final int WIDTH = 8;

    /** How many segments are traced together, at most. */
    static final int MOST = 128;

    /** Fewer segments than this are faster one by one. */
    private static final int FEWEST = 4;

    /** Above the rounding of directions in single precision. */
    static final double ROUNDING = 0x1p-22;

    // The lanes, in single precision: directions relative to the middle one, ends as a fraction of the farthest one.
    final float[] across = new float[MOST];
    final float[] along = new float[MOST];
    final float[] ends = new float[MOST];

    /** Negative if a triangle certainly hides the segment. */
    final int[] blocked = new int[MOST];

    /** Negative as long as no triangle may hide it. */
    final int[] clear = new int[MOST];

    private final int[] segments = new int[MOST];
    private int lanes;
    private boolean isBounded;

    // The axes: the two across the beam, and the one along which it runs, with its sign.
    int axisAcross;
    int axisAlong;
    int axisAhead;
    double sign;

    // The range of directions: its middle and half its width, which includes rounding; and the farthest end.
    double middleAcross;
    double middleAlong;
    double halfAcross;
    double halfAlong;
    double farthest;

    /**
     * Takes segments of an order that run along the same axis.
     *
     * @param from the position of the first one
     * @param to the position after the last one of the order
     * @return the position after the last one that it took
     */
    int take(FanOrder order, int from, int to) {
        int face = order.face(order.segment(from));
        isBounded = face != FanOrder.UNBOUNDED;
        axisAhead = face >> 1;
        axisAcross = axisAhead == 2 ? 0 : axisAhead + 1;
        axisAlong = axisAcross == 2 ? 0 : axisAcross + 1;
        sign = (face & 1) == 0 ? 1.0 : -1.0;
        float leastAcross = Float.POSITIVE_INFINITY;
        float mostAcross = Float.NEGATIVE_INFINITY;
        float leastAlong = Float.POSITIVE_INFINITY;
        float mostAlong = Float.NEGATIVE_INFINITY;
        float last = 0.0f;
        lanes = 0;
        int most = Math.min(MOST, to - from);
        while (lanes < most) {
            int segment = order.segment(from + lanes);
            if (order.face(segment) != face) {
                break;
            }
            float u = order.across(segment);
            float v = order.along(segment);
            float end = order.end(segment);
            leastAcross = u < leastAcross ? u : leastAcross;
            mostAcross = u > mostAcross ? u : mostAcross;
            leastAlong = v < leastAlong ? v : leastAlong;
            mostAlong = v > mostAlong ? v : mostAlong;
            last = end > last ? end : last;
            segments[lanes] = segment;
            across[lanes] = u;
            along[lanes] = v;
            ends[lanes] = end;
            lanes++;
        }
        float u = 0.5f * (leastAcross + mostAcross);
        float v = 0.5f * (leastAlong + mostAlong);
        middleAcross = u;
        middleAlong = v;
        halfAcross = Math.max(mostAcross - u, u - leastAcross) + ROUNDING;
        halfAlong = Math.max(mostAlong - v, v - leastAlong) + ROUNDING;
        farthest = last;
        float perMetre = 1.0f / last;
        int padded = padded();
        for (int i = lanes; i < padded; i++) {
            across[i] = across[lanes - 1];
            along[i] = along[lanes - 1];
            ends[i] = ends[lanes - 1];
        }
        for (int i = 0; i < padded; i++) {
            across[i] -= u;
            along[i] -= v;
            ends[i] *= perMetre;
            blocked[i] = 0;
            clear[i] = -1;
        }
        return from + lanes;
    }

    /** Whether they can be traced together: single precision bounds their lengths. */
    boolean isTraceable() {
        return isBounded && lanes >= FEWEST;
    }

    /** The number of segments that were taken. */
    int lanes() {
        return lanes;
    }

    /** The number of lanes of whole vectors; those beyond the segments repeat the last one. */
    int padded() {
        return (lanes + WIDTH - 1) & -WIDTH;
    }

    /** The segment of a lane. */
    int segment(int lane) {
        return segments[lane];
    }

    /** Whether a triangle certainly hides it. */
    boolean isHidden(int lane) {
        return blocked[lane] < 0;
    }

    /** Whether certainly no triangle hides it. */
    boolean isClear(int lane) {
        return clear[lane] < 0;
    }
}
