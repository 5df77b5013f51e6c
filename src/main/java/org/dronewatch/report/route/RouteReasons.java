package org.dronewatch.report.route;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.dronewatch.report.coverage.table.CoverageTable;
import org.dronewatch.report.html.ReadableNumbers;
import org.dronewatch.route.CauseTimes;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Cause;
import org.dronewatch.setting.Counted;

/**
 * What keeps sensors from detecting the drone on a route, in words: by sensor where their causes differ, since the
 * dominant cause is only that of the sensor that comes nearest to a detection.
 */
final class RouteReasons {
    /** With more sensors than this, those with the same main cause are counted together. */
    private static final int MOST_SENSORS = 4;

    /** Maximum number of causes that are stated for each sensor. */
    private static final int MOST_CAUSES = 3;

    /** Maximum number of sensors with the same main cause that are named. */
    private static final int MOST_NAMES = 3;

    /**
     * A sensor that misses the drone for less than this fraction of the flight is left out; so are further causes that
     * apply for less.
     */
    private static final double LEAST_SHARE = 0.05;

    /** A cause that does not apply all the time is not stated with 100 %. */
    private static final double HIGHEST_SHARE = 0.99;

    private static final double ROUNDING = 1e-9;

    private final SceneSettings settings;

    RouteReasons(SceneSettings settings) {
        this.settings = settings;
    }

    /**
     * For a table: {@code hidden by terrain most of the time}, or, where causes differ, {@code guard: out of view 74 %
     * of the time, too slow 19 %; ears: too quiet all the time}; empty if nothing keeps the sensors from detecting it.
     */
    Optional<String> inWords(SectorRoute route) {
        return differ(route) ? Optional.of(bySensor(route, MOST_CAUSES)) : common(route);
    }

    /** For a sentence, with only the main cause of each sensor: {@code , hidden by terrain most of the time}. */
    String clause(SectorRoute route) {
        return differ(route)
                ? " (" + bySensor(route, 1) + ")"
                : common(route).map(words -> ", " + words).orElse("");
    }

    /** Whether the main cause of a sensor differs from the one that is dominant for the longest time. */
    static boolean differ(SectorRoute route) {
        Optional<Cause> dominant = route.causes().dominant().longest();
        return dominant.isPresent()
                && missing(route).values().stream()
                        .flatMap(times -> times.longest().stream())
                        .anyMatch(cause -> cause != dominant.get());
    }

    /**
     * The causes of those sensors that do not detect the drone nearly all the time, by name: the order of the sensors
     * in the scene has no effect on a route.
     */
    private static Map<String, CauseTimes> missing(SectorRoute route) {
        Map<String, CauseTimes> missing = new TreeMap<>(route.causes().bySensor());
        missing.values().removeIf(times -> times.longest().isEmpty() || times.missed() < LEAST_SHARE - ROUNDING);
        return missing;
    }

    private static Optional<String> common(SectorRoute route) {
        CauseTimes dominant = route.causes().dominant();
        return dominant.longest().map(cause -> {
            double share = dominant.share(cause);
            String often = isAlways(share) ? " all the time" : share > 0.5 ? " most of the time" : " part of the time";
            return switch (cause) {
                case TOO_WEAK -> "too small, faint or quiet for the sensors" + often;
                case TOO_SLOW, TOO_FAST ->
                    "flying across radars' lines of sight or at a speed that they reject," + often;
                case UNKNOWN -> "with unknown ground between it and the sensors" + often;
                case SILENT ->
                    (isAlways(share) ? "" : share > 0.5 ? "mostly " : "part of the time ")
                            + "emitting nothing that the sensors can detect";
                default -> CoverageTable.name(cause) + often;
            };
        });
    }

    private String bySensor(SectorRoute route, int most) {
        Map<String, CauseTimes> missing = missing(route);
        Map<String, List<String>> sensors = new LinkedHashMap<>();
        missing.forEach((sensor, times) -> sensors.computeIfAbsent(
                        missing.size() > MOST_SENSORS ? main(sensor, times) : causes(sensor, times, most),
                        words -> new ArrayList<>())
                .add(sensor));
        return sensors.entrySet().stream()
                .map(one -> names(one.getValue()) + ": " + one.getKey())
                .collect(Collectors.joining("; "));
    }

    private static String names(List<String> sensors) {
        return sensors.size() > MOST_NAMES ? Counted.of(sensors.size(), "sensor") : String.join(", ", sensors);
    }

    private String main(String sensor, CauseTimes times) {
        Cause longest = times.longest().orElseThrow();
        return (times.share(longest) > 0.5 ? "mainly " : "partly ") + name(sensor, longest);
    }

    /** The causes of one sensor, the most frequent first: {@code out of view 74 % of the time, too slow 19 %}. */
    private String causes(String sensor, CauseTimes times, int most) {
        List<Cause> causes = times.seconds().keySet().stream()
                .filter(cause -> cause != Cause.DETECTED)
                .sorted(Comparator.comparingDouble(cause -> -times.share(cause)))
                .limit(most)
                .toList();
        Cause main = causes.get(0);
        if (isAlways(times.share(main))) {
            return name(sensor, main) + " all the time";
        }
        return name(sensor, main) + " " + percent(times.share(main)) + " of the time"
                + causes.stream()
                        .skip(1)
                        .filter(cause -> times.share(cause) >= LEAST_SHARE)
                        .map(cause -> ", " + name(sensor, cause) + " " + percent(times.share(cause)))
                        .collect(Collectors.joining());
    }

    private static boolean isAlways(double share) {
        return share > 1.0 - ROUNDING;
    }

    private static String percent(double share) {
        return ReadableNumbers.format("%.0f %%", 100.0 * Math.min(HIGHEST_SHARE, share));
    }

    private String name(String sensor, Cause cause) {
        return switch (cause) {
            case TOO_WEAK -> settings.sensors().get(sensor).description().weakness();
            case UNKNOWN -> "behind unknown ground";
            case SILENT -> "no recognised emission";
            default -> CoverageTable.name(cause);
        };
    }
}
