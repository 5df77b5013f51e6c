package org.dronewatch.report.route;

import static org.dronewatch.report.html.ReadableNumbers.number;

import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.dronewatch.analysis.field.FieldGrid;
import org.dronewatch.report.CompassPoint;
import org.dronewatch.report.Numbers;
import org.dronewatch.report.coverage.CoverageTable;
import org.dronewatch.report.html.ReadableNumbers;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.proof.RouteBegins;
import org.dronewatch.route.search.RouteMode;
import org.dronewatch.setting.PlainText;

/** Routes in words, for those who decide. */
final class RouteWords {
    private final RouteInputs inputs;

    RouteWords(RouteInputs inputs) {
        this.inputs = inputs;
    }

    /** The weakest of all routes in a sentence or two. */
    String weakest(RouteResults results) {
        RouteSurvey survey = results.survey();
        return survey.weakest()
                .map(route -> "The weakest route comes " + from(route, survey) + ": " + detected(route)
                        + inTime(route, results) + ".")
                .orElseGet(() -> survey.routes().isEmpty()
                        ? "No route leads to " + inputs.targetInWords() + "."
                        : "No route is the weakest, because all begin where they end: the area in which they begin is at "
                                + inputs.targetInWords() + "; try a larger --side"
                                + (inputs.launch().isPresent() ? ", or a --launch farther away." : "."));
    }

    /** Which routes the search misjudges, and which length of cells to try; empty if none. */
    Optional<String> misjudged(RouteSurvey survey) {
        List<String> sectors = survey.routes().stream()
                .filter(route -> route.isMisjudged(survey.response()))
                .map(RouteWords::sector)
                .toList();
        return sectors.isEmpty()
                ? Optional.empty()
                : Optional.of("the search in cells of "
                        + Numbers.text(inputs.grid().cell()) + " m misjudges the "
                        + (sectors.size() == 1 ? "route" : "routes") + " from the "
                        + String.join(", ", sectors).replaceFirst(", ([^,]+)$", " and $1")
                        + ": in flight, the chance of a detection, or of one in time, differs by more than 20 points"
                        + causes(survey));
    }

    /** Why the search misjudges routes, and what to try. */
    private String causes(RouteSurvey survey) {
        List<SectorRoute> routes = survey.routes().stream()
                .filter(route -> route.isMisjudged(survey.response()))
                .toList();
        Optional<String> slowest =
                RouteBegins.slowest(inputs.settings().enabledSensors()).map(PlainText::value);
        String scan =
                slowest.isPresent() && routes.stream().anyMatch(route -> route.isMisjudgedForScans(survey.response()))
                        ? ", because the search assumes that '" + slowest.get()
                                + "' may look at any moment, whereas it looks only every " + period()
                        : "";
        boolean isCells = routes.stream().anyMatch(route -> route.isMisjudgedForCells(survey.response()));
        boolean isFiner = isCells && 2 * inputs.grid().columns() <= FieldGrid.MOST_CELLS;
        return scan
                + (isFiner ? "; try --cell " + Numbers.text(0.5 * inputs.grid().cell()) + "m" : "");
    }

    /** States over which moments the figures of the flights are means; empty if all sensors look often. */
    Optional<String> begins(RouteSurvey survey) {
        boolean isFlown =
                survey.routes().stream().anyMatch(route -> route.flown().isPresent());
        return RouteBegins.slowest(inputs.settings().enabledSensors())
                .filter(sensor -> isFlown)
                .map(sensor -> "All figures of flights are means over " + RouteBegins.MOST
                        + " flights of each route, which begin at moments spread over the " + period() + " in which '"
                        + PlainText.value(sensor) + "' scans once.");
    }

    private String period() {
        return number(RouteBegins.period(inputs.settings().enabledSensors().values())) + " s";
    }

    /** States that no route is long enough for a detection in time; empty if one is, or no response is required. */
    Optional<String> tooShort(RouteSurvey survey) {
        OptionalDouble longest = survey.routes().stream()
                .mapToDouble(route -> route.searched().end().time())
                .max();
        return longest.isPresent() && longest.getAsDouble() < inputs.response()
                ? Optional.of("no detection can be in time, because each route takes " + seconds(longest)
                        + " at most, and the response " + number(inputs.response())
                        + " s: let the routes begin farther away with a larger --side, if the site extends that far, or by"
                        + " --launch")
                : Optional.empty();
    }

    /**
     * States that it is not known whether an alert comes in time; empty if it is known, or if no response is required.
     */
    Optional<String> withoutAlert(RouteResults results) {
        boolean isFlight = results.survey().routes().stream()
                .anyMatch(route -> route.route().seconds() > 0.0);
        return inputs.response() > 0.0 && results.timely().isEmpty() && isFlight
                ? Optional.of("The probability that an alert comes in time cannot be computed "
                        + (inputs.isCued()
                                ? "where sensors on positioners count as cued: flights have no cues."
                                : "for the alert rule of this scene: only for rules by which any sensor alone raises one,"
                                        + " after at most twelve looks."))
                : Optional.empty();
    }

    /** {@code from the north-west, 12 m above the ground, mostly hidden by terrain}. */
    private static String from(SectorRoute route, RouteSurvey survey) {
        String height = number(Math.rint(route.profile().medianHeight())) + " m above the ground";
        OptionalDouble glide = gliding(route, survey);
        return "from the " + sector(route) + ", " + height
                + (glide.isPresent() ? ", with its motors off for the last " + seconds(glide) : "")
                + reason(route).map(reason -> ", " + reason).orElse("");
    }

    /** Whether the drone may stop its motors. */
    static boolean mayGlide(RouteSurvey survey) {
        return survey.modes().stream().anyMatch(RouteMode::isGlide);
    }

    /** The time for which the drone flies with its motors off at the end, s; empty if they run all the time. */
    static OptionalDouble gliding(SectorRoute route, RouteSurvey survey) {
        double end = route.searched().end().time();
        return route.searched().points().stream()
                .filter(point -> survey.modes().get(point.mode()).isGlide())
                .mapToDouble(point -> end - point.time())
                .filter(time -> time > 0.0)
                .findFirst();
    }

    /** Why it is not detected for most of the time, {@code mostly hidden by terrain}; empty if it always is. */
    static Optional<String> reason(SectorRoute route) {
        return route.dominantCause().map(cause -> {
            String often = route.share(cause) > 0.5 ? "mostly" : "partly";
            return switch (cause) {
                case TOO_WEAK -> often + " too small, faint or quiet for the sensors";
                case TOO_SLOW -> often + " across the line of sight, or too slow";
                case UNKNOWN -> often + " where the line of sight leaves the known ground";
                default -> often + " " + CoverageTable.name(cause);
            };
        });
    }

    private String detected(SectorRoute route) {
        if (route.mostExposedTo().isEmpty()) {
            return "no sensor detects the drone on it";
        }
        return "the drone is detected with a probability of " + percent(route.detection()) + ", typically "
                + when(route) + "; " + by(route);
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
                        .map(one -> one + " (" + percent(route.share(one)) + ")")
                        .collect(Collectors.joining(" and "));
    }

    /** The probabilities that decide which route is the weakest, and whether it is met in time. */
    private String inTime(SectorRoute route, RouteResults results) {
        if (inputs.response() == 0.0 || route.mostExposedTo().isEmpty()) {
            return "";
        }
        Double alert = results.timely().get(route.sector());
        return ". It is detected in time with a probability of " + percent(route.inTime(inputs.response()))
                + (alert == null ? "" : ", and an alert comes in time with a probability of " + percent(alert));
    }

    /** When the drone is typically detected, compared with the response. */
    private String when(SectorRoute route) {
        double left = route.left().orElseThrow();
        if (inputs.response() == 0.0) {
            return number(tenths(left)) + " s before it reaches " + inputs.targetInWords();
        }
        double margin = tenths(left - inputs.response());
        String response = " for the response of " + number(inputs.response()) + " s";
        return margin < 0.0
                ? number(-margin) + " s too late" + response
                : "in time" + response + ", with " + number(margin) + " s to spare";
    }

    /** The sector from which a route comes, such as {@code north-west}. */
    static String sector(SectorRoute route) {
        return sector(route.sector());
    }

    /** The same by the number of the sector. */
    static String sector(int number) {
        return CompassPoint.of(SectorRoute.bearing(number));
    }

    /** The route from a sector, by its number; empty if there is none. */
    static Optional<SectorRoute> route(int sector, RouteSurvey survey) {
        return survey.routes().stream()
                .filter(route -> route.sector() == sector)
                .findFirst();
    }

    /** The time left, compared with the response: {@code 14 s late}; a dash without a detection. */
    static String margin(OptionalDouble left, double response) {
        if (left.isEmpty()) {
            return "-";
        }
        double margin = tenths(left.getAsDouble() - response);
        return number(Math.abs(margin)) + (margin < 0.0 ? " s late" : " s early");
    }

    /** A time, {@code 14.2 s}; a dash if there is none. */
    static String seconds(OptionalDouble time) {
        return time.isPresent() ? number(tenths(time.getAsDouble())) + " s" : "-";
    }

    /** A probability or a fraction in percent. */
    static String percent(double share) {
        return share == 0.0 ? "0 %" : ReadableNumbers.measured(share, "");
    }

    /** A probability in percent, or a dash where there is none. */
    static String orDash(Double probability) {
        return probability == null ? "-" : percent(probability);
    }

    /** An exposure. */
    static String exposure(double value) {
        return value == 0.0
                ? "0"
                : value < 0.001 ? "< 0.001" : String.format(Locale.ROOT, value < 1.0 ? "%.3f" : "%.2f", value);
    }

    private static double tenths(double value) {
        return Math.rint(10.0 * value) / 10.0 + 0.0;
    }
}
