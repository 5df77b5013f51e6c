package org.dronewatch.report.placement;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.dronewatch.analysis.field.HeightSummary;
import org.dronewatch.placement.site.FrontPoint;
import org.dronewatch.placement.site.LayoutFields;
import org.dronewatch.placement.site.SitePlacement;
import org.dronewatch.setting.Counted;

/** The best layout in a few sentences, for those who decide. */
final class PlaceWords {
    /** A cheaper layout that covers this fraction of what the best does is worth a sentence. */
    private static final double NEARLY = 0.98;

    private final PlaceResults results;
    private final SitePlacement best;

    PlaceWords(PlaceResults results) {
        this.results = results;
        this.best = results.best();
    }

    /** What the layout covers, how much better any could be, what less money buys, today, and after a loss. */
    String verdict() {
        if (best.chosen().isEmpty()) {
            return "No sensor that the budget allows covers anything.";
        }
        List<String> sentences = new ArrayList<>();
        int sensors = best.chosen().size();
        sentences.add("The best layout that was found has " + Counted.of(sensors, "sensor")
                + " for "
                + amount(best.result().cost()) + " and covers " + FrontWords.percent(best.value()) + " of the airspace"
                + (best.plan().settings().conditions().fold() > 1
                        ? " with " + best.plan().settings().conditions().fold() + " sensors or more"
                        : "")
                + "; no layout for " + amount(best.plan().settings().budget()) + " can cover more than "
                + FrontWords.percent(best.bound()) + ".");
        best.present()
                .ifPresent(
                        own -> sentences.add("Today's " + Counted.of(own.sensors(), "sensor covers ", "sensors cover ")
                                + FrontWords.percent(own.value()) + "."));
        cheaper()
                .ifPresent(point -> sentences.add("For " + amount(point.cost()) + ", "
                        + FrontWords.percent(point.layout().value()) + " can be covered."));
        PlaceTable.worstLoss(best).ifPresent(sentences::add);
        results.fields().ifPresent(fields -> {
            HeightSummary least = leastCovered(fields);
            sentences.add("With all its sensors, the layout covers least at " + PlaceTable.text("%.0f", least.height())
                    + " m above the ground:"
                    + (best.headings() > 1 ? " on the heading that is worst in each cell, " : " ")
                    + new HeightFigures(least).covered() + " %.");
        });
        return String.join(" ", sentences);
    }

    /** The cheapest layout that covers nearly as much; empty if that is the best itself. */
    private Optional<FrontPoint> cheaper() {
        List<FrontPoint> points = results.front().points();
        return points.stream()
                .filter(point -> point.layout().value() >= NEARLY * best.value())
                .findFirst()
                .filter(point -> point != points.get(points.size() - 1));
    }

    /** The height at which the layout covers the smallest fraction; the lowest among equals. */
    static HeightSummary leastCovered(LayoutFields fields) {
        return fields.layout().heights().stream()
                .min(Comparator.comparingDouble(
                        height -> height.known() == 0 ? 1.0 : (double) height.covered() / height.known()))
                .orElseThrow();
    }

    /** {@code cost [EUR]}. */
    String priced(String name) {
        return name + " [" + currency() + "]";
    }

    private String amount(double cost) {
        return money(cost) + " " + currency();
    }

    private String currency() {
        return best.plan().present().prices().currency();
    }

    /** An amount with its thousands apart, as other tables of prices have it. */
    static String money(double amount) {
        return PlaceTable.text("%,.0f", amount).replace(',', '\u202f');
    }
}
