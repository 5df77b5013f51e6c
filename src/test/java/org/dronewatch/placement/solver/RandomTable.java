package org.dronewatch.placement.solver;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.dronewatch.LongForm;
import org.dronewatch.placement.Candidate;
import org.dronewatch.placement.CandidateColumn;
import org.dronewatch.placement.CandidateTable;

/** Small tables at random. */
final class RandomTable {
    private RandomTable() {}

    /**
     * With values of probabilities in tenths, or integers up to 20, or any; with or without costs, kinds and places.
     */
    static CandidateTable of(SplittableRandom random, boolean isProbability, boolean hasConditions) {
        int size = random.nextInt(1, LongForm.count(10, 13));
        int rows = random.nextInt(1, 13);
        int style = random.nextInt(3);
        double density = random.nextDouble(0.15, 1.0);
        List<Candidate> candidates = new ArrayList<>();
        List<CandidateColumn> columns = new ArrayList<>();
        for (int candidate = 0; candidate < size; candidate++) {
            candidates.add(candidate(candidate, random, hasConditions));
            columns.add(column(rows, density, random, style, isProbability));
        }
        double[] weights = new double[rows];
        double[] undetected = new double[rows];
        for (int row = 0; row < rows; row++) {
            weights[row] = style == 0 ? 1.0 : style == 1 ? random.nextInt(4) : random.nextDouble();
            undetected[row] = style == 2 ? 20.0 * random.nextDouble() : random.nextInt(10, 21);
        }
        return new CandidateTable(candidates, columns, weights, undetected);
    }

    private static Candidate candidate(int number, SplittableRandom random, boolean hasConditions) {
        double cost = random.nextBoolean() ? random.nextInt(6) : random.nextDouble(5.0);
        return hasConditions
                ? new Candidate(
                        "c" + number,
                        cost,
                        "k" + random.nextInt(3),
                        random.nextBoolean() ? "" : "p" + random.nextInt(4),
                        random.nextInt(8) == 0)
                : new Candidate("c" + number, cost);
    }

    private static CandidateColumn column(
            int rows, double density, SplittableRandom random, int style, boolean isProbability) {
        int[] reached = new int[rows];
        double[] values = new double[rows];
        int count = 0;
        for (int row = 0; row < rows; row++) {
            if (random.nextDouble() < density) {
                reached[count] = row;
                values[count++] = value(random, style, isProbability);
            }
        }
        return new CandidateColumn(Arrays.copyOf(reached, count), Arrays.copyOf(values, count));
    }

    private static double value(SplittableRandom random, int style, boolean isProbability) {
        double probability =
                switch (style) {
                    case 0 -> 1.0;
                    case 1 -> random.nextInt(10) / 10.0;
                    default -> random.nextDouble(0.999);
                };
        return isProbability ? Math.min(probability, 0.999) : style == 0 ? random.nextInt(3) : 20.0 * probability;
    }
}
