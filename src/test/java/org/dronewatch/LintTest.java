package org.dronewatch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * What neither the compiler nor the formatter keeps: no warnings, and comments as narrow as the code.
 */
class LintTest {
    /** The formatter keeps code to it, but leaves comments as they are. */
    private static final int MOST_COLUMNS = 120;

    private static final Pattern COMMENT = Pattern.compile("\\s*(/?\\*|//)");

    private static final Path SOURCES = Path.of("src", "main", "java");

    /** Code of all kinds: of the library, its tests, examples, benchmarks and fuzzing. */
    private static final Path ALL_SOURCES = Path.of("src");

    /** They need the incubating module, and come from the build's own classes here. */
    private static final Set<String> WITH_VECTORS = Set.of(
            "BvhTraversal.java",
            "FanOcclusion.java",
            "FewTrianglesPacket.java",
            "FewTrianglesTraversal.java",
            "VectorBands.java",
            "VectorConvexRoomPacket.java",
            "VectorRasteriser.java",
            "VectorTriangleSetup.java",
            "VectorWidth.java");

    @TempDir
    private Path directory;

    /**
     * The build itself cannot require it: it names an incubating module, which is a warning that only goes away with
     * all others.
     */
    @Test
    void theCompilerHasNothingToWarnOf() throws IOException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        StringWriter messages = new StringWriter();
        try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, null);
                Stream<Path> sources = Files.walk(SOURCES)) {
            List<Path> checked = sources.filter(file -> file.toString().endsWith(".java"))
                    .filter(file -> !WITH_VECTORS.contains(file.getFileName().toString()))
                    .toList();
            assertThat(checked).hasSizeGreaterThan(250);
            boolean clean = compiler.getTask(
                            messages,
                            files,
                            null,
                            List.of(
                                    "-Xlint:all,-classfile",
                                    "-Werror",
                                    "-proc:none",
                                    // No code is generated: all that is warned of has been found by then.
                                    "-XDshould-stop.ifNoError=FLOW",
                                    "--release",
                                    "17",
                                    "-d",
                                    directory.toString(),
                                    "-cp",
                                    System.getProperty("java.class.path")),
                            null,
                            files.getJavaFileObjectsFromPaths(checked))
                    .call();
            assertThat(clean).as(messages.toString()).isTrue();
        }
    }

    @Test
    void noCommentIsWiderThanCode() throws IOException {
        List<String> wide = new ArrayList<>();
        int comments = 0;
        try (Stream<Path> sources = Files.walk(ALL_SOURCES)) {
            for (Path file :
                    sources.filter(file -> file.toString().endsWith(".java")).toList()) {
                List<String> lines = Files.readAllLines(file);
                for (int i = 0; i < lines.size(); i++) {
                    String line = lines.get(i);
                    if (COMMENT.matcher(line).lookingAt()) {
                        comments++;
                        if (line.length() > MOST_COLUMNS) {
                            wide.add(file + ":" + (i + 1) + ": " + line.length() + " columns");
                        }
                    }
                }
            }
        }

        assertThat(comments).isGreaterThan(10_000);
        assertThat(wide)
                .as("comment lines of more than %d columns", MOST_COLUMNS)
                .isEmpty();
    }
}
