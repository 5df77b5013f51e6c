package org.dronewatch.report.placement;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.dronewatch.placement.route.RoutePlacement;
import org.dronewatch.placement.route.WeakestRouteSearch;
import org.dronewatch.report.CompassPoint;
import org.dronewatch.report.route.RouteTable;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.SiteRoutes;

/** The weakest routes past the layout and past the scene's own sensors, as they are flown, by direction. */
final class FlownTable {
    private static final String ROW = "%-12s  %8s  %8s  %8s  %8s  %10s";
    private static final String NONE = "-";

    private final Optional<FlownLayout> layout;
    private final Optional<FlownLayout> present;
    private final RoutePlacement best;

    /**
     * The weakest routes from one direction.
     *
     * @param from the direction
     * @param layout route past the layout; empty if there is none
     * @param present route past the scene's own sensors; empty if there is none, or if the scene has no sensors
     * @param response time that the response takes, 0 if none is required, s: only earlier detections count
     */
    record Pair(String from, Optional<SectorRoute> layout, Optional<SectorRoute> present, double response) {}

    FlownTable(Optional<FlownLayout> layout, Optional<FlownLayout> present, RoutePlacement best) {
        this.layout = layout;
        this.present = present;
        this.best = best;
    }

    /** The routes from all directions from which there are any. */
    static List<Pair> pairs(Optional<FlownLayout> layout, Optional<FlownLayout> present) {
        List<Pair> pairs = new ArrayList<>();
        double response = layout.or(() -> present)
                .map(flown -> flown.results().survey().response())
                .orElse(0.0);
        for (int sector = 0; sector < SiteRoutes.SECTORS; sector++) {
            int from = sector;
            Function<FlownLayout, Optional<SectorRoute>> its = flown -> route(flown, from);
            Pair pair = new Pair(
                    CompassPoint.of(SectorRoute.bearing(sector)), layout.flatMap(its), present.flatMap(its), response);
            if (pair.layout().isPresent() || pair.present().isPresent()) {
                pairs.add(pair);
            }
        }
        return pairs;
    }

    private static Optional<SectorRoute> route(FlownLayout flown, int sector) {
        return flown.results().survey().routes().stream()
                .filter(route -> route.sector() == sector)
                .findFirst();
    }

    /** The heads of the columns, without that of the direction. */
    static List<String> heads() {
        return List.of("today: search", "today: flown", "layout: search", "layout: flown", "layout: time left");
    }

    /** The figures of a direction under these heads. */
    static List<String> figures(Pair pair) {
        return List.of(
                text(pair.present(), route -> route.route().detection()),
                text(pair.present(), route -> route.inTime(pair.response())),
                text(pair.layout(), route -> route.route().detection()),
                text(pair.layout(), route -> route.inTime(pair.response())),
                pair.layout()
                        .filter(route -> route.left().isPresent())
                        .map(route -> PlaceTable.text("%.1f s", route.left().getAsDouble()))
                        .orElse(NONE));
    }

    private static String text(Optional<SectorRoute> route, Function<SectorRoute, Double> detection) {
        return route.map(its -> FrontWords.percent(detection.apply(its))).orElse(NONE);
    }

    /** A table after an empty line, and the weakest routes in words. */
    List<String> lines() {
        List<String> lines = new ArrayList<>();
        lines.add("");
        lines.add("probability of a detection in time on the weakest route from each direction, by the search and as"
                + " flown" + asItIs() + ":");
        lines.add(PlaceTable.text(ROW, "", "today", "", "layout", "", ""));
        lines.add(PlaceTable.text(ROW, "from", "search", "flown", "search", "flown", "time left"));
        for (Pair pair : pairs(layout, present)) {
            List<Object> cells = new ArrayList<>(List.of(pair.from()));
            cells.addAll(figures(pair));
            lines.add(PlaceTable.text(ROW, cells.toArray()));
        }
        lines.addAll(words());
        return lines;
    }

    /** The weakest route past each layout in words. */
    List<String> words() {
        List<String> words = new ArrayList<>();
        layout.ifPresent(flown -> RouteTable.summary(flown.results(), flown.inputs())
                .forEach(line -> words.add(of("Past the layout", FlownLayout.asSettings(line)))));
        present.map(flown -> RouteTable.summary(flown.results(), flown.inputs()).get(0))
                .ifPresent(line -> words.add(of("Past today's sensors", FlownLayout.asSettings(line))));
        weaker().ifPresent(words::add);
        return words;
    }

    /**
     * How to fly the routes past the layout again, in a sentence; empty if there are none.
     *
     * @param scene the file of the layout, as a command-line argument
     */
    Optional<String> reproduction(String scene) {
        return layout.map(flown -> "This command gives the figures of the layout" + asItIs()
                + ", and a scene for each route: dronewatch route " + scene + " "
                + SameRoute.options(best, flown.inputs()));
    }

    /**
     * That a route of another layout is weaker than all that were found past this one; empty if, as printed, none is.
     */
    private Optional<String> weaker() {
        String known = RouteSentences.exposure(best.asItIs());
        return layout.flatMap(flown -> flown.results().leastExposed())
                .map(route -> Math.min(WeakestRouteSearch.ENOUGH, route.route().exposure()))
                .filter(found ->
                        best.asItIs() < found && !RouteSentences.exposure(found).equals(known))
                .map(found -> "A search with this layout alone finds no route with an exposure below "
                        + RouteSentences.exposure(found) + "; but on a route that was found with other sensors,"
                        + " the exposure to this layout is even lower: " + known + ".");
    }

    /** {@code , in the scene as it is}; an empty text if only that counts. */
    String asItIs() {
        return best.byCondition().isEmpty() ? "" : ", in the scene as it is";
    }

    private static String of(String whom, String line) {
        return line.startsWith("On the weakest route") ? whom + ", on" + line.substring(2) : line;
    }
}
