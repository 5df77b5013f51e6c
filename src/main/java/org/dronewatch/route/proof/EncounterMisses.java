package org.dronewatch.route.proof;

import java.util.Arrays;
import java.util.List;
import org.dronewatch.sensor.Encounter;

/**
 * The probability that an observer has not detected a drone in an encounter yet, look by look: the mean over the number
 * u that the observer draws, from 0 to 1, of the probability that the search fails in all looks with {@code p >= u}.
 * Between two neighbouring probabilities of the looks, it is the same for all u. These intervals are the leaves of a
 * tree of sums, in which a look multiplies all that are below its probability: n looks take {@code n log n} steps.
 */
final class EncounterMisses {
    private final double rate;

    /** The probabilities of the looks, each once, ascending. */
    private final double[] probabilities;

    /** The number of leaves, a power of two; the leaves are the nodes from this number on, the root is node 1. */
    private final int leaves;

    /** By node, the sum over the intervals below it of their width times the probability of a miss. */
    private final double[] sums;

    /**
     * By node, the factor by which all of its intervals have been multiplied; already included in the node's own sum.
     */
    private final double[] factors;

    /** The highest probability so far of a look after the route has begun. */
    private double highest;

    /**
     * An encounter before its first look.
     *
     * @param looks looks of the encounter, in order of time
     * @param rate looks per second of the sensor, Hz
     */
    EncounterMisses(List<ScheduledLook> looks, double rate) {
        this.rate = rate;
        this.probabilities = looks.stream()
                .mapToDouble(ScheduledLook::probability)
                .sorted()
                .distinct()
                .toArray();
        int above = probabilities.length;
        this.leaves = Math.max(2, 2 * Integer.highestOneBit(above));
        this.sums = new double[2 * leaves];
        this.factors = new double[leaves];
        Arrays.fill(factors, 1.0);
        double below = 0.0;
        for (int i = 0; i < above; i++) {
            sums[leaves + i] = probabilities[i] - below;
            below = probabilities[i];
        }
        sums[leaves + above] = 1.0 - below;
        for (int node = leaves - 1; node > 0; node--) {
            sums[node] = sums[2 * node] + sums[2 * node + 1];
        }
    }

    /**
     * Takes the next look.
     *
     * @return the probability that neither it nor any before it has detected the drone
     */
    double after(ScheduledLook look) {
        take(look);
        highest = Math.max(highest, look.probability());
        return 1.0 - highest + upTo(highest);
    }

    /**
     * Takes a look at the drone before its route begins. An observer who finds it at this time detects it in the first
     * look after the route has begun in which that observer could.
     */
    void takeBefore(ScheduledLook look) {
        take(look);
    }

    /** The sum over all u up to the probability of a look. */
    private double upTo(double probability) {
        int leaf = leaves + Arrays.binarySearch(probabilities, probability);
        int levels = Integer.numberOfTrailingZeros(leaves);
        double sum = 0.0;
        double factor = 1.0;
        for (int level = levels; level > 0; level--) {
            int node = leaf >> level;
            factor *= factors[node];
            if ((leaf >> level - 1) % 2 != 0) {
                sum += factor * sums[2 * node];
            }
        }
        return sum + factor * sums[leaf];
    }

    private void take(ScheduledLook look) {
        // Nobody has searched before the run begins.
        double searched = Math.min(1.0 / rate, look.time());
        double missed = Math.exp(-look.probability() * searched / Encounter.SEARCH_TIME);
        int node = leaves + Arrays.binarySearch(probabilities, look.probability());
        sums[node] *= missed;
        while (node > 1) {
            int parent = node / 2;
            if (node % 2 != 0) {
                multiply(node - 1, missed);
            }
            sums[parent] = factors[parent] * (sums[2 * parent] + sums[2 * parent + 1]);
            node = parent;
        }
    }

    private void multiply(int node, double factor) {
        sums[node] *= factor;
        if (node < leaves) {
            factors[node] *= factor;
        }
    }
}
