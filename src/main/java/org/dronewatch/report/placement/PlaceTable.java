package org.dronewatch.report.placement;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;
import org.dronewatch.placement.site.PlaceStep;
import org.dronewatch.placement.site.SiteCandidate;
import org.dronewatch.placement.site.SitePlacement;
import org.dronewatch.report.Numbers;
import org.dronewatch.sensor.Aimed;

/** The best layout as a table, in the order in which its sensors are best bought, and its coverage in words. */
public final class PlaceTable {
    private static final String ROW = "%-24s  %-8s  %24s  %7s  %10s  %10s  %7s  %8s";
    private static final double FULL_TURN = 360.0;

    private PlaceTable() {}

    /** The lines. */
    public static List<String> lines(SitePlacement placement) {
        List<String> lines = new ArrayList<>();
        lines.add("best layout of " + placement.plan().candidates().size() + " candidates for a budget of "
                + Numbers.text(placement.plan().settings().budget()) + ", in the order in which to buy:");
        lines.add(text(ROW, "sensor", "kind", "position [m]", "azimuth", "cost", "sum", "alone", "together"));
        placement.chosen().stream()
                .filter(sensor -> sensor.candidate().fixed())
                .forEach(sensor -> lines.add(row(sensor, "kept", "-", placement, "-")));
        for (PlaceStep step : placement.front()) {
            SiteCandidate sensor = placement.chosen().stream()
                    .filter(one -> one.name().equals(step.added()))
                    .findFirst()
                    .orElseThrow();
            lines.add(row(
                    sensor,
                    Numbers.text(sensor.candidate().cost()),
                    Numbers.text(step.cost()),
                    placement,
                    percent(step.value())));
        }
        lines.add("");
        lines.add(worth(placement));
        placement
                .worst()
                .ifPresent(share -> lines.add(
                        placement.headings() > 1
                                ? "On the heading that is worst in each cell, the layout covers " + percent(share)
                                        + " of the cells."
                                : "All figures are for flight towards the protected zone."));
        placement
                .present()
                .ifPresent(own -> lines.add("The scene's own " + own.sensors()
                        + (own.sensors() == 1 ? " sensor covers " : " sensors cover ") + percent(own.value()) + "."));
        placement.withoutEach().entrySet().stream()
                .min(Map.Entry.comparingByValue())
                .ifPresent(worst -> lines.add("Without " + worst.getKey() + ", whose loss is worst, the layout covers "
                        + percent(worst.getValue()) + "."));
        return lines;
    }

    private static String worth(SitePlacement placement) {
        int fold = placement.plan().settings().conditions().fold();
        String covered =
                "The layout covers " + percent(placement.value()) + " of the air (" + placement.cells() + " cells"
                        + (placement.headings() > 1 ? ", " + placement.headings() + " headings)" : ")")
                        + (fold > 1 ? ", each covered by " + fold + " sensors or more," : "") + " for "
                        + Numbers.text(placement.result().cost());
        boolean isBest = placement.value() == placement.bound();
        return covered
                + (isBest
                        ? "; no layout within the budget covers more."
                        : "; no layout within the budget covers more than " + percent(placement.bound()) + ".");
    }

    private static String row(SiteCandidate sensor, String cost, String sum, SitePlacement placement, String value) {
        OptionalDouble azimuth = azimuth(sensor);
        return text(
                ROW,
                sensor.name(),
                sensor.sensor().kind(),
                position(sensor.sensor().position()),
                azimuth.isPresent() ? text("%.0f°", azimuth.getAsDouble()) : "-",
                cost,
                sum,
                percent(placement.alone(sensor)),
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

    private static String position(Position position) {
        return text("%.1f, %.1f, %.1f", position.x(), position.y(), position.z());
    }

    private static String percent(double fraction) {
        return text("%.1f %%", 100.0 * fraction);
    }

    private static String text(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
