package org.dronewatch.report.placement;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.placement.site.FrontPoint;
import org.dronewatch.placement.site.PlacedLayout;
import org.dronewatch.report.file.Numbers;

/** What more money buys, in a line for each step. */
final class FrontWords {
    private static final String ABOVE = "> ";

    static final double PERCENT = 100.0;

    /** Fractions from here on are less than all, but round to 100, %. */
    private static final double MOST_ROUNDED = 99.95;

    private static final String ROW = "%12s  %12s  %8s  %11s  %s";

    private final PlaceMeasure measure;

    FrontWords(PlaceMeasure measure) {
        this.measure = measure;
    }

    /** A table after an empty line; nothing if there is only one layout. */
    List<String> lines(List<? extends FrontPoint<? extends PlacedLayout>> points) {
        List<String> lines = new ArrayList<>();
        if (points.size() < 2) {
            return lines;
        }
        lines.add("");
        lines.add("best layout for each budget:");
        lines.add(PlaceTable.text(ROW, "cost", "added cost", measure.heading(), "upper bound", "change"));
        double before = Double.NaN;
        for (FrontPoint<? extends PlacedLayout> point : points) {
            lines.add(PlaceTable.text(
                    ROW,
                    Numbers.text(point.cost()),
                    Double.isNaN(before) ? "-" : Numbers.text(point.cost() - before),
                    measure.text(point.layout().value()),
                    measure.text(point.layout().bound()),
                    change(point)));
            before = point.cost();
        }
        return lines;
    }

    /** {@code radar-2 in place of radio-1; closes the west at 30 to 60 m (12.0 % before, 98.1 % now)}. */
    String change(FrontPoint<? extends PlacedLayout> point) {
        String change = point.added().isEmpty()
                ? point.removed().isEmpty() ? "no further sensor" : "without " + list(point.removed())
                : list(point.added()) + (point.removed().isEmpty() ? "" : " in place of " + list(point.removed()));
        return change + point.gain().map(gain -> "; " + measure.gained(gain)).orElse("");
    }

    /** {@code a, b and c}. */
    static String list(List<String> names) {
        return String.join(", ", names).replaceFirst(", ([^,]+)$", " and $1");
    }

    /** A fraction or probability in percent: 100.0 for all alone. */
    static String percent(double fraction) {
        if (fraction < 1.0 && PERCENT * fraction >= MOST_ROUNDED) {
            return ABOVE + "99.9 %";
        }
        return PlaceTable.text("%.1f %%", PERCENT * fraction);
    }

    /** A formatted number as an upper limit that would have to be exceeded: {@code more than 99.9 %}. */
    static String moreThan(String number) {
        return "more than " + (number.startsWith(ABOVE) ? number.substring(ABOVE.length()) : number);
    }
}
