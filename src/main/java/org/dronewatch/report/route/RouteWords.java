package org.dronewatch.report.route;

import static org.dronewatch.report.html.ReadableNumbers.number;

import java.util.Comparator;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.dronewatch.report.CompassPoint;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.proof.FlownRoute;

/** Routes in words, for decision-makers. */
final class RouteWords {
    private final RouteInputs inputs;
    private final RouteReasons reasons;

    RouteWords(RouteInputs inputs) {
        this.inputs = inputs;
        this.reasons = new RouteReasons(inputs.settings());
    }

    /** The weakest of all routes in a sentence or two. */
    String weakest(RouteResults results) {
        RouteSurvey survey = results.survey();
        return survey.weakest()
                .map(route -> "On the weakest route, the drone comes " + from(route, survey) + ": " + detected(route)
                        + inTime(route, results) + ". Routes were searched for " + inputs.cellsInWords() + ".")
                .orElseGet(() -> survey.routes().isEmpty()
                        ? "No route leads to " + inputs.targetInWords() + "."
                        : "There is no weakest route: each ends where it begins, because the starting area touches "
                                + inputs.targetInWords() + "; try a larger --side"
                                + (inputs.launch().isPresent() ? ", or a --launch farther away." : "."));
    }

    /** {@code from the north-west, 12 m above the ground, hidden by terrain most of the time}. */
    private String from(SectorRoute route, RouteSurvey survey) {
        String height = number(Math.rint(route.profile().medianHeight())) + " m above the ground";
        return "from the " + sector(route) + ", " + height
                + ModeWords.clause(route, survey)
                // That radars reject the drone has been said.
                + (ModeWords.isMostlySlow(route, survey) && !RouteReasons.differ(route) ? "" : reasons.clause(route));
    }

    private String detected(SectorRoute route) {
        if (route.mostExposedTo().isEmpty()) {
            return "no sensor detects it on the way";
        }
        return "the drone is detected, " + by(route) + ", with a probability of "
                + RouteNumbers.percent(route.detection())
                + (RouteNumbers.isRare(route.detection()) ? "" : ", typically " + when(route));
    }

    /** The sensor that contributes most, and the next one if it contributes no more than half. */
    private static String by(SectorRoute route) {
        String sensor = route.mostExposedTo().orElseThrow();
        if (route.sensors().size() == 1) {
            return "by " + sensor;
        }
        if (route.share(sensor) > 0.5) {
            return (route.share(sensor) > 0.995 ? "only by " : "mostly by ") + sensor;
        }
        return "by "
                + route.sensors().keySet().stream()
                        .sorted(Comparator.comparingDouble(one -> -route.share(one)))
                        .limit(2)
                        .map(one -> one + " (" + RouteNumbers.percent(route.share(one)) + ")")
                        .collect(Collectors.joining(" and "));
    }

    /** The probabilities that decide which route is the weakest, and whether the response is in time. */
    private String inTime(SectorRoute route, RouteResults results) {
        if (inputs.response() == 0.0 || route.mostExposedTo().isEmpty()) {
            return "";
        }
        OptionalDouble alert = route.alertInTime();
        return ". The drone is detected in time with a probability of "
                + RouteNumbers.percent(route.inTime(inputs.response()))
                + (alert.isEmpty()
                        ? ""
                        : " if flight and response take exactly as long as planned; if their times vary by "
                                + RouteNumbers.percent(FlownRoute.SPREAD)
                                + ", an alert comes in time with a probability of "
                                + RouteNumbers.percent(alert.getAsDouble()));
    }

    /** When the drone is typically detected, compared with the response. */
    private String when(SectorRoute route) {
        double left = route.left().orElseThrow();
        if (inputs.response() == 0.0) {
            return number(RouteNumbers.tenths(left)) + " s before it reaches " + inputs.targetInWords();
        }
        double margin = RouteNumbers.tenths(left - inputs.response());
        String response = " for the response of " + number(inputs.response()) + " s";
        return margin < 0.0
                ? number(-margin) + " s too late" + response
                : "in time" + response + ", with " + number(margin) + " s to spare";
    }

    /** The sector from which a route comes, such as {@code north-west}. */
    static String sector(SectorRoute route) {
        return sector(route.sector());
    }

    /** A sector by its number, such as {@code north-west}. */
    static String sector(int number) {
        return CompassPoint.of(SectorRoute.bearing(number));
    }

    /** The route from a sector, by its number; empty if there is none. */
    static Optional<SectorRoute> route(int sector, RouteSurvey survey) {
        return survey.routes().stream()
                .filter(route -> route.sector() == sector)
                .findFirst();
    }
}
