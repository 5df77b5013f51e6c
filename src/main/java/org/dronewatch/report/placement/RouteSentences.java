package org.dronewatch.report.placement;

import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.placement.PlacementResult;
import org.dronewatch.placement.route.RoutePlacement;
import org.dronewatch.placement.route.WeakestRouteSearch;
import org.dronewatch.report.CompassPoint;
import org.dronewatch.route.search.WeakestRoute;
import org.dronewatch.setting.Counted;

/** The weakest route past the layout that was found, and what is proven of others, in sentences. */
final class RouteSentences {
    private final RoutePlacement best;
    private final double value;

    RouteSentences(RoutePlacement best) {
        this.best = best;
        this.value = best.value();
    }

    /** The route, the bound of all layouts, and that of all routes past this one. */
    List<String> lines() {
        return List.of(weakest(), bound(), lower());
    }

    private String weakest() {
        if (value == 0.0) {
            return "A route past the layout remains on which no sensor detects the drone" + scene() + ": " + along()
                    + ".";
        }
        return "On the weakest route past the layout" + scene() + ", the drone is detected with a probability of "
                + detected(value) + " (exposure " + exposure(value) + "), as the search estimates it: " + along() + ".";
    }

    /** {@code , under the condition 'fog'}: where that route was found; an empty text if there are no conditions. */
    private String scene() {
        return isConditioned()
                ? best.weakest()
                        .condition()
                        .map(name -> ", under the condition '" + name + "'")
                        .orElse(", in the scene as it is")
                : "";
    }

    private boolean isConditioned() {
        return !best.byCondition().isEmpty();
    }

    private String along() {
        WeakestRoute route = best.weakest().route();
        Position from = route.path().points().get(0);
        return PlaceTable.text(
                "from %.1f, %.1f, %.1f in the %s, %.0f m in %.0f s",
                from.x(),
                from.y(),
                from.z(),
                CompassPoint.of(best.weakest().bearing()),
                route.path().length(),
                route.seconds());
    }

    private String bound() {
        PlacementResult result = best.result();
        String search = " (" + Counted.of(best.rounds(), "layout") + " tried, " + Counted.of(best.routes(), "route")
                + " compared)";
        return result.bound() <= value
                ? "No layout within the budget has a weakest route that is more exposed" + search + "."
                : "No layout within the budget detects the drone on its weakest route with a probability of "
                        + FrontWords.moreThan(detected(result.bound())) + " (exposure " + exposure(result.bound())
                        + (value == 0.0 ? "" : PlaceTable.text(", a gap of %.1f %%", 100.0 * best.gap())) + ")"
                        + search + ".";
    }

    /** What is certain of the routes that the search did not find. */
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
