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

    /**
     * What the layout achieves, how much better any other could be, and what is achieved by today's sensors, by a
     * cheaper layout, and by this one after a loss.
     */
    String verdict() {
        if (best.chosen().isEmpty()) {
            return new PlaceTable(best, measure).nothing().orElse("No sensor that the budget allows covers anything.")
                    + today().map(sentence -> " " + sentence).orElse("");
        }
        List<String> sentences = new ArrayList<>();
        int sensors = best.chosen().size();
        String layout = "The best layout that was found has " + Counted.of(sensors, "sensor") + " for "
                + amount(best.result().cost());
        Optional<String> shortfall = results.shortfall();
        if (shortfall.isPresent()) {
            sentences.add(layout + ".");
            sentences.add(shortfall.get());
            sentences.add("By this estimate, " + limit() + "; as flown, another may.");
        } else {
            sentences.add(
                    layout + " and " + measure.claim(true, best.value()) + measure.whole() + "; " + limit() + ".");
        }
        new SilentDrone(best, measure).sentence().ifPresent(sentences::add);
        PlaceTable table = new PlaceTable(best, measure);
        table.uncued().ifPresent(sentences::add);
        table.nothing().ifPresent(sentences::add);
        table.byCondition().ifPresent(sentences::add);
        today().ifPresent(sentences::add);
        cheaper()
                .ifPresent(point -> sentences.add("The best layout for " + amount(point.cost()) + " "
                        + measure.claim(true, point.layout().value()) + "."));
        results.worstLoss().ifPresent(sentences::add);
        return String.join(" ", sentences);
    }

    private Optional<String> today() {
        return new PlaceTable(best, measure).present("Today's ");
    }

    /** What no layout for the budget can achieve. */
    private String limit() {
        String budget = amount(best.plan().settings().budget());
        return measure.text(best.bound()).equals(measure.text(best.value()))
                        && FrontWords.isAboveAll(measure.text(best.bound()))
                ? "no layout for " + budget + " achieves noticeably more"
                : "no layout for " + budget + " can achieve " + FrontWords.moreThan(measure.text(best.bound()));
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
