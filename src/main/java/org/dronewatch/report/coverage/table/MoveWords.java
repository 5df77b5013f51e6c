package org.dronewatch.report.coverage.table;

import java.util.Collection;
import java.util.Locale;
import org.dronewatch.analysis.survey.RemainingCoverage;
import org.dronewatch.report.file.Numbers;

/** Describes what is covered at one height while sensors are moved. */
public final class MoveWords {
    /** How much of a picture has been assessed. */
    public enum Fineness {
        /** One cell in each block of cells. */
        COARSE("coarse", " This is a coarse picture; finer ones follow."),
        /** All cells along the borders of what is covered. */
        FINE("fine", " Cells along the borders of what is covered are exact; the rest will follow."),
        /** All cells. */
        COMPLETE("complete", "");

        private final String word;
        private final String words;

        Fineness(String word, String words) {
            this.word = word;
            this.words = words;
        }

        /** The name of this fineness, in one word. */
        public String word() {
            return word;
        }
    }

    private MoveWords() {}

    /**
     * States what is covered now and what was covered before: {@code At 30 m, 45.1 % of the known area is covered;
     * before 'radar' was moved, it was 43.3 % (+1.8).}
     *
     * @param before the coverage before the move, at the same height
     * @param now the coverage after the move
     * @param off the sensors that are left out both before and now; may be empty
     * @param moved the sensors that were moved
     * @param reduced the moved sensors for which only signals along deterministic paths count
     */
    public static String sentence(
            RemainingCoverage before,
            RemainingCoverage now,
            Collection<String> off,
            Collection<String> moved,
            Fineness fineness,
            Collection<String> reduced) {
        double above = now.all().field().grid().heights().get(now.height());
        String at = "At " + Numbers.text(above) + " m, ";
        if (now.known() == 0 || before.known() == 0) {
            return at + "no cell is known.";
        }
        double change = 100.0 * now.remaining() / now.known() - 100.0 * before.remaining() / before.known();
        return at
                + share(now) + " of the known area is covered"
                + (off.isEmpty() ? "" : " without " + names(off))
                + "; before " + names(moved) + (moved.size() == 1 ? " was" : " were") + " moved, it was "
                + (before.remaining() == 0 ? "0 %" : share(before))
                + String.format(Locale.ROOT, " (%+.1f).", change)
                + fineness.words
                + (reduced.isEmpty() ? "" : reduction(reduced));
    }

    private static String share(RemainingCoverage of) {
        return of.remaining() == 0 ? "none" : CoverageTable.percent(of.remaining(), of.known()) + " %";
    }

    private static String reduction(Collection<String> reduced) {
        return " At " + names(reduced)
                + ", only direct, reflected and diffracted sound counts, not reverberation: 'Compute' takes all sound"
                + " into account.";
    }

    private static String names(Collection<String> names) {
        return "'" + String.join("', '", names) + "'";
    }
}
