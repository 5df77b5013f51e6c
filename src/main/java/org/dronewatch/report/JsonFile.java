package org.dronewatch.report;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/** Writes human-readable JSON: indented, lines ended by a line feed on every system. */
final class JsonFile {
    private static final JsonMapper MAPPER = JsonMapper.builder().build();

    private JsonFile() {}

    static void write(Path file, ObjectNode content) throws IOException {
        String text = MAPPER.writerWithDefaultPrettyPrinter().writeValueAsString(content);
        Files.writeString(file, text.replace("\r\n", "\n") + "\n", StandardCharsets.UTF_8);
    }
}
