package org.dronewatch.report.route;

import static org.dronewatch.report.html.ReadableNumbers.number;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.proof.UnseenPlaces;

/**
 * Notes on where the search misjudges routes or may have missed others, why, and what to try. A statement about the
 * detections that count on a route is made only once.
 */
final class SearchNotes {
    /** An exposure that hardly matters, as in tables. */
    private static final double LITTLE = 0.001;

    private final RouteInputs inputs;
    private final SlowLooks looks;
    private final HeightNotes heights;

    SearchNotes(RouteInputs inputs, SlowLooks looks, HeightNotes heights) {
        this.inputs = inputs;
        this.looks = looks;
        this.heights = heights;
    }

    /** Which routes the search misjudges: a warning for those that have the same cause and call for the same advice. */
    List<String> misjudged(RouteSurvey survey) {
        double response = survey.response();
        List<String> warnings = new ArrayList<>();
        for (Misjudgement cause : Misjudgement.values()) {
            for (boolean isUnproven : new boolean[] {false, true}) {
                List<SectorRoute> routes = survey.routes().stream()
                        .filter(route -> Misjudgement.inTime(route, response).equals(Optional.of(cause)))
                        .filter(route -> route.isUnproven(response) == isUnproven)
                        .toList();
                if (!routes.isEmpty()) {
                    warnings.add("the search in cells of "
                            + Numbers.text(inputs.grid().cell()) + " m misjudges "
                            + RouteDirections.routes(routes) + ": as flown, the chance of a detection"
                            + inTime(response)
                            + difference(routes, response) + ", because the search "
                            + reason(cause, routes) + advice(cause, isUnproven, routes));
                }
            }
        }
        return warnings;
    }

    /** By how much the flights differ from the search, {@code differs by up to 98 percentage points}. */
    private static String difference(List<SectorRoute> routes, double response) {
        double most = routes.stream()
                .mapToDouble(
                        route -> Math.abs(route.inTime(response) - route.route().detection()))
                .max()
                .orElseThrow();
        return " differs by " + (routes.size() > 1 ? "up to " : "") + number(Math.rint(100.0 * most))
                + " percentage points";
    }

    /** What the search does that makes it misjudge a route; empty if it does not. */
    Optional<String> misjudgement(SectorRoute route, double response) {
        return Misjudgement.inTime(route, response).map(cause -> reason(cause, List.of(route)));
    }

    /** What the search does that makes it misjudge routes. */
    private String reason(Misjudgement cause, List<SectorRoute> routes) {
        String cells = "assesses each cell only at its centre";
        return switch (cause) {
            case CELLS -> cells;
            case SCANS -> looks.assumption(routes);
            case BOTH -> cells + ", and " + looks.assumption(routes);
        };
    }

    /** What to try where the search misjudges routes and, possibly, less exposed ones cannot be ruled out. */
    private String advice(Misjudgement cause, boolean isUnproven, List<SectorRoute> routes) {
        if (!isUnproven) {
            return cause.isForCells() ? "; try " + finer() : "";
        }
        return (cause.isForCells()
                        ? "; try " + finer() + ", which may also show less exposed routes: they cannot be ruled out"
                        : "; smaller cells do not remove this error, but less exposed routes cannot be ruled out: to look for"
                                + " them between cell centres, try " + finer())
                + elsewhere(routes);
    }

    /** Where to look for routes that are lower than all that were searched for, or come from farther away. */
    private String elsewhere(List<SectorRoute> routes) {
        boolean isFarther = inputs.launch().isEmpty() && routes.stream().anyMatch(this::isSeenWhereItBegins);
        return heights.closerToTheGround().map(how -> "; " + how).orElse("")
                + (isFarther
                        ? "; sensors detect the drone where a route begins: to let routes begin farther away, try a larger --side"
                        : "");
    }

    /** Whether sensors may already detect the drone in the first cell of a route. */
    private boolean isSeenWhereItBegins(SectorRoute route) {
        DroneSettings drone = inputs.settings().individualDrones().get(inputs.drone());
        return route.searched().exposureUntil(inputs.grid().cell() / drone.speed()) > LITTLE;
    }

    private static String inTime(double response) {
        return response > 0.0 ? " in time" : "";
    }

    /** The options for smaller cells. */
    private String finer() {
        return 2 * inputs.grid().columns() <= FieldGrid.MOST_CELLS
                ? "--cell " + Numbers.text(0.5 * inputs.grid().cell()) + "m"
                : "a smaller --side with smaller cells";
    }

    /**
     * The route that is least exposed according to the search, if those of repeated searches have replaced it; empty
     * if it is among those listed, or is printed like one of them.
     */
    Optional<String> replaced(RouteResults results) {
        List<String> listed = results.survey().routes().stream()
                .map(route -> RouteNumbers.exposure(route.route().exposure()))
                .toList();
        return results.leastExposed()
                .filter(route ->
                        !listed.contains(RouteNumbers.exposure(route.route().exposure())))
                .map(route -> "By the search alone, the least exposed route comes from the " + RouteWords.sector(route)
                        + ", with a counted exposure of "
                        + RouteNumbers.exposure(route.route().exposure()) + " (detected"
                        + inTime(results.survey().response()) + " with a probability of "
                        + RouteNumbers.percent(route.route().detection())
                        + "). The table lists another route from the " + RouteWords.sector(route)
                        + " instead: as flown, the drone is detected less often on that one.");
    }

    /**
     * The sectors from which there may be routes on which the drone is detected less often, and which smaller cells may
     * show; empty if there are none besides those for which a warning already says so.
     */
    Optional<String> unproven(RouteSurvey survey) {
        double response = survey.response();
        List<SectorRoute> routes = survey.routes().stream()
                .filter(route -> route.isUnproven(response))
                .filter(route -> Misjudgement.inTime(route, response).isEmpty())
                .toList();
        return routes.isEmpty()
                ? Optional.empty()
                : Optional.of("Less exposed routes " + RouteDirections.from(routes)
                        + " cannot be ruled out: the lower bound on the exposure is compatible with a probability of detection"
                        + inTime(response)
                        + " that is more than 20 percentage points lower. To look for them between cell centres,"
                        + " try " + finer() + elsewhere(routes) + ".");
    }

    /**
     * Why the columns of the search and of the flights differ where both agree on the detections in time; empty if they
     * do not differ, or if a warning says that they differ on these, too.
     */
    List<String> tooLate(RouteSurvey survey) {
        List<String> notes = new ArrayList<>();
        for (Misjudgement cause : Misjudgement.values()) {
            List<SectorRoute> routes = survey.routes().stream()
                    .filter(route ->
                            Misjudgement.tooLate(route, survey.response()).equals(Optional.of(cause)))
                    .toList();
            if (!routes.isEmpty()) {
                notes.add("On " + RouteDirections.routes(routes)
                        + ", 'search' and 'detected' differ by more than 20 percentage points, but only because of detections that"
                        + " come too late: the search " + reason(cause, routes) + ".");
            }
        }
        return notes;
    }

    /** Whether passages may exist that the search cannot find, since no cell shows them; empty if none is likely. */
    Optional<String> unseen(UnseenPlaces between) {
        return between.unseen() == 0
                ? Optional.empty()
                : Optional.of("At " + number(between.unseen()) + " of " + number(between.tried())
                        + " places tried between cell centres, no sensor detects the drone, although all"
                        + " surrounding cells are covered. Passages narrower than a cell, which the search cannot find,"
                        + " may lead through such places, and a route along one may be less exposed than the lower bound; to look for passages, try "
                        + finer()
                        + ".");
    }
}
