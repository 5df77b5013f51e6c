package org.dronewatch.bvh;

import java.util.Arrays;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * Segments with a common origin and nearly the same direction, which are traced together. Each takes one lane of the
 * processor's vectors, with its direction, scaled to length 1 along the axis along which all of them are longest, and
 * its length along that axis. For use by one thread.
 */
final class FanBeam {
    /** Lanes of a vector. */
    static final int WIDTH = 8;

    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_256;

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

    // The range of the ends and the origin across the beam and along it, relative to the origin, widened by rounding,
    // m.
    double lowAcross;
    double highAcross;
    double lowAlong;
    double highAlong;

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
        lanes = Math.min(MOST, Math.min(to, order.faceEnd(from, to)) - from);
        order.copy(from, lanes, segments, across, along, ends);
        int padded = padded();
        Arrays.fill(across, lanes, padded, across[lanes - 1]);
        Arrays.fill(along, lanes, padded, along[lanes - 1]);
        Arrays.fill(ends, lanes, padded, ends[lanes - 1]);
        Arrays.fill(blocked, 0, padded, 0);
        Arrays.fill(clear, 0, padded, -1);
        findRanges();
        centre();
        return from + lanes;
    }

    /** Finds the ranges of directions and ends. */
    private void findRanges() {
        FloatVector x = FloatVector.fromArray(FLOATS, across, 0);
        FloatVector y = FloatVector.fromArray(FLOATS, along, 0);
        FloatVector end = FloatVector.fromArray(FLOATS, ends, 0);
        FloatVector leastX = x;
        FloatVector mostX = x;
        FloatVector leastY = y;
        FloatVector mostY = y;
        FloatVector mostEnd = end;
        FloatVector lowX = x.mul(end);
        FloatVector highX = lowX;
        FloatVector lowY = y.mul(end);
        FloatVector highY = lowY;
        for (int i = WIDTH; i < padded(); i += WIDTH) {
            x = FloatVector.fromArray(FLOATS, across, i);
            y = FloatVector.fromArray(FLOATS, along, i);
            end = FloatVector.fromArray(FLOATS, ends, i);
            leastX = leastX.min(x);
            mostX = mostX.max(x);
            leastY = leastY.min(y);
            mostY = mostY.max(y);
            mostEnd = mostEnd.max(end);
            x = x.mul(end);
            y = y.mul(end);
            lowX = lowX.min(x);
            highX = highX.max(x);
            lowY = lowY.min(y);
            highY = highY.max(y);
        }
        float leastAcross = leastX.reduceLanes(VectorOperators.MIN);
        float mostAcross = mostX.reduceLanes(VectorOperators.MAX);
        float leastAlong = leastY.reduceLanes(VectorOperators.MIN);
        float mostAlong = mostY.reduceLanes(VectorOperators.MAX);
        // In single precision, since that is what directions are relative to.
        float u = 0.5f * (leastAcross + mostAcross);
        float v = 0.5f * (leastAlong + mostAlong);
        middleAcross = u;
        middleAlong = v;
        halfAcross = Math.max(mostAcross - u, u - leastAcross) + ROUNDING;
        halfAlong = Math.max(mostAlong - v, v - leastAlong) + ROUNDING;
        farthest = mostEnd.reduceLanes(VectorOperators.MAX);
        double rounding = ROUNDING * farthest;
        lowAcross = Math.min(0.0, lowX.reduceLanes(VectorOperators.MIN)) - rounding;
        highAcross = Math.max(0.0, highX.reduceLanes(VectorOperators.MAX)) + rounding;
        lowAlong = Math.min(0.0, lowY.reduceLanes(VectorOperators.MIN)) - rounding;
        highAlong = Math.max(0.0, highY.reduceLanes(VectorOperators.MAX)) + rounding;
    }

    /** Makes directions relative to the middle, and ends to the farthest one. */
    private void centre() {
        float u = (float) middleAcross;
        float v = (float) middleAlong;
        float perMetre = 1.0f / (float) farthest;
        int padded = padded();
        for (int i = 0; i < padded; i++) {
            across[i] -= u;
            along[i] -= v;
            ends[i] *= perMetre;
        }
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
