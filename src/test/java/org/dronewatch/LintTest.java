package org.dronewatch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
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
 * What neither the compiler nor the formatter checks: no warnings, comments as narrow as the code, merges resolved.
 */
class LintTest {
    /** The formatter keeps code to it, but leaves comments as they are. */
    private static final int MOST_COLUMNS = 120;

    private static final Pattern COMMENT = Pattern.compile("\\s*(/?\\*|//)");

    /** As git writes them; seven equals signs alone may underline a heading. */
    private static final Pattern MERGE_MARK = Pattern.compile("(<{7}|>{7}|\\|{7})( |$)");

    private static final Pattern PICTURE_OR_ARCHIVE = Pattern.compile(".*\\.(png|gif|gz)");

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
