package org.dronewatch.campaign.outcome;

import java.util.Arrays;
import java.util.OptionalDouble;
import java.util.function.DoubleConsumer;

/**
 * The values of a quantity in many cases. A case without a value counts as lower than any with one. For use by one
 * thread. Memory does not grow with the number of cases: beyond a few thousand, values go to a temporary file.
 */
public final class Measures {
    /** The greatest number of values in memory. */
    static final int MOST_IN_MEMORY = 1 << 13;

    private static final int DIGIT_BITS = 16;

    private double[] values = new double[64];
    private int inMemory;
    private int count;
    private SpilledValues spilled;

    /** Adds a case. */
    void add(OptionalDouble value) {
        if (inMemory == MOST_IN_MEMORY) {
            spill();
        }
        if (inMemory == values.length) {
            values = Arrays.copyOf(values, 2 * inMemory);
        }
        values[inMemory++] = value.orElse(Double.NEGATIVE_INFINITY);
        count++;
    }

    private void spill() {
        if (spilled == null) {
            spilled = new SpilledValues();
        }
        spilled.add(values, inMemory);
        inMemory = 0;
    }

    private void forEach(DoubleConsumer action) {
        if (spilled != null) {
            spilled.forEach(action);
        }
        for (int i = 0; i < inMemory; i++) {
            action.accept(values[i]);
        }
    }

    /**
     * The quantile of the cases, by nearest rank: the least value that at least the given fraction of the cases does
     * not exceed.
     *
     * @param share the fraction, above 0, up to 1
     * @return the quantile; empty if there are no cases, or if the case of that rank lacks the quantity
     */
    public OptionalDouble quantile(double share) {
        if (count == 0) {
            return OptionalDouble.empty();
        }
        double value = ofRank(Math.max(0, (int) Math.ceil(share * count - 1e-9) - 1));
        return Double.isFinite(value) ? OptionalDouble.of(value) : OptionalDouble.empty();
    }

    /**
     * The value of a rank, from 0. Values are counted by their leading digits, and those that begin as the wanted one
     * does by the next digit, until the rest fits into memory.
     */
    private double ofRank(int rank) {
        long prefix = 0;
        int known = 0;
        int left = rank;
        int among = count;
        while (among > MOST_IN_MEMORY && known < Long.SIZE) {
            int[] counts = counts(prefix, known);
            int digit = 0;
            while (left >= counts[digit]) {
                left -= counts[digit++];
            }
            among = counts[digit];
            prefix = prefix << DIGIT_BITS | digit;
            known += DIGIT_BITS;
        }
        return known == Long.SIZE ? value(prefix) : sorted(prefix, known, among)[left];
    }

    /** How many of the values whose keys begin with some bits have each digit next. */
    private int[] counts(long prefix, int known) {
        int[] counts = new int[1 << DIGIT_BITS];
        forEach(value -> {
            long key = key(value);
            if (begins(key, prefix, known)) {
                counts[(int) (key >>> Long.SIZE - known - DIGIT_BITS) & counts.length - 1]++;
            }
        });
        return counts;
    }

    private double[] sorted(long prefix, int known, int among) {
        double[] chosen = new double[among];
        int[] next = {0};
        forEach(value -> {
            if (begins(key(value), prefix, known)) {
                chosen[next[0]++] = value;
            }
        });
        Arrays.sort(chosen);
        return chosen;
    }

    private static boolean begins(long key, long prefix, int known) {
        return known == 0 || key >>> Long.SIZE - known == prefix;
    }

    /** A number whose unsigned order is the order of the values. */
    private static long key(double value) {
        long bits = Double.doubleToLongBits(value);
        return bits < 0 ? ~bits : bits ^ Long.MIN_VALUE;
    }

    private static double value(long key) {
        return Double.longBitsToDouble(key < 0 ? key ^ Long.MIN_VALUE : ~key);
    }
}
