package org.dronewatch.report.route;

import static org.dronewatch.report.html.ReadableNumbers.number;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.SiteRoutes;
import org.dronewatch.route.proof.ProvenChance;
import org.dronewatch.route.proof.RouteStarts;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.setting.PlainText;

/** Notes on the figures of routes: over which flights they are means, and where they mislead. */
final class RouteNotes {
    /** The fraction of its endurance after which a drone has hardly any left. */
    private static final double EXHAUSTED = 0.99;

    private final RouteInputs inputs;
    private final SlowLooks looks;
    private final HeightNotes heights;
    private final SearchNotes search;

    RouteNotes(RouteInputs inputs) {
        this.inputs = inputs;
        this.looks = new SlowLooks(inputs.settings().enabledSensors());
        this.heights = new HeightNotes(inputs);
        this.search = new SearchNotes(inputs, looks, heights);
    }

    /** Notes on the results, one line each. */
    List<String> notes(RouteResults results) {
        RouteSurvey survey = results.survey();
        return Stream.of(
                        begins(survey).stream(),
                        search.replaced(results).stream(),
                        search.unproven(survey).stream(),
                        missing(survey).stream(),
                        exhausting(survey).stream(),
                        heights.belowCeiling().stream(),
                        heights.beginningHigh(survey).stream(),
                        search.unseen(results.between()).stream(),
                        search.tooLate(survey).stream(),
                        withoutAlert(results).stream(),
                        cued(results).stream(),
                        searching(results).stream())
                .flatMap(Function.identity())
                .toList();
    }

    /** What the search does that makes it misjudge a route; empty if it does not. */
    Optional<String> misjudgement(SectorRoute route, RouteSurvey survey) {
        return search.misjudgement(route, survey.response());
    }

    /** Warnings, one line each. */
    List<String> warnings(RouteSurvey survey) {
        return Stream.concat(tooShort(survey).stream(), search.misjudged(survey).stream())
                .toList();
    }

    /** States over which moments the figures of the flights are means; empty if all sensors look often. */
    private Optional<String> begins(RouteSurvey survey) {
        boolean isFlown =
                survey.routes().stream().anyMatch(route -> route.flown().isPresent());
        return looks.slowest()
                .filter(sensor -> isFlown)
                .map(sensor -> "All flight figures are means over "
                        + RouteStarts.of(inputs.settings().enabledSensors().values())
                                .size()
                        + " flights of each route, which begin at moments spread over the " + looks.period(sensor)
                        + " between successive looks by '"
                        + PlainText.value(sensor) + (isSearching(sensor) ? "' in the same direction." : "'."));
    }

    /**
     * The sectors from which there is no route; empty if there is one from each, or if not all sectors were searched.
     */
    private Optional<String> missing(RouteSurvey survey) {
        List<String> sectors = IntStream.range(0, SiteRoutes.SECTORS)
                .filter(sector -> RouteWords.route(sector, survey).isEmpty())
                .mapToObj(RouteWords::sector)
                .toList();
        // Not all sectors need to have a part of a launch area.
        boolean isMeant = survey.isComplete() && inputs.launch().isEmpty();
        return sectors.isEmpty() || !isMeant
                ? Optional.empty()
                : Optional.of("There is no route from the " + PlainText.list(sectors)
                        + ": either there is nowhere for the drone to start, or no path between the cells keeps within its"
                        + " limits on climb, descent, turns and endurance; a larger --side, a smaller --cell or other"
                        + " --heights may help.");
    }

    /** On which routes the drone has nothing left of its endurance at the end; empty if there are none. */
    private Optional<String> exhausting(RouteSurvey survey) {
        double endurance = inputs.settings()
                .individualDrones()
                .get(inputs.drone())
                .flightLimits()
                .endurance();
        List<SectorRoute> routes = survey.routes().stream()
                .filter(route -> ModeWords.powered(route, survey) > EXHAUSTED * endurance)
                .toList();
        return routes.isEmpty()
                ? Optional.empty()
                : Optional.of(
                        "On " + RouteDirections.routes(routes) + ", the drone flies for as long as its endurance of "
                                + number(endurance) + " s allows; with more endurance, it may be less exposed.");
    }

    /** Whether a sensor turns, so that not all of its looks can detect a drone that stays where it is. */
    private boolean isSearching(String sensor) {
        return Mounted.positioner(inputs.settings().enabledSensors().get(sensor))
                .isPresent();
    }

    /** States which routes are too short for a detection in time; empty if none is, or no response is required. */
    private Optional<String> tooShort(RouteSurvey survey) {
        List<SectorRoute> routes = survey.routes().stream()
                .filter(route -> route.searched().end().time() < inputs.response())
                .toList();
        OptionalDouble longest = routes.stream()
                .mapToDouble(route -> route.searched().end().time())
                .max();
        return longest.isEmpty()
                ? Optional.empty()
                : Optional.of("no detection can be in time"
                        + (routes.size() == survey.routes().size()
                                ? ", because " + (routes.size() == 1 ? "the" : "each") + " route takes "
                                : " on " + RouteDirections.routes(routes) + ", which "
                                        + (routes.size() == 1 ? "takes " : "take "))
                        + RouteNumbers.seconds(longest) + (routes.size() == 1 ? "" : " at most")
                        + ", whereas the response takes " + number(inputs.response())
                        + " s: let the routes begin farther away with a larger --side, if the site extends that far, or with"
                        + " --launch");
    }

    /**
     * States that it is not known whether an alert comes in time; empty if it is known, or if no response is required.
     */
    private Optional<String> withoutAlert(RouteResults results) {
        boolean isFlight = results.survey().routes().stream()
                .anyMatch(route -> route.route().seconds() > 0.0);
        return inputs.response() > 0.0 && !results.survey().isAlertKnown() && isFlight
                ? Optional.of("The probability that an alert comes in time cannot be computed "
                        + (inputs.isCued()
                                ? "where sensors on positioners count as cued: it is computed from flights without cues."
                                : "for the alert rule of this scene, but only for rules by which a single sensor raises"
                                        + " the alert, after at most twelve looks."))
                : Optional.empty();
    }

    /** States on which routes cues make a difference; empty if there are none, or no flights with cues. */
    private Optional<String> cued(RouteResults results) {
        List<String> routes = new ArrayList<>();
        results.proofs().forEach((sector, proof) -> proof.withCues()
                .map(cued -> asListed(cued, sector, results.survey()))
                .filter(cued -> !cued.agrees())
                .ifPresent(cued -> routes.add("on the route from the " + RouteWords.sector(sector) + " in "
                        + cued.flown().count() + " of " + cued.flown().of() + " flights instead of the "
                        + (inputs.isCued() ? "listed " : "predicted ")
                        + RouteNumbers.percent(cued.predicted()))));
        return routes.isEmpty()
                ? Optional.empty()
                : Optional.of("With cues, the drone is detected " + String.join(", ", routes) + ".");
    }

    /** Flights with cues, compared with the listed probability if that counts positioners as cued. */
    private ProvenChance asListed(ProvenChance cued, int sector, RouteSurvey survey) {
        return inputs.isCued()
                ? RouteWords.route(sector, survey)
                        .map(route -> new ProvenChance(route.detection(), 0.0, cued.flown()))
                        .orElse(cued)
                : cued;
    }

    /** States that a proof says nothing about sensors that count as cued; empty if none does, or there is no proof. */
    private Optional<String> searching(RouteResults results) {
        return inputs.isCued() && !results.proofs().isEmpty()
                ? Optional.of(
                        "In the flights that are compared with 'predicted', positioners only search. These flights"
                                + " therefore say nothing about the probabilities listed for the routes, which assume"
                                + " that positioners are cued.")
                : Optional.empty();
    }
}
