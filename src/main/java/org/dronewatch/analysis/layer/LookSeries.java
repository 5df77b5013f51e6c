package org.dronewatch.analysis.layer;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import org.dronewatch.sensor.Assessment;

/**
 * The probabilities of a series of looks at a drone that passes through the field of view. Some are assessed,
 * then more wherever two neighbours differ; between neighbours that hardly differ, probabilities are interpolated.
 */
final class LookSeries {
    /** How many looks of a pass through the field of view are assessed, at least; all if there are fewer. */
    private static final int LEAST = 12;

    /** The greatest difference of two probabilities between which those of the looks are interpolated. */
    private static final double CLOSE = 0.02;

    private static final Comparator<Assessment> FAVOUR =
            Comparator.comparingDouble(Assessment::probability).thenComparing(Assessment::cause);

    private final IntFunction<Assessment> looks;
    private final double[] probabilities;
    private Optional<Assessment> best = Optional.empty();

    /**
     * A series.
     *
     * @param passes numbers of the looks at which the drone enters the field of view, from 0 on
     * @param count number of looks
     * @param looks the assessment of each, by its number
     */
    LookSeries(List<Integer> passes, int count, IntFunction<Assessment> looks) {
        this.looks = looks;
        this.probabilities = new double[count];
        for (int i = 0; i < passes.size(); i++) {
            int next = i + 1 < passes.size() ? passes.get(i + 1) : count;
            assess(passes.get(i), next - 1);
        }
    }

    /** The looks of one pass. */
    private void assess(int first, int last) {
        assess(first);
        int before = first;
        for (int i = 1; i < LEAST; i++) {
            int next = first + (int) ((long) (last - first) * i / (LEAST - 1));
            if (next > before) {
                assess(next);
                fill(before, next);
                before = next;
            }
        }
    }

    private void assess(int number) {
        Assessment one = looks.apply(number);
        probabilities[number] = one.probability();
        if (best.isEmpty() || FAVOUR.compare(one, best.get()) > 0) {
            best = Optional.of(one);
        }
    }

    /** The looks between two that have been assessed. */
    private void fill(int from, int to) {
        double change = probabilities[to] - probabilities[from];
        if (to - from > 1 && Math.abs(change) > CLOSE) {
            int middle = (from + to) / 2;
            assess(middle);
            fill(from, middle);
            fill(middle, to);
        } else {
            for (int i = from + 1; i < to; i++) {
                probabilities[i] = probabilities[from] + change * (i - from) / (to - from);
            }
        }
    }

    /** The probability of each look. */
    double[] probabilities() {
        return probabilities;
    }

    /** The most favourable of the assessments: the highest probability, then the cause nearest to a detection. */
    Optional<Assessment> best() {
        return best;
    }
}
