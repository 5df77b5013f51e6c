package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The architecture page gives a reason for each package and file that is larger than the house wants, and for no other. */
class LargePackagesTest {
    private static final int MOST_TYPES = 25;
    private static final int MOST_LINES = 300;
    private static final Path SOURCES = Path.of("src", "main", "java", "org", "dronewatch");
    private static final Set<String> KERNEL = Set.of("bvh", "kdtree", "raster");

    private final String page = Files.readString(Path.of("src", "site", "markdown", "architecture.md"));
    private final String table = page.substring(page.indexOf("## Large packages"));

    LargePackagesTest() throws IOException {}

    @Test
    void eachLargePackageHasARowWithItsNumberOfTypes() throws IOException {
        Map<String, Long> types = sources().stream()
                .filter(file -> !file.endsWith("package-info.java"))
                .collect(Collectors.groupingBy(LargePackagesTest::packageOf, TreeMap::new, Collectors.counting()));
        List<String> large = types.entrySet().stream()
                .filter(entry -> entry.getValue() > MOST_TYPES)
                .map(entry -> "| `" + entry.getKey() + "`, " + entry.getValue() + " types |")
                .toList();

        assertThat(large).isNotEmpty().allSatisfy(row -> assertThat(table).contains(row));
        assertThat(table.lines().filter(row -> row.contains(" types |"))).hasSameSizeAs(large);
    }

    @Test
    void eachLongFileIsNamed() throws IOException {
        for (Path file : sources()) {
            long lines = Files.readAllLines(file).size();
            if (lines > MOST_LINES && !KERNEL.contains(packageOf(file))) {
                String type = file.getFileName().toString().replace(".java", "");
                assertThat(table).as("%s has %d lines", file, lines).contains(type + "`");
            }
        }
    }

    private static String packageOf(Path file) {
        return SOURCES.relativize(file.getParent()).toString().replace(File.separatorChar, '.');
    }

    private static List<Path> sources() throws IOException {
        try (Stream<Path> files = Files.walk(SOURCES)) {
            return files.filter(file -> file.toString().endsWith(".java")).toList();
        }
    }
}
