package org.dronewatch.report.placement;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.dronewatch.geometry.Position;
import org.dronewatch.placement.Candidate;
import org.dronewatch.placement.plan.Cues;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.plan.SiteCandidate;
import org.dronewatch.placement.site.PlaceStep;
import org.dronewatch.placement.site.PlacedLayout;
import org.dronewatch.placement.site.PresentLayout;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.sensor.Aimed;
import org.dronewatch.setting.Counted;
import org.dronewatch.setting.PlainText;

/** The best layout as a table, in the order in which its sensors are best bought. */
final class PlaceTable {
    private static final String ROW = "%-24s  %-8s  %24s  %7s  %10s  %10s  %7s  %8s";
    private static final String NONE = "-";
    private static final double FULL_TURN = 360.0;

    private final PlacedLayout layout;
    private final PlaceMeasure measure;

    PlaceTable(PlacedLayout layout, PlaceMeasure measure) {
        this.layout = layout;
        this.measure = measure;
    }

    /** A heading and a line for each sensor. */
    List<String> lines() {
        List<String> lines = new ArrayList<>();
        lines.add("best layout from " + candidates()
                + " for a budget of " + amount(layout.plan().settings().budget(), layout.plan()) + measure.purpose()
                + ", in order of purchase:");
        lines.add(text(ROW, "sensor", "kind", "position [m]", "azimuth", "cost", "sum", "alone", "together"));
        for (SiteCandidate sensor : unordered()) {
            lines.add(row(sensor, sensor.candidate().fixed() ? "kept" : cost(sensor), NONE, NONE));
        }
        for (PlaceStep step : layout.purchases()) {
            SiteCandidate sensor = added(step, layout);
            lines.add(row(sensor, cost(sensor), Numbers.text(step.cost()), measure.text(step.value())));
        }
        return lines;
    }

    /** {@code 8 candidates}, or {@code the first 5 of 8 candidates} after an interruption. */
    String candidates() {
        String all = Counted.of(layout.plan().candidates().size(), "candidate");
        return layout.assessed() < layout.plan().candidates().size()
                ? "the first " + layout.assessed() + " of " + all
                : all;
    }

    /** The sensors that are kept, or all if the order in which to buy them is not known. */
    private List<SiteCandidate> unordered() {
        boolean isOrdered = !layout.purchases().isEmpty();
        return layout.chosen().stream()
                .filter(sensor -> !isOrdered || sensor.candidate().fixed())
                .toList();
    }

    /** The sensor that is bought in a step. */
    static SiteCandidate added(PlaceStep step, PlacedLayout layout) {
        return layout.chosen().stream()
                .filter(one -> one.name().equals(step.added()))
                .findFirst()
                .orElseThrow();
    }

    /** That no purchase gains anything, in a sentence; empty if one does, or there is no money. */
    Optional<String> nothing() {
        boolean isBought =
                layout.chosen().stream().anyMatch(sensor -> !sensor.candidate().fixed());
        return isBought || layout.plan().settings().budget() == 0.0
                ? Optional.empty()
                : Optional.of(unaffordable().orElseGet(this::useless));
    }

    /** That no layout gains anything, in a sentence that names the fold as a likely cause. */
    private String useless() {
        if (!layout.complete()) {
            return "So far, no layout has been found that improves on buying nothing: nothing is bought.";
        }
        int fold = layout.plan().settings().conditions().fold();
        boolean isProven = layout.bound() <= layout.value();
        return "Buying nothing would do as well: "
                + (fold > 1 ? "since conditions.fold requires " + fold + " sensors, " : "")
                + "no layout within the budget "
                + (isProven && fold > 1 ? "improves on that." : "was found that improves on that.");
    }

    /** Until which purchase nothing is gained, in a sentence; empty if the first one gains something. */
    Optional<String> late() {
        String none = measure.text(0.0);
        List<PlaceStep> steps = layout.purchases();
        List<PlaceStep> idle = steps.stream()
                .takeWhile(step -> measure.text(step.value()).equals(none))
                .toList();
        return idle.isEmpty() || idle.size() == steps.size()
                ? Optional.empty()
                : Optional.of(
                        (idle.size() == 1 ? "The first purchase gains" : "The first " + idle.size() + " purchases gain")
                                + " nothing until " + steps.get(idle.size()).added() + " is bought as well.");
    }

    /** Until which purchase the sensors do not comply with the conditions, in a sentence; empty if they always do. */
    Optional<String> early() {
        return layout.early().map(early -> {
            List<String> reasons = new ArrayList<>();
            early.afterLoss()
                    .ifPresent(value -> reasons.add("after the worst loss, " + measure.text(value) + " remains"));
            if (!early.uncued().isEmpty()) {
                reasons.add("nothing cues " + PlainText.list(early.uncued()));
            }
            return (early.count() == 1
                            ? "The first purchase alone does"
                            : "The first " + early.count() + " purchases alone do")
                    + " not meet the conditions"
                    + (reasons.isEmpty() ? "." : " (" + String.join("; ", reasons) + ").");
        });
    }

    /** What the sensors that cue others are worth, in a sentence; empty if no sensor counts as turned to the drone. */
    private Optional<String> cued() {
        Cues.Cueing cues = new Cues(layout.plan()).cueing(layout.chosen());
        OptionalDouble worth = layout.together(cues.cueing());
        boolean isOne = cues.cueing().size() == 1;
        return cues.turning().isEmpty() || worth.isEmpty()
                ? Optional.empty()
                : Optional.of("The figures assume that " + PlainText.list(cues.turning())
                        + (cues.turning().size() == 1 ? " has" : " have")
                        + " turned to the drone, wherever it is; on "
                        + (isOne ? "its own, the sensor that cues " : "their own, the sensors that cue ")
                        + (cues.turning().size() == 1 ? "it " : "them ") + measure.claim(isOne, worth.getAsDouble())
                        + ".");
    }

    /**
     * That kept sensors count as turned to the drone though nothing cues them, in a sentence; otherwise what the
     * sensors that cue others are worth.
     */
    Optional<String> uncued() {
        List<String> uncued = new Cues(layout.plan()).uncued(layout.chosen());
        Map<String, Double> without = layout.withoutEach();
        return uncued.isEmpty()
                ? cued()
                : Optional.of("Nothing in the layout cues " + PlainText.list(uncued)
                        + ", though the figures assume that "
                        + (uncued.size() == 1 ? "it has" : "they have") + " turned to the drone"
                        + uncued.stream()
                                .filter(without::containsKey)
                                .map(name ->
                                        "; without " + name + ", the layout " + measure.claim(true, without.get(name)))
                                .collect(Collectors.joining())
                        + ".");
    }

    /** That even the cheapest sensor costs more than the budget, in a sentence; empty if it does not. */
    private Optional<String> unaffordable() {
        double budget = layout.plan().settings().budget();
        return layout.plan().candidates().stream()
                .map(SiteCandidate::candidate)
                .filter(one -> !one.fixed())
                .min(Comparator.comparingDouble(Candidate::cost))
                .filter(cheapest -> cheapest.cost() > budget)
                .map(cheapest -> "No sensor is affordable: the cheapest, " + cheapest.name() + ", costs "
                        + amount(cheapest.cost(), layout.plan()) + ", and the budget is "
                        + amount(budget, layout.plan()) + ".");
    }

    /** An amount with the currency of the scene's prices: {@code 150000 EUR}. */
    static String amount(double amount, PlacePlan plan) {
        return Numbers.text(amount) + " " + plan.present().prices().currency();
    }

    /** What the scene's own sensors achieve, in a sentence; empty if it has none. */
    Optional<String> present() {
        return present("The scene's own ");
    }

    /**
     * What the scene's own sensors achieve, in a sentence that begins with given words that state whose sensors they
     * are.
     */
    Optional<String> present(String whose) {
        return layout.present()
                .map(own -> whose + counted(own) + " " + measure.claim(own.sensors() == 1, own.value())
                        + measure.headingsClause() + worse(own) + ".");
    }

    /** That a layout is worse than the scene's own sensors, as the end of a sentence on these; or an empty text. */
    private String worse(PresentLayout own) {
        return own.value() > layout.value() && !measure.text(own.value()).equals(measure.text(layout.value()))
                ? ", which is better than this layout: sensors of the scene that 'keep' does not name are not part of it"
                : "";
    }

    /** What the layout achieves under each condition, in sentences; empty without conditions. */
    Optional<String> byCondition() {
        Map<String, Double> values = layout.byCondition();
        if (values.isEmpty()) {
            return Optional.empty();
        }
        StringBuilder text =
                new StringBuilder("In the scene as it is, the layout ").append(measure.claim(true, layout.asItIs()));
        values.forEach((name, value) -> text.append("; under the condition '")
                .append(name)
                .append("', ")
                .append(measure.text(value)));
        return Optional.of(text.append(". What counts is the lowest of these.").toString());
    }

    /** {@code 4 sensors}, or {@code sensor} for a single one, after a possessive. */
    static String counted(PresentLayout own) {
        return own.sensors() == 1 ? "sensor" : Counted.of(own.sensors(), "sensor");
    }

    /** What remains without the sensor whose loss is worst, in a sentence; empty if it is not known. */
    Optional<String> worstLoss() {
        return layout.withoutEach().entrySet().stream()
                .min(Map.Entry.comparingByValue())
                .map(worst -> "Without " + worst.getKey() + ", whose loss is worst, the layout "
                        + measure.claim(true, worst.getValue()) + measure.headingsClause() + "." + uncuedWithout());
    }

    /** Which losses leave other sensors without a cue, in sentences that follow another one; or an empty text. */
    private String uncuedWithout() {
        return new Cues(layout.plan())
                .uncuedWithout(layout.chosen()).entrySet().stream()
                        .map(loss -> " Without " + loss.getKey() + ", nothing cues "
                                + PlainText.list(loss.getValue()) + ", "
                                + (loss.getValue().size() == 1 ? "which then counts" : "which then count")
                                + " as detecting nothing.")
                        .collect(Collectors.joining());
    }

    private String row(SiteCandidate sensor, String cost, String sum, String value) {
        return text(
                ROW,
                sensor.name(),
                sensor.sensor().kind(),
                position(sensor),
                azimuthInWords(sensor),
                cost,
                sum,
                alone(sensor),
                value);
    }

    private static String cost(SiteCandidate sensor) {
        return Numbers.text(sensor.candidate().cost());
    }

    /** The value of a sensor by itself; a dash if it is not known. */
    String alone(SiteCandidate sensor) {
        OptionalDouble alone = layout.alone(sensor);
        return alone.isPresent() ? measure.text(alone.getAsDouble()) : NONE;
    }

    /** The direction in which a sensor is aimed: {@code 90°}; a dash if it has no aim. */
    static String azimuthInWords(SiteCandidate sensor) {
        OptionalDouble azimuth = azimuth(sensor);
        return azimuth.isPresent() ? text("%.0f°", azimuth.getAsDouble()) : NONE;
    }

    /** The direction in which a sensor is aimed, clockwise from north, deg; empty if it has none that matters. */
    static OptionalDouble azimuth(SiteCandidate sensor) {
        return sensor.sensor()
                .as(Aimed.class)
                .filter(Aimed::isDirectional)
                .map(aimed -> aimed.aim().from(sensor.sensor().position()))
                .map(forward -> OptionalDouble.of(
                        (Math.toDegrees(StrictMath.atan2(forward.x(), forward.y())) + FULL_TURN) % FULL_TURN))
                .orElse(OptionalDouble.empty());
    }

    /** Where a sensor is, m. */
    static String position(SiteCandidate sensor) {
        Position position = sensor.sensor().position();
        return text("%.1f, %.1f, %.1f", position.x(), position.y(), position.z());
    }

    static String text(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
