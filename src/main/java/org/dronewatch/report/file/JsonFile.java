package org.dronewatch.report.file;

import java.io.IOException;
import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.dronewatch.geo.GeoPoint;
import org.dronewatch.geo.Origin;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/** Writes human-readable JSON: indented, lines ended by a line feed on every system. */
public final class JsonFile {
    private static final JsonMapper MAPPER = JsonMapper.builder().build();

    private JsonFile() {}

    /** Adds the geographic position of a scene's origin, rounded to a millimetre on the ground. */
    public static void add(ObjectNode node, Origin origin) {
        List<BigDecimal> point =
                new GeoPoint(Math.toDegrees(origin.longitude()), Math.toDegrees(origin.latitude()), 0.0).onPlan();
        node.put("latitude_deg", point.get(1));
        node.put("longitude_deg", point.get(0));
        origin.height().ifPresent(height -> node.put("height_m", height));
    }

    /** Writes a file; an older one is replaced. */
    public static void write(Path file, ObjectNode content) throws IOException {
        String text = MAPPER.writerWithDefaultPrettyPrinter().writeValueAsString(content);
        Files.writeString(file, text.replace("\r\n", "\n") + "\n", StandardCharsets.UTF_8);
    }
}
