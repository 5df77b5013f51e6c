package org.dronewatch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/**
 * What neither the compiler nor the formatter checks: no warnings, comments as narrow as the code, merges resolved.
 */
@Execution(ExecutionMode.CONCURRENT)
class LintTest {
    /** The formatter keeps code to it, but leaves comments as they are. */
    private static final int MOST_COLUMNS = 120;

    private static final Pattern COMMENT = Pattern.compile("\\s*(/?\\*|//)");

    /** As git writes them; seven equals signs alone may underline a heading. */
    private static final Pattern MERGE_MARK = Pattern.compile("(<{7}|>{7}|\\|{7})( |$)");

    private static final Pattern PICTURE_OR_ARCHIVE = Pattern.compile(".*\\.(png|gif|gz)");

    /** Code of all kinds: of the library, its tests, examples, benchmarks and fuzzing. */
    private static final Path ALL_SOURCES = Path.of("src");

    /** They need the incubating module, and come from the build's own classes here. */
    private static final Set<String> WITH_VECTORS = Set.of(
            "BvhTraversal.java",
            "FanBeam.java",
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
    void theCompilerHasNothingToWarnOf() throws IOException, InterruptedException {
        List<Path> checked = JdkTool.javaFiles(JdkTool.SOURCES).stream()
                .filter(file -> !WITH_VECTORS.contains(file.getFileName().toString()))
                .toList();
        assertThat(checked).hasSizeGreaterThan(250);
        JdkTool.Outcome outcome = compiled(checked);
        assertThat(outcome.code()).as(outcome.messages()).isZero();
    }

    /** The compiler is asked for warnings, and heard. */
    @Test
    void aWarningIsFound() throws IOException, InterruptedException {
        Path source = Files.writeString(directory.resolve("Odd.java"), "class Odd { java.util.List list; }\n");
        JdkTool.Outcome outcome = compiled(List.of(source));
        assertThat(outcome.code()).isNotZero();
        assertThat(outcome.messages()).contains("[rawtypes]");
    }

    @Test
    void aBrokenReferenceIsFound() throws IOException, InterruptedException {
        Path source = Files.writeString(
                directory.resolve("Odd.java"), "class Odd { /** As {@link Nobody}. */ private int number; }\n");
        JdkTool.Outcome outcome = compiled(List.of(source));
        assertThat(outcome.code()).isNotZero();
        assertThat(outcome.messages()).contains("reference not found");
    }

    private JdkTool.Outcome compiled(List<Path> sources) throws IOException, InterruptedException {
        List<String> options = List.of(
                "-Xlint:all,-classfile",
                // Broken references and broken HTML, also where Javadoc is not published.
                "-Xdoclint:all,-missing",
                "-Werror",
                "-proc:none",
                // No code is generated: all that is warned of has been found by then.
                "-XDshould-stop.ifNoError=FLOW",
                "--release",
                "17",
                "-d",
                directory.toString());
        return JdkTool.run("javac", directory, options, sources);
    }

    @Test
    void noCommentIsWiderThanCode() throws IOException {
        List<String> wide = new ArrayList<>();
        int comments = 0;
        for (Path file : JdkTool.javaFiles(ALL_SOURCES)) {
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

        assertThat(comments).isGreaterThan(10_000);
        assertThat(wide)
                .as("comment lines of more than %d columns", MOST_COLUMNS)
                .isEmpty();
    }

    /** Pages, scripts and scenes would otherwise keep them unnoticed, since nothing compiles them. */
    @Test
    void noFileHoldsTheMarksOfAnUnresolvedMerge() throws IOException {
        List<String> marked = new ArrayList<>();
        int read = 0;
        for (Path file : texts()) {
            read++;
            List<String> lines = Files.readAllLines(file, StandardCharsets.ISO_8859_1);
            for (int i = 0; i < lines.size(); i++) {
                if (MERGE_MARK.matcher(lines.get(i)).lookingAt()) {
                    marked.add(file + ":" + (i + 1));
                }
            }
        }

        assertThat(read).isGreaterThan(1_000);
        assertThat(marked).isEmpty();
    }

    /** All text files of the project, without hidden and built ones. */
    private static List<Path> texts() throws IOException {
        List<Path> tops;
        try (Stream<Path> entries = Files.list(Path.of(""))) {
            tops = entries.filter(top -> !top.toString().startsWith("."))
                    .filter(top -> !top.equals(Path.of("target")))
                    .toList();
        }
        List<Path> texts = new ArrayList<>();
        for (Path top : tops) {
            try (Stream<Path> files = Files.walk(top)) {
                files.filter(Files::isRegularFile)
                        .filter(file ->
                                !PICTURE_OR_ARCHIVE.matcher(file.toString()).matches())
                        .forEach(texts::add);
            }
        }
        return texts;
    }
}
