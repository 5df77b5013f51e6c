package org.dronewatch.scenario;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.fusion.ProtectedArea;
import org.dronewatch.geo.EarthPlace;
import org.dronewatch.geo.EarthPoint;
import org.dronewatch.geo.FeaturePlace;
import org.dronewatch.geo.FeaturePoint;
import org.dronewatch.geo.LocalPlace;
import org.dronewatch.geo.LocalPoint;
import org.dronewatch.geo.features.Features;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.FormerNames;
import org.dronewatch.setting.In;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.file.Kinds;
import org.dronewatch.setting.file.Node;
import org.dronewatch.setting.file.SettingsFile;
import org.dronewatch.world.GroundPoint;
import org.dronewatch.world.Places;

/** The notations, besides coordinates in the scene's frame, in which scene files may state positions. */
public final class PlaceForms {
    private static final Pattern DEGREES = Pattern.compile("([-+]?[\\d.]+)\\s*,\\s*([-+]?[\\d.]+)");

    private PlaceForms() {}

    /**
     * The given kinds, extended by these notations for positions.
     *
     * @param places places of the scene; empty when they cannot be known, since the site's own settings are wrong
     * @param maps returns the features of a map by its file name or, without a file name, those of the map with the
     *     scene's name
     */
    public static Kinds in(Kinds kinds, Supplier<Optional<Places>> places, Function<Optional<String>, Features> maps) {
        return kinds.with(Position.class, EarthPlace.class, found(places, Places::at))
                .with(Position.class, LocalPlace.class, found(places, Places::at))
                .with(
                        Position.class,
                        FeaturePlace.class,
                        found(
                                places,
                                (known, place) -> known.at(maps.apply(place.file())
                                        .place(place.feature(), place.above(), place.height()))))
                .with(GroundPoint.class, EarthPoint.class, found(places, Places::at))
                .with(
                        GroundPoint.class,
                        LocalPoint.class,
                        point -> Optional.of(new GroundPoint(point.east(), point.north())))
                .with(
                        GroundPoint.class,
                        FeaturePoint.class,
                        found(
                                places,
                                (known, point) ->
                                        known.at(maps.apply(point.file()).point(point.feature()))));
    }

    /** The given kinds, extended by these notations, but without places and maps: only for describing the notations. */
    public static Kinds in(Kinds kinds) {
        return in(kinds, Optional::empty, file -> {
            throw new IllegalArgumentException("no map is known");
        });
    }

    /** A place alone. */
    record Alone(Position at) {}

    /**
     * The position of a place given on the command line: as in a scene file, or as latitude and longitude in degrees,
     * separated by a comma.
     *
     * @param option name of the option in messages, such as {@code --from}
     * @param directory directory against which relative file names are resolved
     * @param maps returns the features of a map
     * @throws InputException with a one-line message when the text is not a place, or the place has no position
     */
    public static Position parse(
            String option, String text, Places places, Path directory, Function<Optional<String>, Features> maps) {
        Matcher pair = DEGREES.matcher(text.strip());
        String place = pair.matches()
                ? "{latitude: " + pair.group(1) + " deg, longitude: " + pair.group(2) + " deg}"
                : text.strip();
        return read(option, text, place, Alone.class, places, directory, maps).at();
    }

    /** An outline in plan view alone. */
    private record Outline(
            List<GroundPoint> area,
            Optional<GroundPoint> centre,
            @In(value = Quantity.LENGTH, above = 0, to = In.FARTHEST) Optional<Double> radius) {
        @Defaults({})
        static Outline none() {
            return new Outline(List.of(), Optional.empty(), Optional.empty());
        }
    }

    /** An outline that is given on the command line. */
    private record OutlineAlone(Outline at) {}

    /**
     * An area given on the command line as in a scene file, in plan view: {@code {centre: [0, 900], radius: 50 m}} or
     * {@code {area: [...]}}. Arguments as for {@link #parse}.
     *
     * @throws InputException with a one-line message when the text is not an area, or the area has no position
     */
    public static ProtectedArea area(
            String option, String text, Places places, Path directory, Function<Optional<String>, Features> maps) {
        Outline outline = read(option, text, text.strip(), OutlineAlone.class, places, directory, maps)
                .at();
        try {
            ProtectedArea area =
                    new ProtectedArea(outline.area(), outline.centre(), outline.radius(), 0.0, Double.MIN_NORMAL);
            AlertSettings.DEFAULT.withZone("area", area);
            return area;
        } catch (IllegalArgumentException e) {
            throw new InputException(
                    option + " " + PlainText.value(text) + ": " + e.getMessage().replace("zones.area: ", ""), e);
        }
    }

    /** A record whose component {@code at} is given on the command line. */
    private static <R extends Record> R read(
            String option,
            String text,
            String written,
            Class<R> type,
            Places places,
            Path directory,
            Function<Optional<String>, Features> maps) {
        String shown = option + " " + PlainText.value(text) + ": ";
        try {
            Node.Mapping document = SettingsFile.document(
                    option, new ByteArrayInputStream(("at: " + written).getBytes(StandardCharsets.UTF_8)));
            Kinds kinds = in(Kinds.FOUND, () -> Optional.of(places), maps);
            return SettingsFile.read(document, type, kinds, directory, new FormerNames());
        } catch (InputException e) {
            String first = e.getMessage()
                    .lines()
                    .filter(line -> line.contains(": unknown "))
                    .findFirst()
                    .orElseGet(() -> e.getMessage().lines().findFirst().orElse(""));
            throw new InputException(
                    shown + first.replaceFirst("^\\Q" + option + "\\E:\\d+:\\d+: (at(\\.\\w+)?: )?", ""), e);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static <F, T> Function<F, Optional<T>> found(Supplier<Optional<Places>> places, At<F, T> at) {
        return written -> places.get().map(known -> at.of(known, written));
    }

    /** One of the methods of {@link Places}. */
    private interface At<F, T> {
        T of(Places places, F written);
    }
}
