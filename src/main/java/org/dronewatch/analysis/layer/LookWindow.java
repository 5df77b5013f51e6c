package org.dronewatch.analysis.layer;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.SensorSettings;

/**
 * The looks that a sensor takes within a window of time while it searches. The search is periodic, and the window may
 * begin at any phase of it. The phase of the first look determines those of all others: in a window shorter than the
 * period, a sensor that turns may never point at the drone. Immutable.
 */
public final class LookWindow {
    /** Observers whose required probabilities differ by less than this are treated as one. */
    private static final double ALIKE = 0.001;

    private final SensorSettings<?> sensor;

    /** The number of phases, evenly spaced over one period. */
    private final int phases;

    /** The phases that looks meet, counted from that of the first one, and how many looks meet each of them. */
    private final int[] offsets;

    private final int[] counts;

    private LookWindow(SensorSettings<?> sensor, long[] looks) {
        this.sensor = sensor;
        this.phases = looks.length;
        this.offsets = IntStream.range(0, phases).filter(i -> looks[i] > 0).toArray();
        this.counts = IntStream.of(offsets).map(i -> Math.toIntExact(looks[i])).toArray();
    }

    /**
     * The looks of a sensor; empty if the terms are those of a single look, or the time is too short for a look.
     *
     * @param period period of the sensor's search, s
     * @param phases the number of phases into which the period is divided
     */
    public static Optional<LookWindow> of(FieldTerms terms, SensorSettings<?> sensor, double period, int phases) {
        long number = terms.looks(sensor);
        if (terms.within().isEmpty() || number == 0) {
            return Optional.empty();
        }
        long[] looks = new long[phases];
        for (long look = 0; look < number; look++) {
            double turns = look / (sensor.rate() * period);
            looks[(int) ((long) Math.rint(phases * (turns - Math.floor(turns))) % phases)]++;
        }
        return Optional.of(new LookWindow(sensor, looks));
    }

    /**
     * The probability that the sensor detects a drone within the window, which may begin at each of the phases with
     * equal probability: the mean, over the phases, of 1 minus the probability that all looks in a window that begins
     * there miss the drone. Where chance decides once per encounter, an observer searches throughout these looks.
     *
     * @param looks the probabilities of the looks in some phases, 0 to 1; in the others the probability is 0
     * @param at the indices of these phases
     * @return the probability, 0 to 1; 0 or 1 only where this is exact
     */
    public double probability(double[] looks, List<Integer> at) {
        boolean isSeen = false;
        boolean isCertain = false;
        for (double look : looks) {
            isSeen |= look > 0.0;
            isCertain |= look >= 1.0;
        }
        if (!isSeen) {
            return 0.0;
        }
        double detected;
        if (sensor.chance() == Chance.PER_ENCOUNTER) {
            detected = ofObservers(looks, at);
        } else {
            boolean isMet = isCertain && offsets.length == phases;
            detected = isMet ? 1.0 : ofLooks(looks, at);
        }
        return Math.max(Double.MIN_VALUE, detected);
    }

    private double ofLooks(double[] looks, List<Integer> at) {
        double[] hazards = new double[phases];
        for (int i = 0; i < looks.length; i++) {
            if (looks[i] > 0.0) {
                add(hazards, at.get(i), looks[i] < 1.0 ? -StrictMath.log1p(-looks[i]) : Double.POSITIVE_INFINITY);
            }
        }
        double detected = mean(hazards);
        boolean isCertain = true;
        for (double hazard : hazards) {
            isCertain &= hazard == Double.POSITIVE_INFINITY;
        }
        return isCertain ? 1.0 : Math.min(Math.nextDown(1.0), detected);
    }

    /** The mean over observers, who can use only looks with at least the probability that they need. */
    private double ofObservers(double[] looks, List<Integer> at) {
        int[] order = IntStream.range(0, looks.length)
                .boxed()
                .sorted(Comparator.comparingDouble(i -> -looks[i]))
                .mapToInt(Integer::intValue)
                .toArray();
        double[] hazards = new double[phases];
        double detected = 0.0;
        double from = looks[order[0]];
        // Begins with the observers who need the highest probability: those who need less can use the other looks, too.
        for (int i = 0; i < order.length && looks[order[i]] > 0.0; i++) {
            double look = looks[order[i]];
            add(hazards, at.get(order[i]), sensor.chance().hazard(look, sensor.rate(), look) / sensor.rate());
            double next = i + 1 < order.length ? looks[order[i + 1]] : 0.0;
            if (next <= 0.0 || from - next > ALIKE) {
                detected += (from - next) * mean(hazards);
                from = next;
            }
        }
        return detected;
    }

    /** Adds the hazard of a phase to all windows whose looks meet it, by the phase at which they begin. */
    private void add(double[] hazards, int phase, double hazard) {
        for (int i = 0; i < offsets.length; i++) {
            int begin = phase - offsets[i];
            hazards[begin < 0 ? begin + phases : begin] += counts[i] * hazard;
        }
    }

    /** The mean probability of a detection in the windows. */
    private static double mean(double[] hazards) {
        double sum = 0.0;
        for (double hazard : hazards) {
            if (hazard > 0.0) {
                sum -= StrictMath.expm1(-hazard);
            }
        }
        return sum / hazards.length;
    }
}
