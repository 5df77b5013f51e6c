package org.dronewatch.report;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.dronewatch.geo.Origin;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/** Writes human-readable JSON: indented, lines ended by a line feed on every system. */
public final class JsonFile {
    private static final JsonMapper MAPPER = JsonMapper.builder().build();

    private JsonFile() {}

    /** Adds the geographic position of a scene's origin. */
    public static void add(ObjectNode node, Origin origin) {
        node.put("latitude_deg", Math.toDegrees(origin.latitude()));
        node.put("longitude_deg", Math.toDegrees(origin.longitude()));
        origin.height().ifPresent(height -> node.put("height_m", height));
    }

    /** Writes a file; an older one is replaced. */
    public static void write(Path file, ObjectNode content) throws IOException {
        String text = MAPPER.writerWithDefaultPrettyPrinter().writeValueAsString(content);
        Files.writeString(file, text.replace("\r\n", "\n") + "\n", StandardCharsets.UTF_8);
    }
}
