package org.dronewatch.campaign;

import java.util.Arrays;
import java.util.OptionalDouble;

/** A quantity of many cases, where a case without it counts as worse than any with it. */
public final class Measures {
    private double[] values = new double[64];
    private int count;

    /** Adds a case. */
    void add(OptionalDouble value) {
        if (count == values.length) {
            values = Arrays.copyOf(values, 2 * count);
        }
        values[count++] = value.orElse(Double.NEGATIVE_INFINITY);
    }

    /**
     * The quantile of the cases, by nearest rank: the least value that at least this share of them does not exceed.
     *
     * @param share above 0, up to 1
     * @return empty without cases, and where the case of that rank lacks the quantity
     */
    public OptionalDouble quantile(double share) {
        if (count == 0) {
            return OptionalDouble.empty();
        }
        double[] sorted = Arrays.copyOf(values, count);
        Arrays.sort(sorted);
        double value = sorted[Math.max(0, (int) Math.ceil(share * count - 1e-9) - 1)];
        return Double.isFinite(value) ? OptionalDouble.of(value) : OptionalDouble.empty();
    }
}
