package org.dronewatch.report.placement;

import java.util.Comparator;
import java.util.Optional;
import org.dronewatch.report.CompassPoint;
import org.dronewatch.report.route.RouteInputs;
import org.dronewatch.report.route.RouteResults;
import org.dronewatch.report.route.RouteTable;
import org.dronewatch.route.SectorRoute;

/**
 * The weakest routes past a layout, searched for and flown as the command {@code route} does.
 *
 * @param inputs inputs of the search: the scene with the layout's sensors
 * @param results the routes from all directions, with every look along them
 */
public record FlownLayout(RouteInputs inputs, RouteResults results) {
    /**
     * The route on which the drone is least likely to be detected in time, as flown; empty unless all routes have been
     * flown.
     */
    Optional<SectorRoute> weakest() {
        return results.isComplete()
                ? results.survey().routes().stream()
                        .filter(route ->
                                route.flown().isPresent() && route.route().seconds() > 0.0)
                        .min(Comparator.comparingDouble(this::inTime))
                : Optional.empty();
    }

    /** The probability that the drone is detected in time on one of the routes, 0 to 1. */
    double inTime(SectorRoute route) {
        return route.inTime(results.survey().response());
    }

    /** The direction from which a route comes, {@code from the east}. */
    static String from(SectorRoute route) {
        return "from the " + CompassPoint.of(route.bearing());
    }

    /** A sentence of {@code route}, in which the options that it advises become settings of the airspace. */
    static String asSettings(String sentence) {
        return sentence.replaceAll("--(heights|side)\\b", "air.$1");
    }

    /**
     * Why the search misjudges a route, in a clause; an empty text if it does not.
     *
     * @param before the text before the clause, which refers to the search as {@code it}
     */
    String because(SectorRoute route, String before) {
        return RouteTable.misjudgement(route, results, inputs)
                .map(FlownLayout::asSettings)
                .map(reason -> before + " because it " + reason)
                .orElse("");
    }
}
