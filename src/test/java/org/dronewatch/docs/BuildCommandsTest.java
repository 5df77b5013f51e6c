package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The commands of Maven and the scripts that the pages show, in blocks and within their text, name nothing that does
 * not exist: profiles, goals, properties, tests, benchmarks, scripts and their options. Many of them take minutes or
 * hours, so they are not run here.
 */
class BuildCommandsTest {
    private static final Path HERE = Path.of("page.md");
    private static final Set<String> PHASES = Set.of(
            "clean", "compile", "test-compile", "test", "package", "integration-test", "verify", "install", "site");

    /** Those of Maven and its plugins. */
    private static final Set<String> PROPERTIES = Set.of("test", "skipTests", "exec.args");

    private static final Pattern SCRIPT = Pattern.compile("scripts/[\\w.-]+");
    private static final List<String> SOURCES = List.of("src/test", "src/fuzz", "src/jmh", "src/spark-test");

    private final String pom = read(Path.of("pom.xml"));
    private final List<Path> sources = sources();

    @Test
    void everyCommandNamesWhatExists() throws IOException {
        List<BuildCommand> commands = BuildCommand.all();
        assertThat(commands).hasSizeGreaterThan(60);
        for (BuildCommand command : commands) {
            check(command);
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "mvn -Pnone test",
                "mvn tset",
                "mvn spotless:none@none",
                "mvn none:none",
                "mvn test -Dtest=NoneTest",
                "mvn test -Dtest='HouseRulesTest,No*OneTest'",
                "mvn test -Ddronewatch.none=run",
                "mvn -Pjmh exec:exec -Djmh.args=\"NoBenchmark\"",
                "mvn -Pjmh exec:exec -Djmh.main=org.dronewatch.jmh.None",
                "scripts/none",
                "scripts/same-results --none main"
            })
    void aCommandThatNamesWhatDoesNotExistIsFound(String line) {
        assertThatThrownBy(() -> check(BuildCommand.of(HERE, line)))
                .isInstanceOf(AssertionError.class)
                .hasMessageContaining("page.md");
    }

    private void check(BuildCommand command) {
        Path script = Path.of(command.words().get(0));
        assertThat(command.isMaven() || isScript(script)).as("%s", command).isTrue();
        for (String word : command.words().subList(1, command.words().size())) {
            if (!command.isMaven()) {
                assertThat(isScriptWord(command, word))
                        .as("%s: %s", command, word)
                        .isTrue();
            } else if (!Set.of("-q", "-o", "-B", "-e").contains(word)) {
                assertThat(isMavenWord(word)).as("%s: %s", command, word).isTrue();
            }
        }
    }

    /** Scripts are executable files; in a directory of that name lie what they compare. */
    private static boolean isScript(Path path) {
        return SCRIPT.matcher(path.toString().replace('\\', '/')).matches()
                && (Files.isDirectory(path) || Files.isExecutable(path));
    }

    private static boolean isScriptWord(BuildCommand command, String word) {
        return !word.startsWith("-")
                || read(Path.of(command.words().get(0))).lines().anyMatch(line -> Pattern.compile(
                                "(?<![\\w-])" + Pattern.quote(word) + "(?![\\w-])")
                        .matcher(line)
                        .find());
    }

    private boolean isMavenWord(String word) {
        if (word.startsWith("-P")) {
            return pom.contains("<profile>\n      <id>" + word.substring(2) + "</id>");
        }
        if (word.startsWith("-D")) {
            String[] property = word.substring(2).split("=", 2);
            return isProperty(property[0], property.length > 1 ? property[1] : "");
        }
        return PHASES.contains(word) || word.contains(":") && isGoal(word);
    }

    /** Of a plugin that the build uses: {@code prefix:goal}, {@code group:artifact:goal}, with an execution or not. */
    private boolean isGoal(String word) {
        String[] goal = word.split("[:@]");
        boolean isFull = word.chars().filter(c -> c == ':').count() > 1;
        String plugin = isFull ? goal[1] : goal[0];
        boolean isUsed = Stream.of(plugin, plugin + "-maven-plugin", "maven-" + plugin + "-plugin")
                .anyMatch(name -> pom.contains("<artifactId>" + name + "</artifactId>"));
        return isUsed && (!word.contains("@") || pom.contains("<id>" + goal[goal.length - 1] + "</id>"));
    }

    private boolean isProperty(String name, String value) {
        if (name.equals("test")) {
            return Stream.of(value.split(",")).allMatch(this::isTest);
        }
        if (name.equals("jmh.main")) {
            return Files.exists(Path.of("src/jmh/java", value.replace('.', '/') + ".java"));
        }
        if (name.equals("jmh.args") && value.matches("[A-Z]\\w*")) {
            return sources.stream()
                    .anyMatch(source -> source.toString().contains("jmh")
                            && source.toString().contains(value));
        }
        return PROPERTIES.contains(name)
                || pom.contains("<" + name + ">")
                || pom.contains("${" + name + "}")
                || sources.stream().anyMatch(source -> read(source).contains('"' + name + '"'));
    }

    private boolean isTest(String pattern) {
        Pattern name = Pattern.compile("\\Q" + pattern.replace("*", "\\E.*\\Q") + "\\E\\.java");
        return sources.stream()
                .anyMatch(
                        source -> name.matcher(source.getFileName().toString()).matches());
    }

    private static List<Path> sources() {
        return SOURCES.stream().flatMap(directory -> files(Path.of(directory))).collect(Collectors.toList());
    }

    private static Stream<Path> files(Path directory) {
        try (Stream<Path> files = Files.walk(directory)) {
            return files.filter(file -> file.toString().endsWith(".java")).toList().stream();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
