package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.lang.reflect.Modifier;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronewatch.LibraryClasses;
import org.junit.jupiter.api.Test;

/**
 * The architecture page gives a reason for each package and file that is larger than the house wants, and for no other.
 */
class LargePackagesTest {
    private static final int MOST_TYPES = 25;

    private static final int MOST_LINES = 300;
    private static final Path SOURCES = Path.of("src", "main", "java", "org", "dronewatch");
    private static final Set<String> KERNEL = Set.of("bvh", "kdtree", "raster");

    private static final Pattern NAME = Pattern.compile("`([\\w.]+)`");

    private final String page = Files.readString(Path.of("src", "site", "markdown", "architecture.md"));

    LargePackagesTest() throws IOException {}

    /** Of types, those in others among them, but for what is private to a file. */
    @Test
    void exactlyTheLargePackagesHaveAReason() throws IOException {
        Set<String> large = LibraryClasses.all().stream()
                .filter(LargePackagesTest::isVisible)
                .collect(Collectors.groupingBy(Class::getPackageName, Collectors.counting()))
                .entrySet()
                .stream()
                .filter(entry -> entry.getValue() > MOST_TYPES)
                .map(entry -> entry.getKey().replaceFirst("^org\\.dronewatch\\.?", ""))
                .collect(Collectors.toCollection(TreeSet::new));

        assertThat(named("| package | reason |"))
                .as("packages of more than %d types", MOST_TYPES)
                .isEqualTo(large);
    }

    /** Whether others can use it, and it has not been moved since the build last began from nothing. */
    private static boolean isVisible(Class<?> type) {
        Class<?> file = type;
        for (Class<?> outer = type; outer != null; outer = outer.getEnclosingClass()) {
            file = outer;
            if (Modifier.isPrivate(file.getModifiers()) || file.isAnonymousClass() || file.isLocalClass()) {
                return false;
            }
        }
        return !file.getSimpleName().equals("package-info")
                && Files.exists(Path.of("src", "main", "java", file.getName().replace('.', '/') + ".java"));
    }

    @Test
    void exactlyTheLongFilesHaveAReason() throws IOException {
        Set<String> longFiles = new TreeSet<>();
        for (Path file : sources()) {
            if (Files.readAllLines(file).size() > MOST_LINES && !KERNEL.contains(packageOf(file))) {
                longFiles.add(
                        packageOf(file) + "." + file.getFileName().toString().replace(".java", ""));
            }
        }

        assertThat(named("| file | reason |"))
                .as("files of more than %d lines", MOST_LINES)
                .isEqualTo(longFiles);
    }

    /** The names in the first column of the last table that begins with this. */
    private Set<String> named(String heading) {
        return page.substring(page.lastIndexOf(heading))
                .lines()
                .takeWhile(row -> row.startsWith("|"))
                .map(row -> row.substring(0, row.indexOf('|', 1)))
                .flatMap(cell -> NAME.matcher(cell).results().map(name -> name.group(1)))
                .collect(Collectors.toCollection(TreeSet::new));
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
