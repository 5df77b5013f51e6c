package org.dronewatch.report.placement;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.analysis.field.FieldHeading;
import org.dronewatch.geometry.Position;
import org.dronewatch.placement.site.LayoutFields;
import org.dronewatch.placement.site.PlaceStep;
import org.dronewatch.placement.site.SiteCandidate;
import org.dronewatch.placement.site.SitePlacement;
import org.dronewatch.report.Numbers;
import org.dronewatch.sensor.Aimed;
import org.dronewatch.setting.Counted;

/** The best layout as tables and in words. */
public final class PlaceTable {
    private static final String ROW = "%-24s  %-8s  %24s  %7s  %10s  %10s  %7s  %8s";
    private static final double FULL_TURN = 360.0;

    private PlaceTable() {}

    /**
     * The sensors in the order in which they are best bought, the coverage in words, what each step of the budget buys,
     * and the coverage at each height beside that of the scene's own sensors.
     */
    public static List<String> lines(PlaceResults results) {
        SitePlacement best = results.best();
        List<String> lines = new ArrayList<>(sensors(best));
        lines.add("");
        lines.addAll(sentences(results));
        if (results.front().points().size() > 1) {
            lines.add("");
            lines.addAll(FrontWords.lines(results.front()));
        }
        results.fields().ifPresent(fields -> {
            lines.add("");
            lines.addAll(FieldsTable.lines(fields, best));
        });
        return lines;
    }

    private static List<String> sensors(SitePlacement placement) {
        List<String> lines = new ArrayList<>();
        lines.add("best layout from " + Counted.of(placement.plan().candidates().size(), "candidate")
                + " for a budget of " + Numbers.text(placement.plan().settings().budget())
                + ", in the order in which to buy:");
        lines.add(text(ROW, "sensor", "kind", "position [m]", "azimuth", "cost", "sum", "alone", "together"));
        placement.chosen().stream()
                .filter(sensor -> sensor.candidate().fixed())
                .forEach(sensor -> lines.add(row(sensor, "kept", "-", placement, "-")));
        for (PlaceStep step : placement.purchases()) {
            lines.add(row(
                    added(step, placement),
                    Numbers.text(added(step, placement).candidate().cost()),
                    Numbers.text(step.cost()),
                    placement,
                    FrontWords.percent(step.value())));
        }
        return lines;
    }

    /** The sensor that is bought in a step. */
    static SiteCandidate added(PlaceStep step, SitePlacement placement) {
        return placement.chosen().stream()
                .filter(one -> one.name().equals(step.added()))
                .findFirst()
                .orElseThrow();
    }

    /** What the layout covers, compared with the best possible, with today's sensors, and after a loss. */
    static List<String> sentences(PlaceResults results) {
        SitePlacement placement = results.best();
        List<String> lines = new ArrayList<>(List.of(worth(placement)));
        byCondition(placement).ifPresent(lines::add);
        results.fields().ifPresent(fields -> lines.add(together(fields, placement)));
        placement
                .present()
                .ifPresent(own ->
                        lines.add("The scene's own " + Counted.of(own.sensors(), "sensor covers ", "sensors cover ")
                                + FrontWords.percent(own.value())
                                + "."));
        worstLoss(placement).ifPresent(lines::add);
        return lines;
    }

    /** What the layout covers under each condition; empty without conditions. */
    private static Optional<String> byCondition(SitePlacement placement) {
        Map<String, Double> fractions = placement.byCondition();
        if (fractions.isEmpty()) {
            return Optional.empty();
        }
        StringBuilder text =
                new StringBuilder("In the scene as it is, it covers ").append(FrontWords.percent(placement.asItIs()));
        fractions.forEach((name, fraction) -> text.append("; under the condition '")
                .append(name)
                .append("', ")
                .append(FrontWords.percent(fraction)));
        return Optional.of(text.append(". The least of these counts.").toString());
    }

    private static String together(LayoutFields fields, SitePlacement placement) {
        if (fields.heading() == FieldHeading.INBOUND) {
            return "All figures are for flight towards the protected zone.";
        }
        int fold = placement.plan().settings().conditions().fold();
        return "On the heading that is worst in each cell, the layout covers "
                + FrontWords.percent(LayoutFields.share(fields.layout(), fold)) + " of the known cells.";
    }

    /** What remains without the sensor whose loss is worst; empty without a sensor. */
    static Optional<String> worstLoss(SitePlacement placement) {
        return placement.withoutEach().entrySet().stream()
                .min(Map.Entry.comparingByValue())
                .map(worst -> "Without " + worst.getKey() + ", whose loss is worst, the layout covers "
                        + FrontWords.percent(worst.getValue()) + ".");
    }

    private static String worth(SitePlacement placement) {
        int fold = placement.plan().settings().conditions().fold();
        String covered = "The layout covers " + FrontWords.percent(placement.value()) + " of the airspace"
                + (fold > 1 ? " with " + fold + " sensors or more" : "") + " ("
                + Counted.of(placement.cells(), "cell")
                + (placement.headings() > 1 ? ", " + placement.headings() + " headings)" : ")") + " for "
                + Numbers.text(placement.result().cost());
        boolean isBest = placement.value() == placement.bound();
        return covered
                + (isBest
                        ? "; no layout within the budget covers more."
                        : "; no layout within the budget covers more than " + FrontWords.percent(placement.bound())
                                + ".");
    }

    private static String row(SiteCandidate sensor, String cost, String sum, SitePlacement placement, String value) {
        OptionalDouble azimuth = azimuth(sensor);
        return text(
                ROW,
                sensor.name(),
                sensor.sensor().kind(),
                position(sensor),
                azimuth.isPresent() ? text("%.0f°", azimuth.getAsDouble()) : "-",
                cost,
                sum,
                FrontWords.percent(placement.alone(sensor)),
                value);
    }

    /** The direction in which a sensor is aimed, from north towards east, deg; empty if it has no aim. */
    static OptionalDouble azimuth(SiteCandidate sensor) {
        return sensor.sensor()
                .as(Aimed.class)
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
