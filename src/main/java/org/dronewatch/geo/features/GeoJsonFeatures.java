package org.dronewatch.geo.features;

import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.geo.CoordinateReferenceSystem;
import org.dronewatch.geo.EarthPoint;
import org.dronewatch.geo.GeoPoint;
import org.dronewatch.geo.MapTransform;
import org.dronewatch.geo.Origin;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.input.JsonText;
import tools.jackson.databind.JsonNode;

/** Reads the features of GeoJSON (RFC 7946) that have a {@code name} among their properties. */
final class GeoJsonFeatures {
    /** Any: only longitudes and latitudes are needed. */
    private static final Origin ANYWHERE = Origin.at(0.0, 0.0);

    private final String file;
    private final Features.Found found;

    /** The transform from coordinates of a grid, if the file states one. */
    private Optional<MapTransform> grid = Optional.empty();

    GeoJsonFeatures(String file, Features.Found found) {
        this.file = file;
        this.found = found;
    }

    void read(byte[] bytes) {
        JsonNode root = JsonText.read(file, bytes);
        grid = GeoJsonSystem.stated(root)
                .map(this::system)
                .filter(crs -> !crs.equals(CoordinateReferenceSystem.wgs84()))
                .map(crs -> new MapTransform(crs, ANYWHERE));
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
                    file + ": 'type' is '" + PlainText.value(type) + "' but must be FeatureCollection or Feature");
        }
    }

    private CoordinateReferenceSystem system(String stated) {
        try {
            return CoordinateReferenceSystem.of(stated);
        } catch (InputException e) {
            throw new InputException(file + ": crs: " + e.getMessage(), e);
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
                Optional.of(onEarth(
                        coordinates.get(0).doubleValue(), coordinates.get(1).doubleValue(), where)),
                OptionalDouble.empty(),
                OptionalDouble.empty(),
                height == 0.0 ? OptionalDouble.empty() : OptionalDouble.of(height));
    }

    private EarthPoint onEarth(double x, double y, String where) {
        try {
            GeoPoint point = grid.map(map -> map.onEarth(x, y, 0.0)).orElse(new GeoPoint(x, y, 0.0));
            return found.point(point.longitude(), point.latitude(), where);
        } catch (InputException e) {
            if (grid.isPresent()) {
                throw new InputException(file + ":" + where + ": " + e.getMessage(), e);
            }
            throw new InputException(
                    e.getMessage()
                            + "; 'ogr2ogr -s_srs EPSG:25832 -t_srs EPSG:4326 new.geojson old.geojson' converts"
                            + " coordinates of a grid",
                    e);
        }
    }
}
