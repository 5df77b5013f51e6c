package org.dronewatch.sensor.thermal;

/** The probability that marks in successive frames confirm a spot; each frame marks it with the same probability. */
final class SpotConfirmation {
    /**
     * The greatest number of frames N for which all sequences of marks are followed one by one: there are 2048 of them.
     */
    private static final int LONGEST = 12;

    private SpotConfirmation() {}

    /**
     * The probability that at least M of N successive frames mark a spot in at least one of several successive frames.
     * For N up to 12, the result is exact, since the probabilities of all sequences of the last N - 1 marks are
     * followed. For a greater N, each frame is assumed to depend only on the one before it; the result is then exact
     * for up to two frames, and otherwise too low by at most 0.1.
     *
     * @param windows number of frames in which the spot may be confirmed, 1 or more
     * @param hits M
     * @param frames N
     * @param mark probability that a frame marks the spot, 0 to 1
     */
    static double inOneOf(int windows, int hits, int frames, double mark) {
        return frames <= LONGEST ? bySequences(windows, hits, frames, mark) : byPairs(windows, hits, frames, mark);
    }

    static double bySequences(int windows, int hits, int frames, double mark) {
        int sequences = 1 << frames - 1;
        double[] chance = new double[sequences];
        for (int marks = 0; marks < sequences; marks++) {
            int count = Integer.bitCount(marks);
            chance[marks] = Math.pow(mark, count) * Math.pow(1.0 - mark, frames - 1 - count);
        }
        for (int window = 0; window < windows; window++) {
            double[] next = new double[sequences];
            for (int marks = 0; marks < sequences; marks++) {
                int count = Integer.bitCount(marks);
                int shifted = marks << 1 & sequences - 1;
                if (count + 1 < hits) {
                    next[shifted | 1 & sequences - 1] += chance[marks] * mark;
                }
                if (count < hits) {
                    next[shifted] += chance[marks] * (1.0 - mark);
                }
            }
            chance = next;
        }
        double without = 0.0;
        for (double one : chance) {
            without += one;
        }
        return Math.max(0.0, 1.0 - without);
    }

    /**
     * An estimate from the probabilities that one frame does not confirm the spot, and that two successive frames do
     * not. Two frames share N - 1 marks: they do not confirm it if fewer than M - 1 of these are set, or if M - 1 are
     * and no further one.
     */
    static double byPairs(int windows, int hits, int frames, double mark) {
        double fewer = 0.0;
        for (int i = 0; i < hits - 1; i++) {
            fewer += shared(frames, i, mark);
        }
        double nearly = shared(frames, hits - 1, mark);
        double one = fewer + nearly * (1.0 - mark);
        double two = fewer + nearly * (1.0 - mark) * (1.0 - mark);
        return one > 0.0 ? 1.0 - one * Math.pow(two / one, windows - 1) : 1.0;
    }

    /** The probability that the spot is marked in exactly the given number of N - 1 frames. */
    private static double shared(int frames, int marks, double mark) {
        return PointTargets.combinations(frames - 1, marks)
                * Math.pow(mark, marks)
                * Math.pow(1.0 - mark, frames - 1 - marks);
    }
}
