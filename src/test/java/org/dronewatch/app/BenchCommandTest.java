package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import org.dronewatch.Thorough;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** The bench traces rays of a file, or its own. */
class BenchCommandTest extends CommandLines {
    private static final JsonMapper JSON = JsonMapper.builder().build();
    private static final String TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

    @ParameterizedTest
    @ValueSource(ints = {0, 3, 10, 27, 29})
    void aRayFileOfTheWrongSizeIsRefused(int bytes) throws IOException {
        Files.writeString(directory.resolve("model.obj"), TRIANGLE + "f 1 2 3\n");
        byte[] file = new byte[bytes];
        if (bytes > 4) {
            file[0] = 1;
        }
        Files.write(directory.resolve("bad.rays"), file);

        assertRefused("bench DIR/model.obj --rays DIR/bad.rays --hits DIR/hits", "bad.rays");
    }

    @Test
    void aRayWithoutDirectionIsRefused() throws IOException {
        Files.writeString(directory.resolve("model.obj"), TRIANGLE + "f 1 2 3\n");
        Files.write(directory.resolve("bad.rays"), rays(new float[] {0, 0, 0, 0, 0, 0}));
        assertRefused("bench DIR/model.obj --rays DIR/bad.rays", "ray 0", "direction");
        Files.write(directory.resolve("bad.rays"), rays(new float[] {0, 0, Float.NaN, 0, 0, 1}));
        assertRefused("bench DIR/model.obj --rays DIR/bad.rays", "ray 0", "NaN");
    }

    private static byte[] rays(float[]... rays) {
        ByteBuffer buffer = ByteBuffer.allocate(4 + 24 * rays.length).order(ByteOrder.LITTLE_ENDIAN);
        buffer.putInt(rays.length);
        for (float[] ray : rays) {
            for (float value : ray) {
                buffer.putFloat(value);
            }
        }
        return buffer.array();
    }

    @Test
    void benchTracesTheRaysOfAFile() throws IOException {
        Files.writeString(directory.resolve("model.obj"), TRIANGLE + "v 1 1 1\nf 1 2 2\nf 1 2 3\n");
        Files.write(
                directory.resolve("my.rays"),
                rays(new float[] {0.2f, 0.2f, -2, 0, 0, 1}, new float[] {0.2f, 0.2f, -2, 0, 0, -1}));
        Program.Outcome outcome =
                commandIn("bench DIR/model.obj --rays DIR/my.rays --hits DIR/my.hits --passes 2 --threads 2"
                        + " --traversal sequential");

        assertThat(outcome.code()).isZero();
        JsonNode line = JSON.readTree(outcome.out());
        assertThat(line.get("set").asString()).isEqualTo("file");
        assertThat(line.get("rays").asInt()).isEqualTo(2);
        assertThat(line.get("hits").asInt()).isEqualTo(1);
        assertThat(line.get("traversal").asString()).isEqualTo("sequential");
        assertThat(line.get("threads").asInt()).isEqualTo(2);
        assertThat(line.get("mrays_min").asDouble())
                .isLessThanOrEqualTo(line.get("mrays").asDouble());
        assertThat(line.get("mrays").asDouble())
                .isLessThanOrEqualTo(line.get("mrays_max").asDouble());
        assertThat(line.has("build_s")).isTrue();
        ByteBuffer hits = ByteBuffer.wrap(Files.readAllBytes(directory.resolve("my.hits")))
                .order(ByteOrder.LITTLE_ENDIAN);
        // The triangle without area is dropped, but counts: the hit is the file's second triangle.
        assertThat(hits.getFloat()).isEqualTo(2.0f);
        assertThat(hits.getInt()).isEqualTo(1);
        assertThat(hits.getFloat()).isInfinite();
        assertThat(hits.getInt()).isEqualTo(-1);
        assertThat(hits.hasRemaining()).isFalse();
    }

    /** As KernelBenchTest does with every traversal. */
    @Test
    void benchCountsHiddenSegments() throws IOException {
        Files.writeString(directory.resolve("model.obj"), TRIANGLE + "f 1 2 3\n");
        Files.write(
                directory.resolve("my.rays"),
                rays(new float[] {0.2f, 0.2f, -2, 0, 0, 3}, new float[] {0.2f, 0.2f, -2, 0, 0, 1.5f}, new float[] {
                    0.2f, 0.2f, -2, 5, 0, 3
                }));
        Program.Outcome outcome = commandIn("bench DIR/model.obj --rays DIR/my.rays --query occluded --passes 1");

        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(JSON.readTree(outcome.out()).get("hits").asInt()).isEqualTo(1);
        assertThat(commandIn("bench DIR/model.obj --query occluded").err())
                .contains("--query occluded needs --rays: segments are not generated");
        assertThat(commandIn("bench DIR/model.obj --rays DIR/my.rays --query occluded --hits DIR/h")
                        .err())
                .contains("--query occluded takes neither --hits nor --width");
    }

    @Thorough
    @Test
    void benchMakesCameraAndDiffuseRaysItself() {
        Program.Outcome outcome = commandIn("bench packaged:house.obj --passes 1");

        assertThat(outcome.code()).isZero();
        assertThat(outcome.out().lines()).hasSize(2);
        assertThat(outcome.out()
                        .lines()
                        .map(line -> JSON.readTree(line).get("set").asString()))
                .containsExactly("camera", "diffuse");
    }
}
