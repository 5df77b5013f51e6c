package org.dronewatch.report.placement;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import org.dronewatch.analysis.field.InboundWarnings;
import org.dronewatch.geometry.Position;
import org.dronewatch.placement.site.PlaceStep;
import org.dronewatch.placement.site.SiteCandidate;
import org.dronewatch.placement.site.WarningMeasure;
import org.dronewatch.placement.site.WarningPlacement;
import org.dronewatch.report.Numbers;
import org.dronewatch.setting.Counted;

/**
 * The layout with the longest warning as a table, in the order in which its sensors are best bought, and its warning in
 * words.
 */
public final class WarningPlaceTable {
    private static final String ROW = "%-24s  %-8s  %24s  %7s  %10s  %10s  %7s  %8s";
    private static final String NONE = "-";

    private WarningPlaceTable() {}

    /** The lines. */
    public static List<String> lines(WarningPlacement placement) {
        List<String> lines = new ArrayList<>();
        lines.add("best layout from " + Counted.of(placement.plan().candidates().size(), "candidate")
                + " for a budget of "
                + Numbers.text(placement.plan().settings().budget()) + " for the longest "
                + (isWorst(placement) ? "minimum" : "mean") + " warning, in the order in which to buy:");
        lines.add(text(ROW, "sensor", "kind", "position [m]", "azimuth", "cost", "sum", "alone", "together"));
        placement.chosen().stream()
                .filter(sensor -> sensor.candidate().fixed())
                .forEach(sensor -> lines.add(row(sensor, "kept", NONE, placement, NONE)));
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
                    seconds(step.value())));
        }
        lines.add("");
        lines.add(worth(placement));
        placement
                .present()
                .ifPresent(own ->
                        lines.add("The scene's own " + Counted.of(own.sensors(), "sensor gives ", "sensors give ")
                                + warning(placement, own.value())
                                + "."));
        placement.withoutEach().entrySet().stream()
                .min(Map.Entry.comparingByValue())
                .ifPresent(worst -> lines.add("Without " + worst.getKey() + ", whose loss is worst, the layout gives "
                        + warning(placement, worst.getValue()) + "."));
        return lines;
    }

    private static boolean isWorst(WarningPlacement placement) {
        return placement.measure() == WarningMeasure.WORST;
    }

    private static String warning(WarningPlacement placement, double seconds) {
        return (isWorst(placement) ? "a minimum warning of " : "a mean warning of ") + seconds(seconds);
    }

    private static String worth(WarningPlacement placement) {
        String given = "The layout gives " + warning(placement, placement.value()) + " of straight flights from "
                + InboundWarnings.BEARINGS + " bearings at "
                + Counted.of(placement.grid().heights().size(), "height") + ", for "
                + Numbers.text(placement.result().cost());
        String detected = " It detects " + placement.detected() + " of " + placement.flights()
                + " before they arrive; a flight that is detected where it begins gives "
                + seconds(placement.longest()) + " at most.";
        return given
                + (placement.bound() <= placement.value()
                        ? "; no layout within the budget gives more."
                        : "; no layout within the budget gives more than " + seconds(placement.bound()) + ".")
                + detected;
    }

    private static String row(SiteCandidate sensor, String cost, String sum, WarningPlacement placement, String value) {
        OptionalDouble azimuth = PlaceTable.azimuth(sensor);
        Position position = sensor.sensor().position();
        return text(
                ROW,
                sensor.name(),
                sensor.sensor().kind(),
                text("%.1f, %.1f, %.1f", position.x(), position.y(), position.z()),
                azimuth.isPresent() ? text("%.0f°", azimuth.getAsDouble()) : NONE,
                cost,
                sum,
                seconds(placement.alone(sensor)),
                value);
    }

    private static String seconds(double seconds) {
        return text("%.1f s", seconds);
    }

    private static String text(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
