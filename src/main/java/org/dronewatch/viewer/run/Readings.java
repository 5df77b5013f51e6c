package org.dronewatch.viewer.run;

import java.util.Arrays;
import java.util.Optional;
import org.dronewatch.sensor.Observation;

/**
 * All measurements that a sensor has made of a drone, in order of time. A very long run is thinned: once {@link #MOST}
 * are kept, every other one is forgotten. Guarded by its owner.
 */
final class Readings {
    /** Maximum number kept: 3 MB. */
    static final int MOST = 1 << 17;

    private double[] times = new double[64];
    private float[] values = new float[64];
    private float[] thresholds = new float[64];
    private float[] ranges = new float[64];
    private String unit = "";
    private int count;

    /** Only every reading whose index is a multiple of this is kept. */
    private int stride = 1;

    private int skipped;

    void add(Observation observation) {
        unit = observation.unit();
        if (++skipped < stride) {
            return;
        }
        skipped = 0;
        if (count == MOST) {
            thin();
        }
        if (count == times.length) {
            int size = Math.min(MOST, 2 * count);
            times = Arrays.copyOf(times, size);
            values = Arrays.copyOf(values, size);
            thresholds = Arrays.copyOf(thresholds, size);
            ranges = Arrays.copyOf(ranges, size);
        }
        times[count] = observation.arrival();
        values[count] = (float) observation.value();
        thresholds[count] = (float) observation.threshold();
        ranges[count] = (float) observation.range();
        count++;
    }

    private void thin() {
        for (int i = 0; 2 * i < count; i++) {
            times[i] = times[2 * i];
            values[i] = values[2 * i];
            thresholds[i] = thresholds[2 * i];
            ranges[i] = ranges[2 * i];
        }
        count /= 2;
        stride *= 2;
    }

    /** The last measurement up to a given time. */
    Optional<PairReading> at(double time) {
        int found = Arrays.binarySearch(times, 0, count, time);
        int last = found >= 0 ? found : -found - 2;
        return last < 0
                ? Optional.empty()
                : Optional.of(new PairReading(times[last], values[last], thresholds[last], unit, ranges[last]));
    }

    int count() {
        return count;
    }
}
