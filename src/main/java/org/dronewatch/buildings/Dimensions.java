package org.dronewatch.buildings;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.buildings.io.MapLength;

/**
 * How high a building is, and what its roof looks like, by the tags of OpenStreetMap (Simple 3D Buildings). Heights
 * count from the lowest ground under the building to the top of its roof.
 *
 * @param bottom height of its lowest point, 0 for what stands on the ground, m
 * @param top height of its highest point, m
 * @param isAssumed whether the map does not state how high it is
 * @param roof the shape of its roof
 * @param rise of the roof from its eaves to its highest point, m; 0 for a flat one
 * @param direction in which the roof slopes down, rad clockwise from north, if the map states it
 * @param isAcross whether the ridge runs along the shorter side
 * @param isOpen whether there are no walls under the roof
 * @param doubts what of the map could not be used, in words
 */
record Dimensions(
        double bottom,
        double top,
        boolean isAssumed,
        RoofShape roof,
        double rise,
        OptionalDouble direction,
        boolean isAcross,
        boolean isOpen,
        List<String> doubts) {
    /** Nothing built is higher. */
    private static final double HIGHEST = 1000.0;

    private static final double MOST_LEVELS = 200.0;
    private static final List<String> WINDS =
            List.of("n", "nne", "ne", "ene", "e", "ese", "se", "sse", "s", "ssw", "sw", "wsw", "w", "wnw", "nw", "nnw");

    /** Reads the tags of one building. */
    private static final class Reader {
        private final Map<String, String> tags;
        private final List<String> doubts = new ArrayList<>();

        Reader(Map<String, String> tags) {
            this.tags = tags;
        }

        /** A length of 0 to {@link #HIGHEST}; what is none counts as not stated. */
        OptionalDouble length(String... keys) {
            for (String key : keys) {
                String text = tags.get(key);
                if (text != null) {
                    Optional<Double> length = MapLength.parse(text);
                    if (length.isPresent() && length.get() >= 0.0 && length.get() <= HIGHEST) {
                        return OptionalDouble.of(length.get());
                    }
                    doubts.add(key + "=" + text);
                }
            }
            return OptionalDouble.empty();
        }

        OptionalDouble number(double most, String... keys) {
            for (String key : keys) {
                String text = tags.get(key);
                if (text != null) {
                    String plain = text.strip().replace(',', '.');
                    double value = plain.matches("\\d{1,3}(\\.\\d{1,9})?") ? Double.parseDouble(plain) : Double.NaN;
                    if (value <= most) {
                        return OptionalDouble.of(value);
                    }
                    doubts.add(key + "=" + text);
                }
            }
            return OptionalDouble.empty();
        }

        /** Degrees, or the name of a wind. */
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
            doubts.add("roof:shape=" + text);
            return RoofShape.FLAT;
        }
    }

    /**
     * The dimensions that tags state.
     *
     * @param tags of a building or a part
     * @param settings for what they do not state
     * @param width of the building across the ridge, for roofs whose angle is stated, m
     */
    static Dimensions of(Map<String, String> tags, BuildingSettings settings, double width) {
        Reader reader = new Reader(tags);
        OptionalDouble height = reader.length("height", "building:height");
        OptionalDouble levels = reader.number(MOST_LEVELS, "building:levels", "levels");
        OptionalDouble roofLevels = reader.number(MOST_LEVELS, "roof:levels");
        OptionalDouble least = reader.length("min_height", "building:min_height");
        OptionalDouble leastLevel = reader.number(MOST_LEVELS, "building:min_level", "min_level");
        double bottom = least.orElse(leastLevel.orElse(0.0) * settings.levelHeight());
        RoofShape roof = reader.roof();
        boolean isAssumed = height.isEmpty() && levels.isEmpty();
        double rise = roof == RoofShape.FLAT ? 0.0 : rise(reader, roof, roofLevels, width, settings);
        double top;
        if (height.isPresent()) {
            top = height.getAsDouble();
        } else if (levels.isPresent()) {
            double under = roof == RoofShape.FLAT ? roofLevels.orElse(0.0) * settings.levelHeight() : rise;
            top = levels.getAsDouble() * settings.levelHeight() + under;
        } else {
            top = bottom + settings.height();
        }
        rise = Math.min(rise, Math.max(0.0, top - bottom));
        return new Dimensions(
                bottom,
                top,
                isAssumed,
                rise > 0.0 ? roof : RoofShape.FLAT,
                rise,
                reader.direction(),
                "across".equals(tags.get("roof:orientation")),
                "roof".equals(tags.get("building")) || "roof".equals(tags.get("building:part")),
                List.copyOf(reader.doubts));
    }

    private static double rise(
            Reader reader, RoofShape roof, OptionalDouble roofLevels, double width, BuildingSettings settings) {
        OptionalDouble height = reader.length("roof:height");
        if (height.isPresent()) {
            return height.getAsDouble();
        }
        if (roofLevels.isPresent() && roofLevels.getAsDouble() > 0.0) {
            return roofLevels.getAsDouble() * settings.levelHeight();
        }
        OptionalDouble angle = reader.number(80.0, "roof:angle");
        if (angle.isPresent() && roof != RoofShape.DOME) {
            double over = roof == RoofShape.SKILLION ? width : 0.5 * width;
            return over * Math.tan(Math.toRadians(angle.getAsDouble()));
        }
        return roof == RoofShape.DOME ? 0.5 * width : settings.levelHeight();
    }
}
