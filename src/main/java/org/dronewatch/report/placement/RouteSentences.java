package org.dronewatch.report.placement;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.DoublePredicate;
import java.util.stream.Collectors;
import org.dronewatch.geometry.Position;
import org.dronewatch.placement.PlacementResult;
import org.dronewatch.placement.route.DirectedRoute;
import org.dronewatch.placement.route.RoutePlacement;
import org.dronewatch.placement.route.WeakestRouteSearch;
import org.dronewatch.report.CompassPoint;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.search.WeakestRoute;
import org.dronewatch.setting.Counted;
import org.dronewatch.setting.PlainText;

/**
 * States in sentences the weakest route that was found past the layout, and what is proven about other routes and
 * layouts.
 */
final class RouteSentences {
    private final RoutePlacement best;
    private final boolean isShort;
    private final double value;

    /**
     * Sentences.
     *
     * @param isShort whether flights past the layout show less than the search estimates
     */
    RouteSentences(RoutePlacement best, boolean isShort) {
        this.best = best;
        this.isShort = isShort;
        this.value = best.value();
    }

    /** The route, the bound of all layouts, and that of all routes past this one. */
    List<String> lines() {
        List<String> lines = new ArrayList<>(List.of(weakest()));
        remaining().ifPresent(lines::add);
        lines.addAll(List.of(bound(), lower()));
        return lines;
    }

    /** The weakest route past the layout; where nothing gains anything, past all affordable candidates. */
    String weakest() {
        if (isNeverClosed()) {
            DirectedRoute route = best.remaining().get(0);
            return "Even past " + affordable() + ", a route remains on which no sensor detects the drone in time"
                    + scene(route) + begins(route);
        }
        if (value == 0.0) {
            return "A route past the layout remains on which no sensor detects the drone" + scene(best.weakest())
                    + begins(best.weakest());
        }
        return "On the weakest route past the layout" + scene(best.weakest())
                + ", the drone is detected with a probability of " + detected(value) + " (exposure " + exposure(value)
                + "), as estimated by the search" + begins(best.weakest());
    }

    /** Whether all affordable candidates together leave a route without exposure. */
    private boolean isNeverClosed() {
        return !best.remaining().isEmpty() && best.remaining().get(0).exposure() == 0.0;
    }

    /** {@code all 17 affordable candidates together}. */
    private String affordable() {
        return switch (best.affordable()) {
            case 1 -> "the only affordable candidate";
            case 2 -> "both affordable candidates together";
            default -> "all " + best.affordable() + " affordable candidates together";
        };
    }

    /**
     * If no purchase gains anything, a sentence that names the directions from which sensors could detect the drone
     * nevertheless, or states that only the budget or the conditions rule out a layout without a gap; otherwise empty.
     */
    Optional<String> remaining() {
        if (best.remaining().isEmpty()) {
            return Optional.empty();
        }
        Map<Integer, Double> least = new TreeMap<>();
        best.remaining().forEach(route -> least.merge(route.sector(), route.exposure(), Math::min));
        double weakest = least.values().stream()
                .filter(exposure -> exposure > 0.0)
                .min(Double::compare)
                .orElse(0.0);
        if (weakest == 0.0) {
            return Optional.of("The same is true of all other directions.");
        }
        String probability = " with a probability of " + detected(weakest)
                + (weakest < WeakestRouteSearch.ENOUGH ? " or more" : "") + ", as estimated by the search";
        if (!isNeverClosed()) {
            return Optional.of(sentence(affordable()) + " would detect the drone on every route" + probability
                    + ", but no layout within the budget that meets the conditions does.");
        }
        return Optional.of("From the " + directions(least, exposure -> exposure > 0.0) + ", " + affordable()
                + (best.affordable() == 1 ? " detects" : " detect") + " the drone" + probability
                + ": there, gaps can be closed. Detecting it from the "
                + directions(least, exposure -> exposure == 0.0)
                + " requires candidates of other kinds or at other positions.");
    }

    private static String sentence(String words) {
        return words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1);
    }

    private static String directions(Map<Integer, Double> least, DoublePredicate isMeant) {
        return PlainText.list(least.entrySet().stream()
                .filter(one -> isMeant.test(one.getValue()))
                .map(one -> CompassPoint.of(SectorRoute.bearing(one.getKey())))
                .toList());
    }

    /** The points of the route that remains past all affordable candidates, in a sentence; empty if there is none. */
    Optional<String> points() {
        return isNeverClosed()
                ? Optional.of("That route leads through "
                        + best.remaining().get(0).route().path().points().stream()
                                .map(at -> PlaceTable.text("%.1f, %.1f, %.1f", at.x(), at.y(), at.z()))
                                .collect(Collectors.joining("; "))
                        + " (east, north, up; m).")
                : Optional.empty();
    }

    /** {@code , under the condition 'fog'}: where that route was found; an empty text if there are no conditions. */
    private String scene(DirectedRoute route) {
        return isConditioned()
                ? route.condition()
                        .map(name -> ", under the condition '" + name + "'")
                        .orElse(", in the scene as it is")
                : "";
    }

    private boolean isConditioned() {
        return !best.byCondition().isEmpty();
    }

    /** Where a route begins, and how long it is: the rest of a sentence. */
    private static String begins(DirectedRoute directed) {
        WeakestRoute route = directed.route();
        Position from = route.path().points().get(0);
        return PlaceTable.text(
                "; the route begins at %.1f, %.1f, %.1f (east, north, up; m), in the %s, and is %.0f m long (%.0f s of"
                        + " flight).",
                from.x(),
                from.y(),
                from.z(),
                CompassPoint.of(directed.bearing()),
                route.path().length(),
                route.seconds());
    }

    private String bound() {
        PlacementResult result = best.result();
        String search = " (" + Counted.of(best.rounds(), "layout") + " tried, " + Counted.of(best.routes(), "route")
                + " compared)";
        String no = isShort ? "By this estimate, no" : "No";
        return result.bound() <= value
                ? no + " layout within the budget has a weakest route that is more exposed" + search + "."
                        + (isShort ? " As flown, another may do better." : "")
                : no + " layout within the budget detects the drone on its weakest route with a probability of "
                        + FrontWords.moreThan(detected(result.bound())) + " (exposure " + exposure(result.bound())
                        + (value == 0.0 ? "" : PlaceTable.text(", a gap of %.1f %%", 100.0 * best.gap())) + ")"
                        + search + ".";
    }

    /** What is certain about the routes that the search did not find. */
    String lower() {
        return best.lower() > 0.0
                ? "The exposure on every route past the layout is "
                        + (best.lower() >= WeakestRouteSearch.ENOUGH ? "" : "at least ")
                        + exposure(best.lower()) + " (" + detected(best.lower()) + ")"
                        + (isConditioned() ? " under any condition" : "") + ": this is proven."
                : "For routes that the search did not find, no lower bound on the exposure is proven.";
    }

    static String exposure(double exposure) {
        return exposure >= WeakestRouteSearch.ENOUGH
                ? PlaceTable.text("%.1f or more", exposure)
                : PlaceTable.text("%.3f", exposure);
    }

    /** The probability of a detection, for an exposure. */
    private static String detected(double exposure) {
        return FrontWords.percent(RoutePlacement.detection(exposure));
    }
}
