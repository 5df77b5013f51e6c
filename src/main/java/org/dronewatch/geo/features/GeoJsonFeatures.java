package org.dronewatch.geo.features;

import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.file.JsonText;
import tools.jackson.databind.JsonNode;

/** Reads the features of GeoJSON (RFC 7946) that have a {@code name} among their properties. */
record GeoJsonFeatures(String file, Features.Found found) {

    void read(byte[] bytes) {
        JsonNode root = JsonText.read(file, bytes);
        String type = root.path("type").asString("");
        if (type.equals("Feature")) {
            feature(root, 0);
        } else if (type.equals("FeatureCollection") && root.path("features").isArray()) {
            int number = 0;
            for (JsonNode feature : root.path("features")) {
                feature(feature, number++);
            }
        } else {
            throw new InputException(
                    file + ": 'type' is '" + PlainText.value(type) + "', must be FeatureCollection or Feature");
        }
    }

    private void feature(JsonNode feature, int number) {
        JsonNode name = feature.path("properties").path("name");
        if (!name.isValueNode() || name.isNull()) {
            return;
        }
        String where = "features." + number;
        JsonNode geometry = feature.path("geometry");
        String shape = geometry.path("type").asString("feature without a place");
        Feature found = shape.equals("Point")
                ? point(geometry.path("coordinates"), where)
                : new Feature(
                        where,
                        shape,
                        Optional.empty(),
                        OptionalDouble.empty(),
                        OptionalDouble.empty(),
                        OptionalDouble.empty());
        this.found.add(name.asString(), found);
    }

    private Feature point(JsonNode coordinates, String where) {
        for (int i = 0; i < Math.max(2, Math.min(3, coordinates.size())); i++) {
            if (!coordinates.path(i).isNumber()) {
                throw new InputException(file + ":" + where + ": coordinates " + PlainText.value(coordinates)
                        + " must be numbers: [longitude, latitude]");
            }
        }
        double height = coordinates.size() > 2
                ? found.number(coordinates.get(2).doubleValue(), where, "height", Features.HIGHEST)
                : 0.0;
        // Many programs write 0 where they know of no height.
        return new Feature(
                where,
                "Point",
                Optional.of(found.point(
                        coordinates.get(0).doubleValue(), coordinates.get(1).doubleValue(), where)),
                OptionalDouble.empty(),
                OptionalDouble.empty(),
                height == 0.0 ? OptionalDouble.empty() : OptionalDouble.of(height));
    }
}
