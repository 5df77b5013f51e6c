package org.dronewatch.report.coverage;

import java.awt.Color;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.report.sheet.ColourMix;
import org.dronewatch.report.sheet.MapSheet;
import org.dronewatch.sensor.Cause;

/**
 * Shows which cells at one height are gained and which are lost from one layout of sensors to another. The colours are
 * those of the map of causes; patterns distinguish gained from lost cells in black and white, and cells that both
 * layouts cover have no pattern.
 */
public final class ChangeMap {
    private static final Color GREEN = new Color(0x009e73);
    private static final Color PALE_GREEN = new Color(0xa8dcc6);
    private static final Color GREY = new Color(0x707070);
    private static final int PERIOD = 8;
    private static final double STRENGTH = 0.6;

    /** What a cell shows. */
    private enum Change {
        BOTH("covered before and after"),
        GAINED("gained"),
        LOST("lost"),
        NEITHER("covered neither before nor after"),
        NOTHING("solid, outside the area or unknown");

        private final String words;

        Change(String words) {
            this.words = words;
        }

        MapSheet.Fill fill() {
            return switch (this) {
                case BOTH -> CauseFills.of(Cause.DETECTED);
                case GAINED ->
                    (u, v, ground) ->
                            (u + v) % PERIOD < 2 ? GREEN.getRGB() : ColourMix.of(ground, PALE_GREEN, STRENGTH);
                case LOST -> CauseFills.LOST;
                case NEITHER -> (u, v, ground) -> ColourMix.of(ground, GREY, STRENGTH);
                case NOTHING -> CauseFills.OUTSIDE;
            };
        }
    }

    private final FieldCoverage before;
    private final FieldCoverage after;
    private final int height;

    /**
     * The map of the height with the given index, from 0 for the lowest.
     *
     * @param before coverage of the first layout
     * @param after coverage of the second layout in the same cells
     */
    public ChangeMap(FieldCoverage before, FieldCoverage after, int height) {
        this.before = before;
        this.after = after;
        this.height = height;
    }

    /** The fill of a cell, given by its column from the west and its row from the north, both from 0. */
    public MapSheet.Fill fill(int column, int row) {
        return at(column, row).fill();
    }

    private Change at(int column, int row) {
        boolean had = before.isCovered(height, column, row);
        boolean has = after.isCovered(height, column, row);
        if (had || has) {
            return had && has ? Change.BOTH : has ? Change.GAINED : Change.LOST;
        }
        boolean isKnown = before.isKnown(height, column, row) || after.isKnown(height, column, row);
        return isKnown ? Change.NEITHER : Change.NOTHING;
    }

    /** Writes a legend entry for each kind of cell that occurs, with its fraction of the known cells. */
    public void writeLegend(MapSheet sheet) {
        Map<Change, Integer> counts = counts();
        int known = counts.entrySet().stream()
                .filter(one -> one.getKey() != Change.NOTHING)
                .mapToInt(Map.Entry::getValue)
                .sum();
        counts.forEach((change, cells) -> sheet.entry(
                change.fill(),
                change == Change.NOTHING
                        ? change.words
                        : String.format(Locale.ROOT, "%s: %.1f %%", change.words, 100.0 * cells / known)));
    }

    /** The change in words: {@code gained in 12.3 % of the known cells, lost in 0.4 %}. */
    public String inWords() {
        Map<Change, Integer> counts = counts();
        int known = 0;
        for (Map.Entry<Change, Integer> one : counts.entrySet()) {
            known += one.getKey() == Change.NOTHING ? 0 : one.getValue();
        }
        List<String> words = new ArrayList<>();
        for (Change change : List.of(Change.GAINED, Change.LOST)) {
            double percent = known == 0 ? 0.0 : 100.0 * counts.getOrDefault(change, 0) / known;
            words.add(String.format(Locale.ROOT, "%s in %.1f %%", change.words, percent));
        }
        return words.get(0) + " of the known cells, " + words.get(1);
    }

    private Map<Change, Integer> counts() {
        Map<Change, Integer> counts = new EnumMap<>(Change.class);
        after.field().grid().forEachCell((column, row) -> counts.merge(at(column, row), 1, Integer::sum));
        return counts;
    }
}
