package org.dronewatch.fuzz;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assumptions.abort;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Properties;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.mesh.io.LoadedModel;
import org.dronewatch.mesh.io.ModelLoader;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Inputs that once broke the program, each a directory of {@code src/test/resources/fuzz} with its expectations in
 * {@value FuzzCase#PROPERTIES}; README.md there says how to add one.
 */
class FuzzCorpusTest {
    private static final Path CORPUS = Path.of("src", "test", "resources", "fuzz");
    private static final Duration LONGEST = Duration.ofMinutes(1);
    private static final double SAME = 1e-5;

    @TempDir
    private Path directory;

    static List<Path> corpus() throws IOException {
        try (Stream<Path> entries = Files.list(CORPUS)) {
            return entries.filter(Files::isDirectory).sorted().toList();
        }
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("corpus")
    void isAsExpected(Path entry) throws IOException {
        FuzzCase input = FuzzCase.readFrom(entry);
        Properties expected = FuzzCase.properties(entry);
        try {
            input.writeFiles(directory);
        } catch (UnsupportedOperationException e) {
            abort(e.getMessage());
        }

        if (!input.arguments().isEmpty()) {
            check(assertTimeoutPreemptively(LONGEST, () -> run(input)), expected);
        }
        if (expected.containsKey("model")) {
            check(new ModelLoader(directory).loadAsWritten(expected.getProperty("model")), expected);
        }
    }

    private CommandRun run(FuzzCase input) {
        try {
            return CommandRun.of(input.argumentsIn(directory));
        } catch (OutOfMemoryError e) {
            // Passed on as it is, it would end the process of all tests.
            throw new AssertionError("memory in proportion to the input", e);
        }
    }

    private void check(CommandRun run, Properties expected) {
        assertThat(Messages.fault(run, directory).map(Messages::printable)).isEmpty();
        assertThat(run.code()).as(run.err()).isEqualTo(Integer.parseInt(expected.getProperty("exit")));
        if (expected.containsKey("error")) {
            assertThat(run.err().replace(directory.toString(), FuzzCase.DIRECTORY))
                    .containsPattern(Pattern.compile(expected.getProperty("error")));
        }
        if (expected.containsKey("output")) {
            assertThat(run.out()).containsPattern(Pattern.compile(expected.getProperty("output")));
        }
        if (expected.containsKey("not-shown")) {
            assertThat(run.out() + run.err()).doesNotContain(expected.getProperty("not-shown"));
        }
    }

    private static void check(LoadedModel model, Properties expected) {
        TriangleMesh mesh = model.mesh();
        if (expected.containsKey("area")) {
            double area = 0;
            for (int i = 0; i < mesh.triangleCount(); i++) {
                area += mesh.triangle(i).area();
            }
            double right = Double.parseDouble(expected.getProperty("area"));
            assertThat(area).as("area").isCloseTo(right, within(SAME * right));
        }
        if (expected.containsKey("extent")) {
            AABB box = mesh.bounds();
            double[] extent = {box.maxX() - box.minX(), box.maxY() - box.minY(), box.maxZ() - box.minZ()};
            double[] right = Arrays.stream(expected.getProperty("extent").split(" x "))
                    .mapToDouble(Double::parseDouble)
                    .toArray();
            assertThat(extent).as("extent").containsExactly(right, within(SAME));
        }
        if (expected.containsKey("colours")) {
            assertThat(model.colours()).as("colours").hasSize(Integer.parseInt(expected.getProperty("colours")));
        }
    }
}
