package org.dronewatch.flight.track;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/**
 * The columns of a log that are read. A name may carry its unit: {@code altitude_m}, {@code height(feet)},
 * {@code time [ms]}.
 *
 * @param time column of the times, if the log has times
 * @param height column of the heights, if the log has heights
 */
record LogColumns(Optional<Column> time, Column latitude, Column longitude, Optional<Column> height) {
    private static final Pattern WITH_UNIT = Pattern.compile(
            "(.*?)[ _]*[\\[(]?(milliseconds?|microseconds?|seconds?|feet|foot|ft|meters?|metres?|degrees?|deg|ms|us|s|m|utc)[])]?");

    private static final Map<String, Double> UNITS = Map.ofEntries(
            Map.entry("millisecond", 1e-3),
            Map.entry("ms", 1e-3),
            Map.entry("microsecond", 1e-6),
            Map.entry("us", 1e-6),
            Map.entry("feet", 0.3048),
            Map.entry("foot", 0.3048),
            Map.entry("ft", 0.3048));

    private static final List<String> TIMES =
            List.of("time", "timestamp", "t", "elapsed", "datetime", "date_time", "seconds");
    private static final List<String> LATITUDES = List.of("latitude", "lat");
    private static final List<String> LONGITUDES = List.of("longitude", "lon", "lng", "long");
    private static final List<String> ABOVE_THE_SEA = List.of(
            "altitude_above_sealevel",
            "altitude_above_sea_level",
            "altitude_amsl",
            "alt_amsl",
            "altitude",
            "alt",
            "elevation",
            "ele",
            "height");
    /** Names that do not state the level from which a height is measured. */
    private static final List<String> PLAIN = List.of("altitude", "alt", "elevation", "ele");

    private static final List<String> ABOVE_THE_START = List.of(
            "height_above_takeoff",
            "height_above_take_off",
            "relative_altitude",
            "relative_alt",
            "rel_alt",
            "altitude_relative",
            "height");
    private static final List<String> ABOVE_THE_SURFACE = List.of(
            "height_above_ground",
            "height_above_ground_at_drone_location",
            "altitude_agl",
            "alt_agl",
            "height_agl",
            "agl",
            "height");

    /**
     * A column.
     *
     * @param index its index in a row
     * @param name name of the column in the file
     * @param unit factor by which its numbers are multiplied
     * @param isClock whether it may contain dates with times of day
     */
    record Column(int index, String name, double unit, boolean isClock) {}

    /**
     * Finds the columns of a header.
     *
     * @param file name of the file in messages
     * @param heights level from which heights are to be measured
     * @throws InputException when a column is missing
     */
    static LogColumns of(String file, List<String> header, Track.Heights heights) {
        Optional<Column> height =
                switch (heights) {
                    case SEA -> find(header, ABOVE_THE_SEA);
                    case START -> find(header, ABOVE_THE_START).or(() -> find(header, ABOVE_THE_SEA));
                    case SURFACE -> find(header, ABOVE_THE_SURFACE).or(() -> find(header, PLAIN));
                };
        if (height.isEmpty() && heights != Track.Heights.SURFACE) {
            throw missing(file, header, "height", heights == Track.Heights.SEA ? ABOVE_THE_SEA : ABOVE_THE_START);
        }
        return new LogColumns(
                find(header, TIMES),
                find(header, LATITUDES).orElseThrow(() -> missing(file, header, "latitude", LATITUDES)),
                find(header, LONGITUDES).orElseThrow(() -> missing(file, header, "longitude", LONGITUDES)),
                height);
    }

    private static InputException missing(String file, List<String> header, String what, List<String> names) {
        String known = header.stream().map(PlainText::value).collect(Collectors.joining(", "));
        return new InputException(file + ":1: no column for the " + what + ": none of " + String.join(", ", names)
                + " among " + PlainText.beginning(known, PlainText.LONGEST));
    }

    /** The column with the first of some names that occurs in the header. */
    private static Optional<Column> find(List<String> header, List<String> names) {
        for (String name : names) {
            for (int i = 0; i < header.size(); i++) {
                String plain = plain(header.get(i));
                Matcher matcher = WITH_UNIT.matcher(plain);
                if (plain.equals(name)) {
                    return Optional.of(new Column(i, PlainText.value(header.get(i)), 1.0, true));
                }
                if (matcher.matches() && matcher.group(1).equals(name)) {
                    String unit = matcher.group(2);
                    String single =
                            unit.length() > 2 && unit.endsWith("s") ? unit.substring(0, unit.length() - 1) : unit;
                    return Optional.of(new Column(
                            i, PlainText.value(header.get(i)), UNITS.getOrDefault(single, 1.0), unit.equals("utc")));
                }
            }
        }
        return Optional.empty();
    }

    private static String plain(String name) {
        return name.strip()
                .toLowerCase(Locale.ROOT)
                .replaceAll("[ _]+", "_")
                .replace("_(", "(")
                .replace("_[", "[");
    }

    String inWords() {
        return "columns " + time.map(column -> "'" + column.name() + "', ").orElse("") + "'" + latitude.name() + "', '"
                + longitude.name() + "'"
                + height.map(column -> ", '" + column.name() + "'")
                        .orElse("; there is no column of heights, so all heights are 0");
    }
}
