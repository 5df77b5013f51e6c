package org.dronewatch.report.map;

import java.io.IOException;
import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.dronewatch.geo.GeoPoint;
import tools.jackson.core.StreamWriteFeature;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** A map as GeoJSON (RFC 7946), with colours after simplestyle-spec 1.1. */
final class GeoJson {
    private static final JsonMapper MAPPER = JsonMapper.builder()
            .enable(StreamWriteFeature.WRITE_BIGDECIMAL_AS_PLAIN)
            .build();

    private final DrawnFeatures content;

    GeoJson(DrawnFeatures content) {
        this.content = content;
    }

    void write(Path file) throws IOException {
        String text = MAPPER.writerWithDefaultPrettyPrinter().writeValueAsString(toJson());
        Files.write(file, (text.replace("\r\n", "\n") + "\n").getBytes(StandardCharsets.UTF_8));
    }

    private ObjectNode toJson() {
        ObjectNode root = MAPPER.createObjectNode();
        root.put("type", "FeatureCollection");
        root.put("name", content.title());
        root.put("description", content.description());
        ArrayNode features = root.putArray("features");
        content.features().forEach(feature -> add(features.addObject(), feature));
        return root;
    }

    private static void add(ObjectNode node, StyledFeature feature) {
        node.put("type", "Feature");
        addGeometry(node.putObject("geometry"), feature.shape());
        ObjectNode properties = node.putObject("properties");
        properties.put("name", feature.name());
        properties.put("folder", feature.folder());
        feature.properties().forEach((name, value) -> properties.set(name, MAPPER.valueToTree(value)));
        addStyle(properties, feature);
    }

    private static void addGeometry(ObjectNode node, Shape shape) {
        if (shape instanceof Shape.Point point) {
            node.put("type", "Point");
            add(node.putArray("coordinates"), point.position().inSpace());
        } else if (shape instanceof Shape.Line line) {
            node.put("type", "LineString");
            ArrayNode positions = node.putArray("coordinates");
            line.positions().forEach(position -> add(positions.addArray(), position.inSpace()));
        } else if (shape instanceof Shape.Area area) {
            node.put("type", "Polygon");
            ArrayNode rings = node.putArray("coordinates");
            for (List<GeoPoint> ring : area.rings()) {
                ArrayNode positions = rings.addArray();
                ring.forEach(position -> add(positions.addArray(), position.onPlan()));
            }
        }
    }

    private static void add(ArrayNode position, List<BigDecimal> coordinates) {
        coordinates.forEach(position::add);
    }

    private static void addStyle(ObjectNode properties, StyledFeature feature) {
        String colour = String.format(Locale.ROOT, "#%06x", feature.colour().getRGB() & 0xffffff);
        if (feature.shape() instanceof Shape.Point) {
            properties.put("marker-color", colour);
            properties.put("marker-size", feature.role().size().word());
            return;
        }
        properties.put("stroke", colour);
        properties.put("stroke-width", Role.STROKE);
        if (feature.shape() instanceof Shape.Area) {
            properties.put("fill", colour);
            properties.put("fill-opacity", Role.OPACITY);
        }
    }
}
