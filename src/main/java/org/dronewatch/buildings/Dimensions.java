package org.dronewatch.buildings;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.dronewatch.buildings.io.MapLength;

/**
 * How high a building is, and what its roof looks like, by the tags of OpenStreetMap (Simple 3D Buildings). Heights are
 * measured from the lowest ground under the building to the top of its roof.
 *
 * @param bottom height of its lowest point, 0 for a building that stands on the ground, m
 * @param top height of its highest point, m
 * @param basis what its height is taken from
 * @param roof the shape of its roof
 * @param rise rise of the roof from its eaves to its highest point, m; 0 for a flat one
 * @param direction direction in which the roof slopes down, rad clockwise from north, if the map states it
 * @param isAcross whether the ridge runs along the shorter side
 * @param isOpen whether there are no walls under the roof
 * @param doubts about what the map states, in words
 */
record Dimensions(
        double bottom,
        double top,
        Basis basis,
        RoofShape roof,
        double rise,
        OptionalDouble direction,
        boolean isAcross,
        boolean isOpen,
        List<String> doubts) {
    /** What the height of a building is taken from. */
    enum Basis {
        /** A height that the map states. */
        STATED,
        /** The number of levels that the map states. */
        LEVELS,
        /** The settings. */
        ASSUMED
    }

    /** Nothing that has been built is higher, m. */
    private static final double HIGHEST = 1000.0;

    private static final double MOST_LEVELS = 200.0;

    /** About thirty buildings in the world are higher, m. */
    private static final double FEW_ARE_HIGHER = 500.0;

    /**
     * The slenderest skyscraper is 24 times as high as wide. Up to the height MAST, m, a slender object may be a mast.
     */
    private static final double SLENDEREST = 30.0;

    private static final double MAST = 100.0;

    /** Tolerance for rounded figures on a map, m. */
    private static final double ROUNDED = 0.05;

    private static final List<String> WINDS =
            List.of("n", "nne", "ne", "ene", "e", "ese", "se", "sse", "s", "ssw", "sw", "wsw", "w", "wnw", "nw", "nnw");

    /** Reads the tags of one building. */
    private static final class Reader {
        private final Map<String, String> tags;
        private final List<String> doubts = new ArrayList<>();

        Reader(Map<String, String> tags) {
            this.tags = tags;
        }

        /** A length of 0 to {@link #HIGHEST}; anything else counts as not stated. */
        OptionalDouble length(String... keys) {
            for (String key : keys) {
                String text = tags.get(key);
                if (text != null) {
                    Optional<Double> length = MapLength.parse(text);
                    if (length.isPresent() && length.get() >= 0.0 && length.get() <= HIGHEST) {
                        return OptionalDouble.of(length.get());
                    }
                    refuse(key);
                }
            }
            return OptionalDouble.empty();
        }

        private void refuse(String key) {
            doubts.add("not used: " + key + "=" + tags.get(key));
        }

        OptionalDouble number(double most, String... keys) {
            for (String key : keys) {
                String text = tags.get(key);
                if (text != null) {
                    String plain = text.strip().replace(',', '.');
                    double value = plain.matches("\\d{1,3}(\\.\\d+)?") ? Double.parseDouble(plain) : Double.NaN;
                    if (value <= most) {
                        return OptionalDouble.of(value);
                    }
                    refuse(key);
                }
            }
            return OptionalDouble.empty();
        }

        /** Degrees, or the name of a compass point. */
        OptionalDouble direction() {
            String text = tags.get("roof:direction");
            int wind = text == null ? -1 : WINDS.indexOf(text.strip().toLowerCase(Locale.ROOT));
            OptionalDouble degrees =
                    wind >= 0 ? OptionalDouble.of(wind * 360.0 / WINDS.size()) : number(360.0, "roof:direction");
            return degrees.isPresent() ? OptionalDouble.of(Math.toRadians(degrees.getAsDouble())) : degrees;
        }

        RoofShape roof() {
            String text = tags.get("roof:shape");
            if (text == null) {
                return RoofShape.FLAT;
            }
            for (RoofShape shape : RoofShape.values()) {
                if (shape.name().equalsIgnoreCase(text.strip())) {
                    return shape;
                }
            }
            refuse("roof:shape");
            return RoofShape.FLAT;
        }
    }

    /**
     * The dimensions that tags state.
     *
     * @param tags tags of a building or a part
     * @param settings for what they do not state
     * @param outer the outline, m; the rise of a roof whose angle is stated depends on it
     */
    static Dimensions of(Map<String, String> tags, BuildingSettings settings, double[] outer) {
        Reader reader = new Reader(tags);
        double width = 2.0 * Rectangle.about(outer).halfWidth();
        OptionalDouble direction = reader.direction();
        boolean isAcross = "across".equals(tags.get("roof:orientation"));
        OptionalDouble height = reader.length("height", "building:height");
        OptionalDouble levels = reader.number(MOST_LEVELS, "building:levels", "levels");
        OptionalDouble roofLevels = reader.number(MOST_LEVELS, "roof:levels");
        OptionalDouble least = reader.length("min_height", "building:min_height");
        OptionalDouble leastLevel = reader.number(MOST_LEVELS, "building:min_level", "min_level");
        double bottom = least.orElse(leastLevel.orElse(0.0) * settings.levelHeight());
        RoofShape roof = reader.roof();
        double run = run(roof, RoofPlanes.rectangle(outer, direction, isAcross), width);
        double rise = roof == RoofShape.FLAT ? 0.0 : rise(reader, roof, roofLevels, width, run, settings);
        double top;
        if (height.isPresent()) {
            top = height.getAsDouble();
        } else if (levels.isPresent()) {
            double under = roof == RoofShape.FLAT ? roofLevels.orElse(0.0) * settings.levelHeight() : rise;
            top = levels.getAsDouble() * settings.levelHeight() + under;
        } else {
            top = bottom + settings.height();
        }
        double most = Math.max(0.0, top - bottom);
        if (rise > most + ROUNDED && most > 0.0) {
            roofOf(tags).ifPresent(stated -> reader.doubts.add("roof cut to the height of the building: " + stated));
        }
        rise = Math.min(rise, most);
        if (height.isPresent()) {
            reader.doubts.addAll(implausible(top, most, width));
        }
        return new Dimensions(
                bottom,
                top,
                height.isPresent() ? Basis.STATED : levels.isPresent() ? Basis.LEVELS : Basis.ASSUMED,
                rise > 0.0 ? roof : RoofShape.FLAT,
                rise,
                direction,
                isAcross,
                "roof".equals(tags.get("building")) || "roof".equals(tags.get("building:part")),
                List.copyOf(reader.doubts));
    }

    /** Whether the map does not state how high the building is. */
    boolean isAssumed() {
        return basis == Basis.ASSUMED;
    }

    /** What states how high the roof is, if anything does. */
    private static Optional<String> roofOf(Map<String, String> tags) {
        return Stream.of("roof:height", "roof:levels", "roof:angle")
                .filter(tags::containsKey)
                .map(key -> key + "=" + tags.get(key))
                .findFirst();
    }

    /** What suggests that a height is in another unit or mistyped; it is used all the same. */
    private static List<String> implausible(double top, double high, double width) {
        if (top > FEW_ARE_HIGHER) {
            return List.of(String.format(Locale.ROOT, "height of %.0f m, more than that of almost any building", top));
        }
        return high > MAST && high > SLENDEREST * width
                ? List.of(
                        String.format(Locale.ROOT, "height of %.0f m, more than %.0f times the width", top, SLENDEREST))
                : List.of();
    }

    /** From the eaves to the highest point along the slope whose angle a map states, in plan, m. */
    private static double run(RoofShape roof, Rectangle about, double width) {
        return switch (roof) {
            case GABLED -> about.halfWidth();
            case SKILLION -> 2.0 * about.halfWidth();
            case HIPPED -> Math.min(about.halfWidth(), about.halfLength());
            case FLAT, PYRAMIDAL, DOME -> 0.5 * width;
        };
    }

    private static double rise(
            Reader reader,
            RoofShape roof,
            OptionalDouble roofLevels,
            double width,
            double run,
            BuildingSettings settings) {
        OptionalDouble height = reader.length("roof:height");
        if (height.isPresent()) {
            return height.getAsDouble();
        }
        if (roofLevels.isPresent() && roofLevels.getAsDouble() > 0.0) {
            return roofLevels.getAsDouble() * settings.levelHeight();
        }
        OptionalDouble angle = reader.number(80.0, "roof:angle");
        if (angle.isPresent() && roof != RoofShape.DOME) {
            return run * Math.tan(Math.toRadians(angle.getAsDouble()));
        }
        return roof == RoofShape.DOME ? 0.5 * width : settings.levelHeight();
    }
}
