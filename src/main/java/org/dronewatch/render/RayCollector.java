package org.dronewatch.render;

import java.util.Arrays;
import java.util.BitSet;
import org.dronewatch.sensor.RayRecorder;

/**
 * Collects the segments of the sound rays that one sensor traces from one drone. Segments beyond the
 * {@linkplain #MOST maximum number} are only counted. For use by one thread.
 */
public final class RayCollector implements RayRecorder {
    /** Maximum number of segments kept (30 MB). */
    public static final int MOST = 1_000_000;

    private static final int FIRST = 1024;

    private final String sensor;
    private final String drone;
    private final double time;
    private float[] ends = new float[RecordedRays.ENDS * FIRST];
    private float[] levels = new float[FIRST];
    private int[] orders = new int[FIRST];
    private final BitSet received = new BitSet();
    private int count;
    private long leftOut;

    /**
     * A collector for the rays of the sensor and the drone with these names.
     *
     * @param time time for which the rays are traced, seconds since the start of the run
     */
    public RayCollector(String sensor, String drone, double time) {
        this.time = time;
        this.sensor = sensor;
        this.drone = drone;
    }

    @Override
    public void record(
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
            ends = Arrays.copyOf(ends, RecordedRays.ENDS * size);
            levels = Arrays.copyOf(levels, size);
            orders = Arrays.copyOf(orders, size);
        }
        int at = RecordedRays.ENDS * count;
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
    }

    /** The collected segments. */
    public RecordedRays toRays() {
        return new RecordedRays(
                sensor,
                drone,
                time,
                Arrays.copyOf(ends, RecordedRays.ENDS * count),
                Arrays.copyOf(levels, count),
                Arrays.copyOf(orders, count),
                received,
                leftOut);
    }
}
