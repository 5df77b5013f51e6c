package org.dronewatch.report.coverage.table;

import java.util.Collection;
import java.util.Locale;
import org.dronewatch.analysis.survey.RemainingCoverage;
import org.dronewatch.report.file.Numbers;

/** Describes what is lost at one height if some of the sensors are left out. */
public final class LossWords {
    private LossWords() {}

    /**
     * The loss in a sentence: {@code At 30 m, 31.0 % of the known area is covered without 'radar', instead of 43.3 %
     * (-12.3).}
     *
     * @param off the sensors that are left out; may be empty
     */
    public static String sentence(RemainingCoverage remaining, Collection<String> off) {
        double above = remaining.all().field().grid().heights().get(remaining.height());
        String at = "At " + Numbers.text(above) + " m, ";
        if (remaining.known() == 0) {
            return at + "no cell is known.";
        }
        String covered = share(remaining.covered(), remaining);
        if (off.isEmpty()) {
            return at + covered + " of the known area is covered.";
        }
        String names = "'" + String.join("', '", off) + "'";
        String words = remaining.lost() == 0
                ? at + covered + " of the known area is covered, with or without " + names + "."
                : String.format(
                        Locale.ROOT,
                        "%s%s of the known area is covered without %s, instead of %s (%+.1f).",
                        at,
                        share(remaining.remaining(), remaining),
                        names,
                        covered,
                        -100.0 * remaining.lost() / remaining.known());
        return words + (remaining.gained() == 0 ? "" : " " + gained(remaining));
    }

    /** What is lost and gained: without a sensor, another heading of the drone may count. */
    private static String gained(RemainingCoverage remaining) {
        return capital(part(remaining.gone(), remaining)) + " is lost and " + part(remaining.gained(), remaining)
                + " is gained, where a different heading becomes the worst.";
    }

    private static String capital(String words) {
        return words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1);
    }

    private static String share(int cells, RemainingCoverage remaining) {
        return cells == 0 ? "none" : part(cells, remaining);
    }

    private static String part(int cells, RemainingCoverage remaining) {
        return cells == 0 ? "nothing" : CoverageTable.percent(cells, remaining.known()) + " %";
    }
}
