package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The page about tests lists fifteen mistakes that importers of maps make, and the tests against each. */
class ImportMistakesTest {
    private static final Path PAGE = Path.of("src", "site", "markdown", "testing.md");
    private static final Path TESTS = Path.of("src", "test", "java");
    private static final Pattern ROW = Pattern.compile("\\| (\\d+) \\|[^|]+\\|[^|]+\\|([^|]+)\\|");
    private static final Pattern NAME = Pattern.compile("`(\\w+)[.](\\w+)`");

    private static List<Matcher> rows() throws IOException {
        return Files.readAllLines(PAGE).stream()
                .map(ROW::matcher)
                .filter(Matcher::matches)
                .toList();
    }

    @Test
    void eachMistakeHasTests() throws IOException {
        assertThat(rows())
                .extracting(row -> Integer.valueOf(row.group(1)))
                .containsExactlyElementsOf(IntStream.rangeClosed(1, 15).boxed().toList());
        for (Matcher row : rows()) {
            assertThat(NAME.matcher(row.group(2)).results()).as(row.group()).isNotEmpty();
        }
    }

    /** A method that was renamed, or is no test any more, is found. */
    @Test
    void theTestsExist() throws IOException {
        Map<String, List<Path>> files;
        try (Stream<Path> all = Files.walk(TESTS)) {
            files = all.filter(file -> file.toString().endsWith("Test.java"))
                    .collect(Collectors.groupingBy(
                            file -> file.getFileName().toString().replace(".java", "")));
        }
        for (Matcher row : rows()) {
            Matcher name = NAME.matcher(row.group(2));
            while (name.find()) {
                assertThat(files.getOrDefault(name.group(1), List.of()))
                        .as(name.group())
                        .hasSize(1);
                String file = Files.readString(files.get(name.group(1)).get(0));
                assertThat(file).as(name.group()).contains("void " + name.group(2) + "(");
                String before = file.substring(0, file.indexOf("void " + name.group(2) + "("));
                String own = before.substring(before.lastIndexOf("\n\n") + 1);
                assertThat(own).as(name.group()).containsPattern("@(Test|ParameterizedTest)\\b");
            }
        }
    }
}
