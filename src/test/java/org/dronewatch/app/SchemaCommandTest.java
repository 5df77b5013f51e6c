package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Without other jars the program writes the schema that lies beside the scenes. */
class SchemaCommandTest {
    private static final Path PUBLISHED = Path.of("scenes/scene.schema.json");

    @TempDir
    private Path directory;

    @Test
    void itPrintsThePublishedSchema() throws IOException {
        Program.Outcome outcome = Program.run("schema");
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.out()).isEqualTo(Files.readString(PUBLISHED));
        assertThat(outcome.err()).isEmpty();
    }

    @Test
    void itWritesThePublishedSchema() throws IOException {
        Path file = directory.resolve("scene.schema.json");
        Program.Outcome outcome = Program.run("schema", "--out", file.toString());
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(Files.readAllBytes(file)).isEqualTo(Files.readAllBytes(PUBLISHED));
        assertThat(outcome.out()).isEmpty();
    }

    @Test
    void aSceneFileIsNotOverwritten() throws IOException {
        Path scene = Files.writeString(directory.resolve("scene.yaml"), "world: {models: [a.obj]}\n");
        Program.Outcome outcome = Program.run("schema", "--out", scene.toString());
        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.complaints()).containsExactly("--out " + scene + ": must end in .json");
        assertThat(scene).hasContent("world: {models: [a.obj]}\n");
    }
}
