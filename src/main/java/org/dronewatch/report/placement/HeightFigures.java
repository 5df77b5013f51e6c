package org.dronewatch.report.placement;

import java.util.Comparator;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.analysis.survey.Gap;
import org.dronewatch.analysis.survey.HeightSummary;

/** Figures of a layout at one height, as text; a dash where there is none. */
final class HeightFigures {
    static final String NONE = "-";

    private final HeightSummary height;

    HeightFigures(HeightSummary height) {
        this.height = height;
    }

    /** The percentage of the known cells that is covered. */
    String covered() {
        return share(height.covered());
    }

    /** The percentage that remains covered without the sensor whose loss is worst. */
    String afterWorstLoss() {
        return worstLoss()
                .map(worst -> share(height.covered() - worst.getValue()))
                .orElse(NONE);
    }

    /** The percentage of {@link #afterWorstLoss} with the name of that sensor, unless no loss costs anything. */
    String afterNamedLoss() {
        return afterWorstLoss()
                + worstLoss()
                        .filter(worst -> worst.getValue() > 0)
                        .map(worst -> " (without " + worst.getKey() + ")")
                        .orElse("");
    }

    private Optional<Map.Entry<String, Integer>> worstLoss() {
        return height.lost().entrySet().stream().max(Map.Entry.comparingByValue(Comparator.naturalOrder()));
    }

    /** The area of the largest gap, ha. */
    String largestGap() {
        return PlaceTable.text("%.1f", 1e-4 * height.gap().map(Gap::area).orElse(0.0));
    }

    private String share(int cells) {
        return height.known() == 0 ? NONE : PlaceTable.text("%.1f", 100.0 * cells / height.known());
    }
}
