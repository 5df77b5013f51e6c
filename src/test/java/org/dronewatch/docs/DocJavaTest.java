package org.dronewatch.docs;

import static java.util.stream.Collectors.joining;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The Java of every page is a part of a file that is compiled and run by a test: whole lines of an example, or of the
 * project of somebody else. Indentation and blank lines do not count.
 */
class DocJavaTest {
    private static final Path PROJECT = Path.of("");
    private static final Path EXAMPLES = Path.of("src", "examples", "java");
    private static final Path FOREIGN = Path.of("src", "test", "resources", "foreign-project");

    /** One in the readme, six in the page about Java, seven in the guide, and five in others. */
    private static final int LEAST_BLOCKS = 19;

    /** Files with their lines. */
    private static final Map<Path, String> SOURCES = new TreeMap<>();

    /**
     * A block of a page.
     *
     * @param page its file
     * @param line at which it begins
     * @param text the block
     */
    record Block(Path page, int line, String text) {
        @Override
        public String toString() {
            return page + ":" + line;
        }
    }

    @BeforeAll
    static void read() throws IOException {
        for (Path directory : List.of(EXAMPLES, FOREIGN)) {
            for (Path file : javaFiles(directory)) {
                SOURCES.put(file, lines(Files.readString(file)));
            }
        }
    }

    private static List<Path> javaFiles(Path directory) throws IOException {
        try (Stream<Path> files = Files.walk(directory)) {
            return files.filter(file -> file.toString().endsWith(".java")).toList();
        }
    }

    /** The lines of a text without indentation and blank lines, each between line feeds. */
    private static String lines(String text) {
        return text.lines().map(String::strip).filter(line -> !line.isEmpty()).collect(joining("\n", "\n", "\n"));
    }

    /** The files of which a text is a part. */
    private static List<Path> sourcesOf(String text) {
        String lines = lines(text);
        return SOURCES.entrySet().stream()
                .filter(source -> source.getValue().contains(lines))
                .map(Map.Entry::getKey)
                .toList();
    }

    static List<Block> blocks() throws IOException {
        List<Block> blocks = new ArrayList<>();
        for (Path page : SitePages.sources(PROJECT)) {
            String text = Files.readString(page);
            Matcher block = Pattern.compile("(?ms)^ *```java\n(.*?)^ *```$").matcher(text);
            while (block.find()) {
                int before = (int) text.substring(0, block.start()).lines().count();
                blocks.add(new Block(page, before + 1, block.group(1)));
            }
            assertThat(blocks.stream().filter(one -> one.page().equals(page)))
                    .as("all blocks of %s", page)
                    .hasSize(text.split("```java", -1).length - 1);
        }
        return blocks;
    }

    @Test
    void thePagesHaveBlocks() throws IOException {
        assertThat(blocks()).hasSizeGreaterThanOrEqualTo(LEAST_BLOCKS);
    }

    @ParameterizedTest
    @MethodSource("blocks")
    void isPartOfASourceAsItStands(Block block) {
        assertThat(sourcesOf(block.text())).as(block.text()).isNotEmpty();
    }

    @Test
    void aBlockThatNobodyWroteIsNotFound() {
        assertThat(sourcesOf("public class GateWatch extends Scene {")).hasSize(1);
        assertThat(sourcesOf("public class GateWatch extends Scene { // a made-up block"))
                .isEmpty();
        assertThat(sourcesOf("class GateWatch extends Scene {")).isEmpty();
        assertThat(sourcesOf("public class GateWatch extends Scene {\n}")).isEmpty();
    }

    /** That of the other project is run by ForeignProjectTest. */
    @Test
    void everyExampleIsUsedByATest() throws IOException {
        List<Path> tests = new ArrayList<>(javaFiles(EXAMPLES));
        tests.addAll(javaFiles(Path.of("src", "test", "java")));
        tests.removeIf(file -> !file.toString().endsWith("Test.java"));
        StringBuilder text = new StringBuilder();
        for (Path test : tests) {
            text.append(Files.readString(test));
        }
        for (Path file : javaFiles(EXAMPLES)) {
            if (tests.contains(file)) {
                continue;
            }
            String name = file.getFileName().toString().replace(".java", "");
            assertThat(Pattern.compile("new " + name + "\\b|\\b" + name + "(\\.|::)\\w|extends " + name + "\\b")
                            .matcher(text)
                            .find())
                    .as("a test uses %s", name)
                    .isTrue();
        }
    }
}
