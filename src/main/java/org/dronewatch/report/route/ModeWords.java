package org.dronewatch.report.route;

import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.route.RoutePoint;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.search.RouteMode;

/** The modes of flight on routes, other than under power at cruise speed, in words and times. */
final class ModeWords {
    private static final double HUNDRED = 100.0;

    private ModeWords() {}

    /**
     * {@code , flying at 2.97 m/s, which a radar rejects, for 40 s, with its motors off for the last 20 s}; empty
     * if it does neither.
     */
    static String clause(SectorRoute route, RouteSurvey survey) {
        OptionalDouble slow = slowed(route, survey);
        OptionalDouble glide = gliding(route, survey);
        return (slow.isPresent()
                        ? ", flying at " + speeds(Stream.of(route), survey) + ", which a radar rejects, for "
                                + RouteNumbers.seconds(slow)
                        : "")
                + (glide.isPresent() ? ", with its motors off for the last " + RouteNumbers.seconds(glide) : "");
    }

    /** What the drone may do besides: {@code ; it may slow down to 2.97 m/s, and may stop its motors once}. */
    static String abilities(RouteSurvey survey) {
        String speeds = speeds(survey.modes().stream().filter(RouteMode::isSlow));
        boolean isAlwaysSlow = survey.modes().stream().allMatch(mode -> mode.isSlow() || mode.isGlide());
        return (speeds.isEmpty()
                        ? ""
                        : isAlwaysSlow ? ", at " + speeds : "; it may slow down to " + speeds + " at any time")
                + (survey.modes().stream().anyMatch(RouteMode::isGlide)
                        ? ", and may stop its motors once and then glide"
                        : "");
    }

    /** Whether the drone slows down on any of the routes. */
    static boolean areSlow(RouteSurvey survey) {
        return survey.routes().stream().anyMatch(route -> slowed(route, survey).isPresent());
    }

    /** Whether the drone stops its motors on any of the routes. */
    static boolean areGlides(RouteSurvey survey) {
        return survey.routes().stream().anyMatch(route -> gliding(route, survey).isPresent());
    }

    /** The speeds to which the drone slows down on the routes, {@code 2.97 or 0.99 m/s}. */
    static String slowSpeeds(RouteSurvey survey) {
        return speeds(survey.routes().stream(), survey);
    }

    private static String speeds(Stream<SectorRoute> routes, RouteSurvey survey) {
        return speeds(routes.flatMap(route -> route.searched().points().stream())
                .mapToInt(RoutePoint::mode)
                .distinct()
                .sorted()
                .mapToObj(survey.modes()::get)
                .filter(RouteMode::isSlow));
    }

    private static String speeds(Stream<RouteMode> slow) {
        String words = slow.map(mode -> Numbers.text(Math.rint(HUNDRED * mode.speed()) / HUNDRED))
                .distinct()
                .collect(Collectors.joining(" or "));
        return words.isEmpty() ? "" : words + " m/s";
    }

    /** For how long the drone flies slowly, s; empty if it does not. */
    static OptionalDouble slowed(SectorRoute route, RouteSurvey survey) {
        double time = 0.0;
        List<RoutePoint> points = route.searched().points();
        for (int i = 1; i < points.size(); i++) {
            if (isIn(survey, RouteMode::isSlow, points.get(i - 1))) {
                time += points.get(i).time() - points.get(i - 1).time();
            }
        }
        return time > 0.0 ? OptionalDouble.of(time) : OptionalDouble.empty();
    }

    /** For how long the drone flies under power, s. */
    static double powered(SectorRoute route, RouteSurvey survey) {
        double end = route.searched().end().time();
        return end - gliding(route, survey).orElse(0.0);
    }

    /** Whether the drone flies slowly for more than half of a route's time. */
    static boolean isMostlySlow(SectorRoute route, RouteSurvey survey) {
        return slowed(route, survey).orElse(0.0) > 0.5 * route.searched().end().time();
    }

    /** The time for which the drone flies with its motors off at the end, s; empty if they run all the time. */
    static OptionalDouble gliding(SectorRoute route, RouteSurvey survey) {
        double end = route.searched().end().time();
        return route.searched().points().stream()
                .filter(point -> isIn(survey, RouteMode::isGlide, point))
                .mapToDouble(point -> end - point.time())
                .filter(time -> time > 0.0)
                .findFirst();
    }

    /** Whether the drone flies on from a point in such a mode. */
    static boolean isIn(RouteSurvey survey, Predicate<RouteMode> kind, RoutePoint point) {
        return kind.test(survey.modes().get(point.mode()));
    }
}
