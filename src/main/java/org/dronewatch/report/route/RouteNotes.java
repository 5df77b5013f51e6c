package org.dronewatch.report.route;

import static org.dronewatch.report.html.ReadableNumbers.number;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.route.RoutePoint;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.proof.RouteStarts;
import org.dronewatch.route.proof.UnseenPlaces;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.PlainText;

/** What has to be known of the figures of routes: over which flights they are means, and where they mislead. */
final class RouteNotes {
    /** The part of its cruise speed at which an aircraft with wings still flies, roughly. */
    private static final double LEAST_SPEED = 0.7;

    private final RouteInputs inputs;

    RouteNotes(RouteInputs inputs) {
        this.inputs = inputs;
    }

    /** Notes on the results, one line each. */
    List<String> notes(RouteResults results) {
        return Stream.of(
                        begins(results.survey()),
                        unproven(results.survey()),
                        new HeightNotes(inputs).belowCeiling(),
                        new HeightNotes(inputs).beginningHigh(results.survey()),
                        unseen(results.between()),
                        tooLate(results.survey()),
                        tooSlow(results.survey()),
                        withoutAlert(results),
                        cued(results))
                .flatMap(Optional::stream)
                .toList();
    }

    /** Warnings, one line each. */
    List<String> warnings(RouteSurvey survey) {
        return Stream.of(tooShort(survey), misjudged(survey))
                .flatMap(Optional::stream)
                .toList();
    }

    /** Which routes the search misjudges, and which length of cells to try; empty if none. */
    private Optional<String> misjudged(RouteSurvey survey) {
        List<String> sectors = sectors(survey, route -> route.isMisjudged(survey.response()));
        return sectors.isEmpty()
                ? Optional.empty()
                : Optional.of("the search in cells of "
                        + Numbers.text(inputs.grid().cell()) + " m misjudges the "
                        + (sectors.size() == 1 ? "route" : "routes") + " from the " + listed(sectors)
                        + ": as flown, the chance of a detection"
                        + (survey.response() > 0.0 ? " in time" : "") + " differs by more than 20 percentage points"
                        + causes(survey));
    }

    /** Why the search misjudges routes, and what to try. */
    private String causes(RouteSurvey survey) {
        List<SectorRoute> routes = survey.routes().stream()
                .filter(route -> route.isMisjudged(survey.response()))
                .toList();
        List<SectorRoute> scanned = routes.stream()
                .filter(route -> route.isMisjudgedForScans(survey.response()))
                .toList();
        String scan = disagreeing(scanned)
                .map(sensor -> ", because the search assumes that '" + PlainText.value(sensor)
                        + "' may look at any moment, whereas it looks only every " + period(Set.of(sensor)))
                .orElse("");
        boolean isCells = routes.stream().anyMatch(route -> route.isMisjudgedForCells(survey.response()));
        return scan + (isCells ? "; try " + finer() : "");
    }

    /** The options for smaller cells. */
    private String finer() {
        return 2 * inputs.grid().columns() <= FieldGrid.MOST_CELLS
                ? "--cell " + Numbers.text(0.5 * inputs.grid().cell()) + "m"
                : "a smaller --side with smaller cells";
    }

    private static List<String> sectors(RouteSurvey survey, Predicate<SectorRoute> which) {
        return survey.routes().stream().filter(which).map(RouteWords::sector).toList();
    }

    static String listed(List<String> sectors) {
        return String.join(", ", sectors).replaceFirst(", ([^,]+)$", " and $1");
    }

    /** From which sectors less detected routes may exist, which smaller cells may show; empty if there are none. */
    private Optional<String> unproven(RouteSurvey survey) {
        double response = survey.response();
        // Where a warning says the same, it is enough.
        List<String> sectors = sectors(
                survey,
                route -> route.isUnproven(response)
                        && !(route.isMisjudged(response) && route.isMisjudgedForCells(response)));
        return sectors.isEmpty()
                ? Optional.empty()
                : Optional.of("Less exposed routes from the " + listed(sectors)
                        + " cannot be ruled out: the lower bound of the exposure allows a detection"
                        + (survey.response() > 0.0 ? " in time" : "")
                        + " that is more than 20 percentage points less likely. To look for them between the middles of cells,"
                        + " try " + finer()
                        + new HeightNotes(inputs)
                                .closerToTheGround()
                                .map(how -> "; " + how)
                                .orElse("") + ".");
    }

    /**
     * Why the columns of the search and of the flights differ where both agree on the detections in time; empty if they
     * do not differ, or if it is warned that they differ on these, too.
     */
    private Optional<String> tooLate(RouteSurvey survey) {
        List<SectorRoute> routes = survey.routes().stream()
                .filter(route -> route.isMisjudgedTooLate(survey.response()))
                .toList();
        List<SectorRoute> scanned =
                routes.stream().filter(SectorRoute::isMisjudgedTooLateForScans).toList();
        return routes.isEmpty()
                ? Optional.empty()
                : Optional.of("On the " + (routes.size() == 1 ? "route" : "routes") + " from the "
                        + listed(routes.stream().map(RouteWords::sector).toList())
                        + ", 'search' and 'detected' differ by more than 20 percentage points, but only by detections that"
                        + " come too late: "
                        + disagreeing(scanned)
                                .map(sensor -> "the search assumes that '" + PlainText.value(sensor)
                                        + "' may look at any moment, whereas it looks only every "
                                        + period(Set.of(sensor)))
                                .orElse("the search knows only the middle of each cell")
                        + ".");
    }

    /**
     * On which routes a drone that cannot hover is assumed to fly much more slowly than it can, because it climbs or
     * descends steeply; empty if there are none.
     */
    private Optional<String> tooSlow(RouteSurvey survey) {
        DroneSettings drone = inputs.settings().individualDrones().get(inputs.drone());
        double limit = drone.flightLimits().hover() ? 0.0 : LEAST_SPEED * drone.speed();
        List<String> sectors = sectors(survey, route -> leastSpeed(route) < limit);
        OptionalDouble least =
                survey.routes().stream().mapToDouble(RouteNotes::leastSpeed).min();
        return sectors.isEmpty()
                ? Optional.empty()
                : Optional.of("The drone cannot hover, but steep legs of the "
                        + (sectors.size() == 1 ? "route" : "routes") + " from the " + listed(sectors)
                        + " are flown as slowly as its rates of climb and descent require, down to "
                        + number(least.orElseThrow()) + " m/s instead of " + number(drone.speed())
                        + " m/s: a real one would need a longer way there.");
    }

    /** The least speed along a route, m/s. */
    private static double leastSpeed(SectorRoute route) {
        List<RoutePoint> points = route.searched().points();
        double least = Double.POSITIVE_INFINITY;
        for (int i = 1; i < points.size(); i++) {
            double seconds = points.get(i).time() - points.get(i - 1).time();
            double length = points.get(i).distance() - points.get(i - 1).distance();
            least = seconds > 0.0 ? Math.min(least, length / seconds) : least;
        }
        return least;
    }

    /** Whether passages may exist that the search cannot find, since no cell shows them; empty if none is likely. */
    private Optional<String> unseen(UnseenPlaces between) {
        return between.unseen() == 0
                ? Optional.empty()
                : Optional.of("At " + number(between.unseen()) + " of " + number(between.tried())
                        + " places tried between the middles of cells, no sensor detects the drone, although all cells"
                        + " around the place are covered. Passages narrower than a cell, which the search cannot find,"
                        + " may lead through such places, and a route along one may be less exposed than the lower bound; to look for passages, try "
                        + finer()
                        + ".");
    }

    /**
     * The slow sensor whose looks disagree most with the search: summed over these routes, by how much the probability
     * that it detects the drone differs; to a whole percentage point, because where it differs only by when it detects
     * the drone, the sensor to which the drone is most exposed decides.
     */
    private Optional<String> disagreeing(List<SectorRoute> routes) {
        Map<String, SensorSettings<?>> sensors = inputs.settings().enabledSensors();
        return sensors.keySet().stream()
                .filter(sensor ->
                        RouteStarts.slowest(Map.of(sensor, sensors.get(sensor))).isPresent())
                .filter(sensor -> exposure(sensor, routes) > 0.0)
                .max(Comparator.comparingDouble((String sensor) -> Math.rint(100.0 * disagreement(sensor, routes)))
                        .thenComparingDouble(sensor -> exposure(sensor, routes)));
    }

    private static double disagreement(String sensor, List<SectorRoute> routes) {
        return routes.stream()
                .mapToDouble(route -> Math.abs(Math.exp(-route.sensors().getOrDefault(sensor, 0.0))
                        - Math.exp(-route.bySensor().getOrDefault(sensor, 0.0))))
                .sum();
    }

    private static double exposure(String sensor, List<SectorRoute> routes) {
        return routes.stream()
                .mapToDouble(route -> route.sensors().getOrDefault(sensor, 0.0))
                .sum();
    }

    /** States over which moments the figures of the flights are means; empty if all sensors look often. */
    private Optional<String> begins(RouteSurvey survey) {
        boolean isFlown =
                survey.routes().stream().anyMatch(route -> route.flown().isPresent());
        return RouteStarts.slowest(inputs.settings().enabledSensors())
                .filter(sensor -> isFlown)
                .map(sensor -> "All figures of flights are means over "
                        + RouteStarts.of(inputs.settings().enabledSensors().values())
                                .size()
                        + " flights of each route, which begin at moments spread over the " + period(Set.of(sensor))
                        + " between two looks of '"
                        + PlainText.value(sensor) + (isSearching(sensor) ? "' in the same direction." : "'."));
    }

    /** Whether a sensor turns, so that not all of its looks can detect a drone that stays where it is. */
    private boolean isSearching(String sensor) {
        return Mounted.positioner(inputs.settings().enabledSensors().get(sensor))
                .isPresent();
    }

    private String period(Set<String> sensors) {
        Map<String, SensorSettings<?>> these =
                new LinkedHashMap<>(inputs.settings().enabledSensors());
        these.keySet().retainAll(sensors);
        return Numbers.text(Math.rint(100.0 * RouteStarts.period(these.values())) / 100.0) + " s";
    }

    /** States which routes are too short for a detection in time; empty if none is, or no response is required. */
    private Optional<String> tooShort(RouteSurvey survey) {
        List<String> sectors = sectors(survey, route -> route.searched().end().time() < inputs.response());
        OptionalDouble longest = survey.routes().stream()
                .mapToDouble(route -> route.searched().end().time())
                .filter(seconds -> seconds < inputs.response())
                .max();
        return longest.isEmpty()
                ? Optional.empty()
                : Optional.of("no detection can be in time"
                        + (sectors.size() == survey.routes().size()
                                ? ", because each route takes "
                                : " on the " + (sectors.size() == 1 ? "route" : "routes") + " from the "
                                        + listed(sectors) + ", which " + (sectors.size() == 1 ? "takes " : "take "))
                        + RouteNumbers.seconds(longest) + (sectors.size() == 1 ? ", and" : " at most, and")
                        + " the response " + number(inputs.response())
                        + " s: let the routes begin farther away with a larger --side, if the site extends that far, or with"
                        + " --launch");
    }

    /**
     * States that it is not known whether an alert comes in time; empty if it is known, or if no response is required.
     */
    private Optional<String> withoutAlert(RouteResults results) {
        boolean isFlight = results.survey().routes().stream()
                .anyMatch(route -> route.route().seconds() > 0.0);
        return inputs.response() > 0.0 && results.timely().isEmpty() && isFlight
                ? Optional.of("The probability that an alert comes in time cannot be computed "
                        + (inputs.isCued()
                                ? "where sensors on positioners count as cued: flights have no cues."
                                : "for the alert rule of this scene, but only for rules by which a single sensor raises"
                                        + " the alert, after at most twelve looks."))
                : Optional.empty();
    }

    /** States on which routes cues make a difference; empty if there are none, or no flights with cues. */
    private Optional<String> cued(RouteResults results) {
        List<String> routes = new ArrayList<>();
        results.proofs().forEach((sector, proof) -> proof.withCues()
                .filter(cued -> !cued.agrees())
                .ifPresent(cued -> routes.add("on the route from the " + RouteWords.sector(sector) + " in "
                        + cued.flown().count() + " of " + cued.flown().of() + " flights instead of the predicted "
                        + RouteNumbers.percent(cued.predicted()))));
        return routes.isEmpty()
                ? Optional.empty()
                : Optional.of("With cues, the drone is detected " + String.join(", ", routes) + ".");
    }
}
