package org.dronewatch.buildings.io;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.geo.MapExtent;
import org.dronewatch.geo.features.GeoJsonSystem;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.input.FileHash;
import tools.jackson.databind.JsonNode;

/**
 * Reads outlines from GeoJSON (RFC 7946): polygons and multipolygons, whose properties are taken as tags of
 * OpenStreetMap ({@code height}, {@code building:levels}, {@code levels}, ...). Every area is a building, unless
 * {@code building} is {@code no}. If land cover is requested, areas and lines whose properties state it are land cover,
 * unless they are buildings, too. The older member {@code crs}, which most programs still write for coordinates of a
 * grid, is read as well.
 */
final class GeoJsonFile {
    private static final int MOST_DEPTH = 64;

    /** Longitudes may run on beyond the date line. */
    private static final double MOST_LONGITUDE = 360.0;

    private static final double MOST_LATITUDE = 90.0;

    private final String file;
    private final List<MapFeature> features = new ArrayList<>();
    private final Map<String, Integer> leftOut = new LinkedHashMap<>();

    private final boolean withLand;
    private final List<MapShape> shapes = new ArrayList<>();
    private final MapExtent.Collector extent = new MapExtent.Collector();
    private Optional<String> foreign = Optional.empty();

    private GeoJsonFile(String file, boolean withLand) {
        this.file = file;
        this.withLand = withLand;
    }

    /**
     * Reads a file.
     *
     * @param file its name, for messages
     * @param withLand whether land cover is requested
     * @param hash hash of the file
     * @throws InputException with a one-line message when it is not GeoJSON
     */
    static MapFeatures read(String file, JsonNode root, boolean withLand, FileHash hash) {
        GeoJsonFile reader = new GeoJsonFile(file, withLand);
        String type = root.path("type").asString("");
        if (!List.of("FeatureCollection", "Feature", "Polygon", "MultiPolygon", "GeometryCollection")
                .contains(type)) {
            throw new InputException(file + ": 'type' is '" + PlainText.value(type)
                    + "' but must be FeatureCollection or CityJSON: not a map with areas");
        }
        reader.object(root, "geometry", Map.of(), 0);
        MapSystem system = new MapSystem(
                MapSystem.Rule.DEGREES, GeoJsonSystem.stated(root), "crs", reader.extent.extent(), reader.foreign);
        return new MapFeatures(
                reader.features, Optional.empty(), new MapLand(reader.shapes), reader.leftOut, "GeoJSON", system, hash);
    }

    private void object(JsonNode node, String id, Map<String, String> tags, int depth) {
        if (depth > MOST_DEPTH) {
            throw new InputException(file + ": nested more than " + MOST_DEPTH + " deep");
        }
        String type = node.path("type").asString("");
        switch (type) {
            case "FeatureCollection" -> {
                int number = 0;
                for (JsonNode feature : node.path("features")) {
                    object(feature, "feature/" + number++, Map.of(), depth + 1);
                }
            }
            case "Feature" -> {
                JsonNode own = node.path("id");
                object(
                        node.path("geometry"),
                        own.isValueNode() && !own.isNull() ? own.asString() : id,
                        tags(node.path("properties")),
                        depth + 1);
            }
            case "GeometryCollection" -> node.path("geometries").forEach(part -> object(part, id, tags, depth + 1));
            case "Polygon" -> polygon(node.path("coordinates"), id, tags);
            case "MultiPolygon" -> node.path("coordinates").forEach(polygon -> polygon(polygon, id, tags));
            case "LineString" -> line(type, List.of(node.path("coordinates")), id, tags);
            case "MultiLineString" -> line(type, node.path("coordinates"), id, tags);
            case "" -> leave("feature without a geometry");
            default -> leave(type);
        }
    }

    private void leave(String what) {
        leftOut.merge(what, 1, Integer::sum);
    }

    private static Map<String, String> tags(JsonNode properties) {
        Map<String, String> tags = new HashMap<>();
        properties.properties().forEach(property -> {
            JsonNode value = property.getValue();
            if (value.isValueNode() && !value.isNull()) {
                tags.put(property.getKey(), value.asString());
            }
        });
        return tags;
    }

    private void line(String type, Iterable<JsonNode> lines, String id, Map<String, String> tags) {
        if (!withLand || !MapLand.isLand(tags)) {
            leave(type);
            return;
        }
        List<double[]> read = new ArrayList<>();
        lines.forEach(line -> read.add(corners(line, id)));
        shapes.add(new MapShape(id, false, read, tags));
    }

    private void polygon(JsonNode rings, String id, Map<String, String> tags) {
        MapFeature plain = new MapFeature(id, List.of(), List.of(), tags);
        boolean isLand = withLand && MapLand.isLand(tags);
        boolean isFeature = plain.isWood() || !isLand && !"no".equals(tags.get("building"));
        if (!isFeature && !isLand) {
            return;
        }
        List<double[]> read = new ArrayList<>();
        for (JsonNode ring : rings) {
            read.add(ring(ring, id));
        }
        if (isLand) {
            shapes.add(new MapShape(id, true, read, tags));
        }
        if (!isFeature) {
            return;
        }
        if (read.isEmpty()) {
            leave("polygon without corners");
        } else {
            features.add(new MapFeature(id, read.subList(0, 1), read.subList(1, read.size()), tags));
        }
    }

    private double[] ring(JsonNode corners, String id) {
        double[] ring = corners(corners, id);
        int count = ring.length / 2;
        boolean isClosed = count > 1 && ring[0] == ring[2 * count - 2] && ring[1] == ring[2 * count - 1];
        return isClosed ? Arrays.copyOf(ring, 2 * count - 2) : ring;
    }

    private double[] corners(JsonNode corners, String id) {
        int count = corners.size();
        double[] ring = new double[2 * count];
        for (int i = 0; i < count; i++) {
            JsonNode corner = corners.get(i);
            for (int axis = 0; axis < 2; axis++) {
                JsonNode value = corner.path(axis);
                if (!value.isNumber() || !Double.isFinite(value.doubleValue())) {
                    throw new InputException(file + ": " + PlainText.value(id) + ": corner " + i + " of an outline is "
                            + PlainText.value(corner) + " but must be numbers: [longitude, latitude]");
                }
                ring[2 * i + axis] = value.doubleValue();
            }
            extent.add(ring[2 * i], ring[2 * i + 1]);
            boolean isDegrees = Math.abs(ring[2 * i]) <= MOST_LONGITUDE && Math.abs(ring[2 * i + 1]) <= MOST_LATITUDE;
            if (!isDegrees && foreign.isEmpty()) {
                foreign = Optional.of(
                        PlainText.value(id) + ": corner " + i + " of an outline is " + PlainText.value(corner));
            }
        }
        return ring;
    }
}
