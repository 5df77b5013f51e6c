package org.dronewatch.geo.features;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.geo.EarthPlace;
import org.dronewatch.geo.EarthPoint;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.Spelling;

/** The named features of a GeoJSON or KML file. Immutable. */
public final class Features {
    /** The largest file that is read, bytes. */
    public static final int LARGEST = 16 << 20;

    /** The greatest number of features that are read. */
    static final int MOST = 100_000;

    /** The greatest height, up or down, m. */
    static final double HIGHEST = 100_000.0;

    private final String file;
    private final Map<String, List<Feature>> all;

    private Features(String file, Map<String, List<Feature>> all) {
        this.file = file;
        this.all = all;
    }

    /** Collects the features of a file. For a single use. */
    static final class Found {
        private final String file;
        private final Map<String, List<Feature>> all = new LinkedHashMap<>();
        private int count;

        Found(String file) {
            this.file = file;
        }

        void add(String name, Feature feature) {
            if (++count > MOST) {
                throw new InputException(file + ":" + feature.where() + ": more than " + MOST + " features");
            }
            all.computeIfAbsent(name.strip(), unseen -> new ArrayList<>(1)).add(feature);
        }

        double number(double value, String where, String what, double most) {
            if (!(Math.abs(value) <= most)) {
                throw new InputException(
                        file + ":" + where + ": " + what + " " + value + " must be " + -most + " to " + most);
            }
            return value;
        }

        EarthPoint point(double longitude, double latitude, String where) {
            return new EarthPoint(
                    Math.toRadians(number(latitude, where, "latitude", 90.0)),
                    Math.toRadians(number(longitude, where, "longitude", 180.0)));
        }
    }

    /**
     * Reads a file, whose format is recognised by its beginning.
     *
     * @param shown name of the file in messages
     * @throws InputException with a one-line message when it is neither GeoJSON nor KML, or a point in it is invalid
     */
    public static Features read(String shown, byte[] bytes) {
        String file = PlainText.value(shown);
        Found found = new Found(file);
        int first = 0;
        while (first < bytes.length && (bytes[first] < 0 || Character.isWhitespace(bytes[first]))) {
            first++;
        }
        char begins = first < bytes.length ? (char) bytes[first] : ' ';
        switch (begins) {
            case '<' -> new KmlFeatures(file, found).read(bytes);
            case '{' -> new GeoJsonFeatures(file, found).read(bytes);
            case 'P' -> throw new InputException(file + ": is compressed: extract the .kml file from it");
            default -> throw new InputException(file + ": is neither GeoJSON nor KML");
        }
        return new Features(file, found.all);
    }

    /**
     * The point with this name.
     *
     * @throws IllegalArgumentException when there is no such feature, there are several, or it is not a point
     */
    public EarthPoint point(String name) {
        return only(name).point().orElseThrow();
    }

    /**
     * The place of the feature with this name, at the given height if there is one. Otherwise the place is at the
     * height in the file, if the datum of that height is stated, or else on the surface.
     *
     * @param above height above the surface, m
     * @param height height above sea level, m
     * @throws IllegalArgumentException when there is no such feature, there are several, it is not a point, or the
     *     datum of its height is not stated
     */
    public EarthPlace place(String name, Optional<Double> above, Optional<Double> height) {
        Feature feature = only(name);
        EarthPoint point = feature.point().orElseThrow();
        if (above.isPresent() || height.isPresent()) {
            return new EarthPlace(point.latitude(), point.longitude(), above, height);
        }
        if (feature.unclear().isPresent()) {
            throw new IllegalArgumentException("feature '" + PlainText.value(name) + "' has a height of "
                    + feature.unclear().getAsDouble() + " m in " + file + ", which does not state its reference:"
                    + " give 'above' or 'height'");
        }
        return new EarthPlace(point.latitude(), point.longitude(), boxed(feature.above()), boxed(feature.height()));
    }

    private static Optional<Double> boxed(OptionalDouble value) {
        return value.isPresent() ? Optional.of(value.getAsDouble()) : Optional.empty();
    }

    private Feature only(String name) {
        List<Feature> named = all.getOrDefault(name.strip(), List.of());
        String shown = "feature '" + PlainText.value(name) + "'";
        if (named.isEmpty()) {
            List<String> names = all.keySet().stream().map(PlainText::value).toList();
            throw new IllegalArgumentException(shown + ": there is none in " + file + "; "
                    + (names.isEmpty() ? "nothing there has a name" : Spelling.closestMatches(name, names)));
        }
        if (named.size() > 1) {
            throw new IllegalArgumentException(shown + ": there are " + named.size() + " in " + file
                    + (named.size() > 2 ? ", the first two at " : ", at ")
                    + named.get(0).where() + " and " + named.get(1).where());
        }
        if (named.get(0).point().isEmpty()) {
            throw new IllegalArgumentException(shown + " at " + named.get(0).where() + " of " + file + " is a "
                    + PlainText.value(named.get(0).shape()) + " but must be a Point");
        }
        return named.get(0);
    }
}
