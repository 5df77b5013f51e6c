package org.dronewatch.picture;

import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.sensor.RayRecorder;

/**
 * The straight pieces of the rays of sound that one sensor followed from one drone. Recorded by one thread; once that is
 * done, any thread may look. Beyond {@link #MOST} pieces, more are only counted.
 */
public final class RaySet implements RayRecorder {
    /** So many pieces are kept: 30 MB. */
    public static final int MOST = 1_000_000;

    private static final int ENDS = 6;

    /** Pieces that meet at a point differ there by rounding, m. */
    private static final double SAME = 1e-3;

    private final String sensor;
    private final String drone;
    private float[] ends = new float[ENDS * 1024];
    private float[] levels = new float[1024];
    private int[] orders = new int[1024];
    private final BitSet received = new BitSet();
    private volatile BitSet heard;
    private int count;
    private long leftOut;

    /** An empty set for the rays of a sensor and a drone of these names. */
    public RaySet(String sensor, String drone) {
        this.sensor = sensor;
        this.drone = drone;
    }

    @Override
    public synchronized void record(
            double fromX,
            double fromY,
            double fromZ,
            double toX,
            double toY,
            double toZ,
            double level,
            int order,
            boolean atSensor) {
        if (count == MOST) {
            leftOut++;
            return;
        }
        if (count == levels.length) {
            int size = Math.min(MOST, 2 * count);
            ends = Arrays.copyOf(ends, ENDS * size);
            levels = Arrays.copyOf(levels, size);
            orders = Arrays.copyOf(orders, size);
        }
        int at = ENDS * count;
        ends[at] = (float) fromX;
        ends[at + 1] = (float) fromY;
        ends[at + 2] = (float) fromZ;
        ends[at + 3] = (float) toX;
        ends[at + 4] = (float) toY;
        ends[at + 5] = (float) toZ;
        levels[count] = (float) level;
        orders[count] = order;
        received.set(count, atSensor);
        count++;
        heard = null;
    }

    /** Name of the sensor. */
    public String sensor() {
        return sensor;
    }

    /** Name of the drone. */
    public String drone() {
        return drone;
    }

    /** How many pieces are kept. */
    public int count() {
        return count;
    }

    /** How many pieces were too many to keep. */
    public long leftOut() {
        return leftOut;
    }

    /**
     * One coordinate of an end of a piece, m.
     *
     * @param piece its number
     * @param which 0 to 2 for x, y, z where it begins, 3 to 5 for where it ends
     */
    public float end(int piece, int which) {
        return ends[ENDS * piece + which];
    }

    /** The level of a piece where it ends, dB. */
    public float level(int piece) {
        return levels[piece];
    }

    /** How many surfaces a piece's ray had met before it. */
    public int order(int piece) {
        return orders[piece];
    }

    /** The largest order. */
    public int maxOrder() {
        int most = 0;
        for (int i = 0; i < count; i++) {
            most = Math.max(most, orders[i]);
        }
        return most;
    }

    /** Whether a piece is part of a path that reached the sensor: its end, or what led there. */
    public boolean isHeard(int piece) {
        return heard().get(piece);
    }

    private BitSet heard() {
        BitSet known = heard;
        if (known == null) {
            known = findHeard();
            heard = known;
        }
        return known;
    }

    /** Goes back from each piece that reached the sensor: what led there ends where it begins. */
    private BitSet findHeard() {
        Map<List<Long>, Integer> endingAt = new HashMap<>();
        for (int i = 0; i < count; i++) {
            if (!received.get(i)) {
                endingAt.putIfAbsent(place(i, 3, orders[i]), i);
            }
        }
        BitSet found = new BitSet(count);
        for (int i = received.nextSetBit(0); i >= 0; i = received.nextSetBit(i + 1)) {
            Integer piece = i;
            while (piece != null && !found.get(piece)) {
                found.set(piece);
                piece = orders[piece] == 0 ? null : endingAt.get(place(piece, 0, orders[piece] - 1));
            }
        }
        return found;
    }

    private List<Long> place(int piece, int first, int order) {
        return List.of(
                Math.round(end(piece, first) / SAME),
                Math.round(end(piece, first + 1) / SAME),
                Math.round(end(piece, first + 2) / SAME),
                (long) order);
    }
}
