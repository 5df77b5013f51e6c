package org.dronewatch.fuzz;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;

/**
 * Makes a failing case smaller: takes lines of its files and overrides of its command line away while it still fails.
 */
final class Shrinker {
    private static final int MOST_LINES = 200_000;

    private final Predicate<FuzzCase> stillFails;
    private final long deadline;

    /**
     * A shrinker.
     *
     * @param stillFails whether a smaller case fails in the same way
     * @param deadline when to stop, in nanoseconds of {@link System#nanoTime()}
     */
    Shrinker(Predicate<FuzzCase> stillFails, long deadline) {
        this.stillFails = stillFails;
        this.deadline = deadline;
    }

    /** The smallest case found. */
    FuzzCase shrink(FuzzCase input) {
        FuzzCase smaller = shrinkOverrides(input);
        for (String file : input.files().keySet()) {
            smaller = shrinkFile(smaller, file);
        }
        return smaller;
    }

    private FuzzCase shrinkOverrides(FuzzCase input) {
        FuzzCase best = input;
        for (int i = best.arguments().size() - 2; i >= 0; i--) {
            if (best.arguments().get(i).equals("--set")) {
                List<String> fewer = new ArrayList<>(best.arguments());
                fewer.remove(i);
                fewer.remove(i);
                best = better(best, best.withArguments(fewer));
            }
        }
        return best;
    }

    private FuzzCase shrinkFile(FuzzCase input, String file) {
        String text = new String(input.files().get(file), StandardCharsets.ISO_8859_1);
        List<String> lines = List.of(text.split("(?<=\n)", -1));
        if (lines.size() > MOST_LINES) {
            return input;
        }
        FuzzCase best = input;
        for (int piece = Math.max(1, lines.size() / 2); piece >= 1; piece /= 2) {
            for (int from = 0; from < lines.size() && !isLate(); ) {
                List<String> fewer = new ArrayList<>(lines.subList(0, from));
                fewer.addAll(lines.subList(Math.min(lines.size(), from + piece), lines.size()));
                FuzzCase smaller = best.with(file, String.join("", fewer).getBytes(StandardCharsets.ISO_8859_1));
                if (better(best, smaller) == smaller) {
                    best = smaller;
                    lines = fewer;
                } else {
                    from += piece;
                }
            }
        }
        return best;
    }

    private FuzzCase better(FuzzCase best, FuzzCase smaller) {
        return !isLate() && stillFails.test(smaller) ? smaller : best;
    }

    private boolean isLate() {
        return System.nanoTime() > deadline;
    }
}
