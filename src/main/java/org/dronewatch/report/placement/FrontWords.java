package org.dronewatch.report.placement;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dronewatch.placement.site.BudgetFront;
import org.dronewatch.placement.site.FrontPoint;
import org.dronewatch.placement.site.SectorGain;
import org.dronewatch.report.CompassPoint;
import org.dronewatch.report.Numbers;

/** What more money buys, in a line for each step. */
final class FrontWords {
    private static final String ROW = "%12s  %12s  %8s  %8s  %s";

    private FrontWords() {}

    /** A table. */
    static List<String> lines(BudgetFront front) {
        List<String> lines = new ArrayList<>();
        lines.add("best layout for each budget:");
        lines.add(text(ROW, "cost", "more", "covered", "at most", "change"));
        double before = 0.0;
        for (FrontPoint point : front.points()) {
            lines.add(text(
                    ROW,
                    Numbers.text(point.cost()),
                    lines.size() == 2 ? "-" : Numbers.text(point.cost() - before),
                    percent(point.layout().value()),
                    percent(point.layout().bound()),
                    change(point)));
            before = point.cost();
        }
        return lines;
    }

    /** {@code radar-2 in place of radio-1; closes the west at 30 to 60 m (12.0 % before, 98.1 % now)}. */
    static String change(FrontPoint point) {
        String change = point.added().isEmpty()
                ? point.removed().isEmpty() ? "no further sensor" : "without " + list(point.removed())
                : list(point.added()) + (point.removed().isEmpty() ? "" : " in place of " + list(point.removed()));
        return change + point.gain().map(gain -> "; " + gained(gain)).orElse("");
    }

    private static String gained(SectorGain gain) {
        String heights = Numbers.text(gain.lowest())
                + (gain.lowest() < gain.highest() ? " to " + Numbers.text(gain.highest()) : "");
        String before = percent(gain.before());
        return (gain.isClosed() ? "closes the gap in the " : "adds most in the ") + CompassPoint.of(gain.bearing())
                + " at " + heights + " m (" + before + " before, " + percent(gain.after()) + " now)";
    }

    /** {@code a, b and c}. */
    static String list(List<String> names) {
        return String.join(", ", names).replaceFirst(", ([^,]+)$", " and $1");
    }

    static String percent(double fraction) {
        return text("%.1f %%", 100.0 * fraction);
    }

    private static String text(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
