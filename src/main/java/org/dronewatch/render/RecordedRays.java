package org.dronewatch.render;

import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** The segments of the sound rays that one sensor traced from one drone. Immutable. */
public final class RecordedRays {
    /** Coordinates of the two ends of a segment. */
    static final int ENDS = 6;

    /** The ends of segments that meet at a point may differ by this much because of rounding, m. */
    private static final double SAME = 1e-3;

    private final String sensor;
    private final String drone;
    private final double time;
    private final float[] ends;
    private final float[] levels;
    private final int[] orders;
    private final BitSet heard;
    private final long leftOut;
    private final int maxOrder;
    private final LevelScale scale;

    /** Rays in arrays, which this object takes over. */
    RecordedRays(
            String sensor,
            String drone,
            double time,
            float[] ends,
            float[] levels,
            int[] orders,
            BitSet received,
            long leftOut) {
        this.sensor = sensor;
        this.drone = drone;
        this.time = time;
        this.ends = ends;
        this.levels = levels;
        this.orders = orders;
        this.leftOut = leftOut;
        this.maxOrder = Arrays.stream(orders).max().orElse(0);
        this.heard = findHeard(received);
        this.scale = LevelScale.of(levels);
    }

    /** Name of the sensor. */
    public String sensor() {
        return sensor;
    }

    /** Name of the drone. */
    public String drone() {
        return drone;
    }

    /** Time for which the rays were traced, seconds since the start of the run. */
    public double time() {
        return time;
    }

    /** Number of segments kept. */
    public int count() {
        return levels.length;
    }

    /** Number of segments discarded because there were too many. */
    public long leftOut() {
        return leftOut;
    }

    /**
     * One coordinate of an end of a segment, m.
     *
     * @param piece index of the segment
     * @param which 0 to 2 for x, y, z of its start, 3 to 5 for those of its end
     */
    public float end(int piece, int which) {
        return ends[ENDS * piece + which];
    }

    /**
     * The level of a segment, as {@link org.dronewatch.sensor.RayRecorder#record} receives it: in the level model, at
     * the end of the segment, dB on the calibrated scale of that model; in the energy model, the level of the sound
     * power that the ray carries at the start of the segment, dB re 1 pW.
     */
    public float level(int piece) {
        return levels[piece];
    }

    /** Number of surfaces that the ray had met before this segment. */
    public int order(int piece) {
        return orders[piece];
    }

    /** The largest number of surfaces that a ray had met before any of these segments. */
    public int maxOrder() {
        return maxOrder;
    }

    /** The colour scale for the levels of these segments. */
    public LevelScale scale() {
        return scale;
    }

    /** Whether a segment is part of a path that reached the sensor. */
    public boolean isHeard(int piece) {
        return heard.get(piece);
    }

    /** Traces back from each segment that reached the sensor: its predecessor ends where it begins. */
    private BitSet findHeard(BitSet received) {
        Map<List<Long>, Integer> endingAt = new HashMap<>();
        for (int i = 0; i < count(); i++) {
            if (!received.get(i)) {
                endingAt.putIfAbsent(endKey(i, 3, orders[i]), i);
            }
        }
        BitSet found = new BitSet(count());
        for (int i = received.nextSetBit(0); i >= 0; i = received.nextSetBit(i + 1)) {
            Integer piece = i;
            while (piece != null && !found.get(piece)) {
                found.set(piece);
                piece = orders[piece] == 0 ? null : endingAt.get(endKey(piece, 0, orders[piece] - 1));
            }
        }
        return found;
    }

    private List<Long> endKey(int piece, int first, int order) {
        return List.of(
                Math.round(end(piece, first) / SAME),
                Math.round(end(piece, first + 1) / SAME),
                Math.round(end(piece, first + 2) / SAME),
                (long) order);
    }
}
