package org.dronewatch.report.placement;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleFunction;
import org.dronewatch.placement.site.BudgetFront;
import org.dronewatch.placement.site.FrontPoint;
import org.dronewatch.placement.site.PlacedLayout;
import org.dronewatch.placement.site.TriedBudgets;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.setting.Counted;
import org.dronewatch.setting.PlainText;

/** States what more money buys, with a line for each step. */
final class FrontWords {
    private static final String ABOVE = "> ";

    static final double PERCENT = 100.0;

    /** Fractions from here on are less than all, but round to 100, %. */
    private static final double MOST_ROUNDED = 99.95;

    private static final String ROW = "%12s  %12s  %8s  %11s  %s";

    private final PlaceMeasure measure;
    private final boolean hasConditions;

    /**
     * Words for layouts.
     *
     * @param hasConditions whether layouts must meet any conditions besides the budget
     */
    FrontWords(PlaceMeasure measure, boolean hasConditions) {
        this.measure = measure;
        this.hasConditions = hasConditions;
    }

    /** A table after an empty line, and what was tried besides; no table if there is only one layout. */
    List<String> lines(BudgetFront<? extends PlacedLayout> front) {
        List<String> lines = new ArrayList<>();
        List<? extends FrontPoint<? extends PlacedLayout>> points = front.points();
        if (points.size() < 2) {
            lines.addAll(unanswered(front.tried(), Numbers::text));
            front.stopped().map(TimeStopWords::sentences).ifPresent(lines::add);
            return lines;
        }
        lines.add("");
        lines.add("best layout for each budget, costs in "
                + front.best().plan().present().prices().currency() + measure.purpose() + ":");
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
        lines.addAll(tried(front.tried(), Numbers::text));
        front.stopped().map(TimeStopWords::sentences).ifPresent(lines::add);
        return lines;
    }

    /** What was tried besides the layouts of the table, in sentences, with amounts of money in words. */
    List<String> tried(TriedBudgets tried, DoubleFunction<String> money) {
        List<String> sentences = new ArrayList<>();
        if (!tried.all()) {
            sentences.add(
                    tried.count() == 1
                            ? "Only this budget was tried: a cheaper layout may be a better buy."
                            : Counted.of(tried.count(), "budget")
                                    + " were tried: a better buy may lie between two of them.");
        }
        sentences.addAll(unanswered(tried, money));
        return sentences;
    }

    /** The budgets that are too low for the conditions, and those that may be, in sentences. */
    private List<String> unanswered(TriedBudgets tried, DoubleFunction<String> money) {
        List<String> sentences = new ArrayList<>();
        if (!tried.infeasible().isEmpty()) {
            sentences.add("No layout meets the conditions for "
                    + (tried.infeasible().size() == 1
                            ? "this budget, which was also tried: "
                            : "these budgets, which were also tried: ")
                    + list(tried.infeasible(), money) + ".");
        }
        if (!tried.unknown().isEmpty()) {
            sentences.add("The search ended before it found a layout for "
                    + (tried.unknown().size() == 1 ? "this budget" : "these budgets")
                    + (hasConditions ? ", so it is not known whether one meets the conditions" : "")
                    + ": " + list(tried.unknown(), money) + ".");
        }
        return sentences;
    }

    private static String list(List<Double> budgets, DoubleFunction<String> money) {
        return PlainText.list(budgets.stream().map(money::apply).toList());
    }

    /** {@code radar-2 in place of radio-1; closes the west at 30 to 60 m (12.0 % before, 98.1 % now)}. */
    String change(FrontPoint<? extends PlacedLayout> point) {
        String change = point.added().isEmpty()
                ? point.removed().isEmpty() ? "no further sensor" : "without " + PlainText.list(point.removed())
                : PlainText.list(point.added())
                        + (point.removed().isEmpty() ? "" : " in place of " + PlainText.list(point.removed()));
        return change
                + point.gain()
                        .map(gain -> "; " + measure.gained(gain, isFirst(point)))
                        .orElse("");
    }

    /** Whether all sensors of a layout but those that are kept are new: it is the cheapest. */
    private static boolean isFirst(FrontPoint<? extends PlacedLayout> point) {
        long bought = point.layout().chosen().stream()
                .filter(sensor -> !sensor.candidate().fixed())
                .count();
        return point.removed().isEmpty() && point.added().size() == bought;
    }

    /** What a part of the airspace was worth and is now, in brackets: {@code  (56.5 % before, 93.3 % now)}. */
    static String change(boolean isFirst, String before, String after) {
        return " (" + before + (isFirst ? " without" : " before") + ", " + after + (isFirst ? " with)" : " now)");
    }

    /** A fraction or probability in percent: 100.0 only for all. */
    static String percent(double fraction) {
        if (fraction < 1.0 && PERCENT * fraction >= MOST_ROUNDED) {
            return ABOVE + "99.9 %";
        }
        return PlaceTable.text("%.1f %%", PERCENT * fraction);
    }

    /** Whether a formatted number has no upper limit but 100 %: {@code > 99.9 %}. */
    static boolean isAboveAll(String number) {
        return number.startsWith(ABOVE);
    }

    /**
     * A formatted number as an upper limit that would have to be exceeded: {@code more than 95.8 %}. One that is all
     * but 100 % is rounded up to that.
     */
    static String moreThan(String number) {
        return "more than " + (isAboveAll(number) ? percent(1.0) : number);
    }
}
