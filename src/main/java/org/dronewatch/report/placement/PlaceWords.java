package org.dronewatch.report.placement;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronewatch.placement.site.FrontPoint;
import org.dronewatch.placement.site.PlacedLayout;
import org.dronewatch.setting.Counted;

/** The best layout in a few sentences, for decision-makers. */
final class PlaceWords {
    /** A cheaper layout that is worth this fraction of the best is worth a sentence. */
    private static final double NEARLY = 0.98;

    private final PlaceResults results;
    private final PlacedLayout best;
    private final PlaceMeasure measure;

    PlaceWords(PlaceResults results) {
        this.results = results;
        this.best = results.best();
        this.measure = results.measure();
    }

    /** What the layout achieves, how much better any could be, what less money buys, today, and after a loss. */
    String verdict() {
        if (best.chosen().isEmpty()) {
            return new PlaceTable(best, measure).nothing().orElse("No sensor that the budget allows covers anything.");
        }
        List<String> sentences = new ArrayList<>();
        int sensors = best.chosen().size();
        sentences.add("The best layout that was found has " + Counted.of(sensors, "sensor")
                + " for " + amount(best.result().cost()) + " and " + measure.claim(true, best.value())
                + measure.whole() + "; no layout for "
                + amount(best.plan().settings().budget())
                + " can achieve " + FrontWords.moreThan(measure.text(best.bound())) + ".");
        PlaceTable table = new PlaceTable(best, measure);
        table.uncued().ifPresent(sentences::add);
        table.nothing().ifPresent(sentences::add);
        table.byCondition().ifPresent(sentences::add);
        best.present()
                .ifPresent(own -> sentences.add("Today's " + PlaceTable.counted(own) + " "
                        + measure.claim(own.sensors() == 1, own.value()) + table.worse(own) + "."));
        cheaper()
                .ifPresent(point -> sentences.add("The best layout for " + amount(point.cost()) + " "
                        + measure.claim(true, point.layout().value()) + "."));
        table.worstLoss().ifPresent(sentences::add);
        return String.join(" ", sentences);
    }

    /** The cheapest layout that is worth nearly as much; empty if that is the best itself. */
    private Optional<FrontPoint<? extends PlacedLayout>> cheaper() {
        List<? extends FrontPoint<? extends PlacedLayout>> points =
                results.front().points();
        double nearly = NEARLY * measure.plotted(best.value());
        for (FrontPoint<? extends PlacedLayout> point : points.subList(0, points.size() - 1)) {
            if (measure.plotted(point.layout().value()) >= nearly) {
                return Optional.of(point);
            }
        }
        return Optional.empty();
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

    /** An amount with its thousands separated, as in other tables of prices. */
    static String money(double amount) {
        return PlaceTable.text("%,.0f", amount).replace(',', '\u202f');
    }
}
