package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.dronewatch.app.Main;
import org.dronewatch.viewer.ShownWindow;
import org.dronewatch.viewer.Viewer;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Every command that README and the pages show runs to its end, in their order. The tutorials and the plant drawn by
 * hand have tests of their own. On a display ({@code -Dtest.headless=false}), windows open and are closed again;
 * without one, these commands are left out. A line states how long each command took. {@code -Ddronewatch.page=viewer}
 * runs those of one page.
 */
@EnabledIfSystemProperty(named = "dronewatch.commands", matches = "run")
class PageCommandsTest {
    /** Pages whose commands follow one another, and are run by their own tests. */
    private static final Pattern OF_TUTORIAL = Pattern.compile("tutorial.*");

    private static final Pattern OF_PLANT = Pattern.compile("plant(/.*)?");

    /** What a command may write or read besides the files of the project. */
    private static final Pattern FILE = Pattern.compile("[\\w-]+\\.(png|gif|mp4|yaml|json|obj|plan)");

    /** A reader's own scene, in which every sensor, drone and setting that the pages name exists. */
    private static final String SITE = String.join(
            "\n",
            "world: {models: [packaged:hill.obj]}",
            "drones:",
            "  intruder: {model: packaged:quadrotor.obj, flight: {kind: hover, position: [0, 100, 160]},"
                    + " radar: {droneClass: small-uav}}",
            "sensors:",
            "  tower: {use: spotterrf-c550, position: [0, 0, 144]}",
            "  ear: {kind: acoustic, position: [0, 0, 140], propagation: {kind: energy-model, criterion: narrow-band}}",
            "run: {duration: 2 s}",
            "");

    @TempDir
    private static Path directory;

    @BeforeAll
    static void whatReadersHave() throws IOException {
        Files.writeString(directory.resolve("site.yaml"), SITE);
        String guide = Files.readString(Path.of("src/site/markdown/guide.md"));
        Files.writeString(directory.resolve("gate.yaml"), GuideTest.firstExample(guide));
        // The command that writes the packaged models needs a directory.
        Files.createDirectory(directory.resolve("models"));
    }

    /** Each command once, where it is shown first. */
    static List<PageCommand> commands() throws IOException {
        String page = System.getProperty("dronewatch.page", "");
        List<List<String>> known = new ArrayList<>();
        List<PageCommand> commands = new ArrayList<>();
        for (PageCommand command : PageCommand.all()) {
            boolean isTestedElsewhere = OF_TUTORIAL.matcher(command.page()).matches()
                    || command.words().stream()
                            .anyMatch(word -> OF_PLANT.matcher(word).matches());
            if (!isTestedElsewhere
                    && (page.isEmpty() || command.page().equals(page + ".md"))
                    && !known.contains(command.words())) {
                known.add(command.words());
                commands.add(command);
            }
        }
        return commands;
    }

    @ParameterizedTest
    @MethodSource("commands")
    @Timeout(value = 20, unit = TimeUnit.MINUTES)
    void itRuns(PageCommand command) throws Exception {
        List<String> words = here(command.words());
        boolean hasWindow = words.get(0).equals("view") || words.contains("--view") && !isRendering(words);
        assumeTrue(!hasWindow || Viewer.obstacle().isEmpty(), "needs a display");
        long start = System.nanoTime();
        StringWriter said = new StringWriter();
        PrintWriter writer = new PrintWriter(said, true);
        CompletableFuture<Integer> code =
                CompletableFuture.supplyAsync(() -> Main.execute(writer, writer, words.toArray(String[]::new)));
        if (hasWindow) {
            close(words);
        }
        assertThat(code.get()).as("%s: %s", command, said).isZero();
        System.out.printf(Locale.ROOT, "PageCommandsTest: %.1f s: %s%n", (System.nanoTime() - start) * 1e-9, command);
    }

    /** Of {@code render}, it names the point of view. */
    private static boolean isRendering(List<String> words) {
        return words.get(0).equals("render");
    }

    /** The command with its files in the reader's directory; what it writes is not there yet. */
    private static List<String> here(List<String> words) throws IOException {
        List<String> here = new ArrayList<>();
        for (int i = 0; i < words.size(); i++) {
            String word = words.get(i);
            boolean isOutput = i > 0 && words.get(i - 1).equals("--out");
            boolean isNew = FILE.matcher(word).matches() && !Files.exists(Path.of(word));
            boolean isOfEarlierCommand =
                    isIn(directory, Path.of(word).getName(0).toString()) && !isIn(Path.of(""), word);
            boolean isOwn = isNew || isOfEarlierCommand;
            if (isOutput && !words.get(0).equals("models")) {
                delete(directory.resolve(word));
            }
            here.add(isOutput || isOwn ? directory.resolve(word).toString() : word);
        }
        return here;
    }

    private static boolean isIn(Path parent, String name) {
        return !name.isEmpty() && Files.exists(parent.resolve(name));
    }

    private static void delete(Path output) throws IOException {
        assertThat(output.normalize().startsWith(directory)).as("%s", output).isTrue();
        if (Files.exists(output)) {
            try (Stream<Path> files = Files.walk(output)) {
                for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                    Files.delete(file);
                }
            }
        }
    }

    /** Closes the window as soon as there is one; that of {@code run} after the run, which would be interrupted. */
    private static void close(List<String> words) throws Exception {
        if (words.get(0).equals("run")) {
            ShownWindow.awaitFinished();
        } else {
            ShownWindow.awaitShown();
        }
        ShownWindow.close();
    }
}
