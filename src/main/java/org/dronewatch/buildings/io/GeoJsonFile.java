package org.dronewatch.buildings.io;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import tools.jackson.databind.JsonNode;

/**
 * Reads outlines from GeoJSON (RFC 7946): polygons and multipolygons, whose properties are taken as tags of
 * OpenStreetMap ({@code height}, {@code building:levels}, {@code levels}, ...). Every area is a building, unless
 * {@code building} is {@code no}.
 */
final class GeoJsonFile {
    private static final int MOST_DEPTH = 64;

    private final String file;
    private final List<MapFeature> features = new ArrayList<>();
    private final Map<String, Integer> leftOut = new LinkedHashMap<>();

    private GeoJsonFile(String file) {
        this.file = file;
    }

    /** What was read: features, and what was left out. */
    record Read(List<MapFeature> features, Map<String, Integer> leftOut) {}

    /**
     * Reads a file.
     *
     * @param file its name, for messages
     * @throws InputException in one line when it is not GeoJSON
     */
    static Read read(String file, JsonNode root) {
        GeoJsonFile reader = new GeoJsonFile(file);
        String type = root.path("type").asString("");
        if (!List.of("FeatureCollection", "Feature", "Polygon", "MultiPolygon", "GeometryCollection")
                .contains(type)) {
            throw new InputException(file + ": 'type' is '" + PlainText.value(type)
                    + "', must be FeatureCollection or CityJSON: no map with areas");
        }
        reader.object(root, "geometry", Map.of(), 0);
        return new Read(reader.features, reader.leftOut);
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

    private void polygon(JsonNode rings, String id, Map<String, String> tags) {
        MapFeature plain = new MapFeature(id, List.of(), List.of(), tags);
        if ("no".equals(tags.get("building")) && !plain.isWood()) {
            return;
        }
        List<double[]> read = new ArrayList<>();
        for (JsonNode ring : rings) {
            read.add(ring(ring, id));
        }
        if (read.isEmpty()) {
            leave("polygon without corners");
        } else {
            features.add(new MapFeature(id, read.subList(0, 1), read.subList(1, read.size()), tags));
        }
    }

    private double[] ring(JsonNode corners, String id) {
        int count = corners.size();
        double[] ring = new double[2 * count];
        for (int i = 0; i < count; i++) {
            JsonNode corner = corners.get(i);
            for (int axis = 0; axis < 2; axis++) {
                JsonNode value = corner.path(axis);
                if (!value.isNumber() || !Double.isFinite(value.doubleValue())) {
                    throw new InputException(file + ": " + PlainText.value(id) + ": corner " + i + " of an outline is "
                            + PlainText.value(corner) + ", must be numbers: [longitude, latitude]");
                }
                ring[2 * i + axis] = value.doubleValue();
            }
        }
        boolean isClosed = count > 1 && ring[0] == ring[2 * count - 2] && ring[1] == ring[2 * count - 1];
        return isClosed ? Arrays.copyOf(ring, 2 * count - 2) : ring;
    }
}
