package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;

/** Renders a scene with a camera that is cued. */
abstract class CuedCamera {
    private static final Path CUED = Path.of("scenes/cued-camera.yaml");

    @TempDir
    Path directory;

    /** The cued camera counting pixels, so that its observations hold the count. */
    Path scene;

    @BeforeEach
    void writeScene() throws IOException {
        scene = directory.resolve("counted.yaml");
        Files.writeString(
                scene,
                Files.readString(CUED)
                        .replaceAll("(?m)^( +)detection: .*\n", "$1detection: pixel-threshold\n")
                        .replace("duration: 55 s", "duration: 14 s"));
    }

    static String command(String... arguments) {
        Program.Outcome outcome = Program.run(arguments);
        assertThat(outcome.code()).as(outcome.err()).isZero();
        return outcome.out();
    }

    String render(String... options) {
        return command(Stream.concat(Stream.of("render", scene.toString()), Stream.of(options))
                .toArray(String[]::new));
    }
}
