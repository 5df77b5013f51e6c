package org.dronewatch.report.placement;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;
import org.dronewatch.placement.site.PlaceStep;
import org.dronewatch.placement.site.RoutePlacement;
import org.dronewatch.placement.site.SiteCandidate;
import org.dronewatch.placement.site.WeakestRouteSearch;
import org.dronewatch.report.Numbers;
import org.dronewatch.route.search.WeakestRoute;
import org.dronewatch.setting.Counted;

/**
 * The best layout against the weakest route as a table, in the order in which its sensors are best bought, and the
 * route in words.
 */
public final class RoutePlaceTable {
    private static final String ROW = "%-24s  %-8s  %24s  %7s  %10s  %10s  %7s  %8s";
    private static final String NONE = "-";

    private RoutePlaceTable() {}

    /** The lines. */
    public static List<String> lines(RoutePlacement placement) {
        List<String> lines = new ArrayList<>();
        lines.add("best layout from " + Counted.of(placement.plan().candidates().size(), "candidate")
                + " for a budget of "
                + Numbers.text(placement.plan().settings().budget())
                + " against the weakest route, in the order in which to buy:");
        lines.add(text(ROW, "sensor", "kind", "position [m]", "azimuth", "cost", "sum", "alone", "together"));
        placement.chosen().stream()
                .filter(sensor -> sensor.candidate().fixed())
                .forEach(sensor -> lines.add(row(sensor, "kept", NONE, placement, NONE)));
        if (placement.front().isEmpty()) {
            placement.chosen().stream()
                    .filter(sensor -> !sensor.candidate().fixed())
                    .forEach(sensor -> lines.add(row(sensor, cost(sensor), NONE, placement, NONE)));
        }
        for (PlaceStep step : placement.front()) {
            SiteCandidate sensor = placement.chosen().stream()
                    .filter(one -> one.name().equals(step.added()))
                    .findFirst()
                    .orElseThrow();
            lines.add(row(sensor, cost(sensor), Numbers.text(step.cost()), placement, detected(step.value())));
        }
        lines.add("");
        lines.add(weakest(placement));
        lines.add(bound(placement));
        lines.add(lower(placement));
        placement
                .present()
                .ifPresent(own -> lines.add("Past the scene's own " + Counted.of(own.sensors(), "sensor")
                        + ", the drone is detected with a probability of " + detected(own.value())
                        + " on the weakest route."));
        placement.without().entrySet().stream()
                .min(Map.Entry.comparingByValue())
                .ifPresent(worst -> lines.add("Without " + worst.getKey()
                        + ", whose loss is worst, the drone is detected with a probability of "
                        + detected(worst.getValue()) + "."));
        return lines;
    }

    private static String weakest(RoutePlacement placement) {
        WeakestRoute route = placement.weakest();
        double value = placement.result().value();
        if (value == 0.0) {
            return "A route past the layout remains on which no sensor detects the drone: " + along(route) + ".";
        }
        return "On the weakest route past the layout, the drone is detected with a probability of " + detected(value)
                + " (exposure " + exposure(value) + "): " + along(route) + ".";
    }

    private static String along(WeakestRoute route) {
        Position from = route.path().points().get(0);
        return text("from %s, %.0f m in %.0f s", position(from), route.path().length(), route.seconds());
    }

    private static String bound(RoutePlacement placement) {
        double value = placement.result().value();
        double bound = placement.result().bound();
        String search = " (" + Counted.of(placement.rounds(), "layout") + " tried, "
                + Counted.of(placement.routes(), "route") + " compared)";
        return bound <= value
                ? "No layout within the budget has a weakest route that is more exposed" + search + "."
                : "No layout within the budget detects the drone on its weakest route with a probability of more than "
                        + detected(bound) + " (exposure "
                        + exposure(bound)
                        + (value == 0.0 ? "" : text(", a gap of %.1f %%", 100.0 * (bound / value - 1.0))) + ")" + search
                        + ".";
    }

    /** What is certain of the routes that the search did not find. */
    private static String lower(RoutePlacement placement) {
        return placement.lower() > 0.0
                ? "No route past the layout has an exposure below " + exposure(placement.lower()) + " ("
                        + detected(placement.lower()) + "): this is proven."
                : "For routes that the search did not find, no lower bound of the exposure is proven.";
    }

    private static String row(SiteCandidate sensor, String cost, String sum, RoutePlacement placement, String value) {
        OptionalDouble azimuth = PlaceTable.azimuth(sensor);
        Double alone = placement.alone().get(sensor.name());
        return text(
                ROW,
                sensor.name(),
                sensor.sensor().kind(),
                position(sensor.sensor().position()),
                azimuth.isPresent() ? text("%.0f°", azimuth.getAsDouble()) : NONE,
                cost,
                sum,
                alone == null ? NONE : detected(alone),
                value);
    }

    private static String cost(SiteCandidate sensor) {
        return Numbers.text(sensor.candidate().cost());
    }

    private static String position(Position position) {
        return text("%.1f, %.1f, %.1f", position.x(), position.y(), position.z());
    }

    private static String exposure(double exposure) {
        return exposure >= WeakestRouteSearch.ENOUGH ? text("%.1f or more", exposure) : text("%.3f", exposure);
    }

    /** The probability of a detection, for an exposure. */
    private static String detected(double exposure) {
        return text("%.1f %%", 100.0 * RoutePlacement.detection(exposure));
    }

    private static String text(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
