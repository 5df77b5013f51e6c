package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.lang.reflect.Member;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronewatch.app.Main;
import org.dronewatch.app.Program;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.KDTreeStats;
import org.dronewatch.mesh.io.ModelLoader;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.mesh.io.UpAxis;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.scenes.CameraRange;
import org.dronewatch.scenes.ClosedSpace;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;

/** The page from the thesis to the code tells the truth: what it names exists, and what it shows can be seen. */
class ThesisPageTest {
    private static final Pattern CODE = Pattern.compile("`([^`]+)`");
    private static final Pattern CLASS = Pattern.compile("([A-Z]\\w+)(?:\\.(\\w+))?");
    private static final Pattern SETTING = Pattern.compile("[a-z]+\\.[\\w.]+");
    private static final String WHY_NOT = "*why not:*";

    /** What is left out for a reason: rows that need show nothing. */
    private static final Set<String> LEFT_OUT = Set.of(
            "magnetic detection",
            "ultraviolet cameras",
            "automatic focus",
            "nodes of 32 bits for small scenes",
            "correlation of pixels with detections by real detectors");

    private static final Pattern LINK = Pattern.compile("\\[[^\\]]+\\]\\([^)]+\\)");
    private static final Pattern PUT_OFF = Pattern.compile(
            "not yet|not enforced|to be done|planned|in future|later version", Pattern.CASE_INSENSITIVE);
    private static final Pattern WORD = Pattern.compile("(?:[^\\s\"]|\"[^\"]*\")+");
    private static final Map<String, List<String>> OUTPUT = Map.of(
            "run", List.of("--out", "results"),
            "render", List.of("--out", "picture.png"),
            "coverage", List.of("--out", "plan.png"),
            "calibrate", List.of("--out", "fitted.yaml"),
            "save", List.of("--out", "scene.yaml"));

    /** The file that {@code render} and its like write. */
    private static final String PICTURE = "picture.png";

    /** Files of a run that a row may name: those that state neither settings nor the time. */
    private static final Pattern RESULT = Pattern.compile("\\w+\\.csv|report\\.html");

    private static final Pattern CAPTION = Pattern.compile("<figcaption>[^<]*");

    private static final Set<String> COMMANDS =
            Program.commands().getSubcommands().keySet();

    @TempDir
    private Path directory;

    /** A row of the page's tables. */
    private record Row(String thesis, String here, String see, String differs) {
        static Row of(String line) {
            String[] cells = line.substring(1, line.lastIndexOf('|')).split("\\|", -1);
            assertThat(cells).as(line).hasSize(4);
            return new Row(cells[0].strip(), cells[1].strip(), cells[2].strip(), cells[3].strip());
        }
    }

    private static List<Row> rows() throws IOException {
        return Files.readString(Path.of("src/site/markdown/thesis.md"))
                .lines()
                .filter(line -> line.startsWith("|"))
                .filter(line -> !line.startsWith("|---") && !line.startsWith("| thesis |"))
                .map(Row::of)
                .toList();
    }

    private static List<String> codeOf(String cell) {
        return CODE.matcher(cell).results().map(found -> found.group(1)).toList();
    }

    private static Map<String, Path> sources() throws IOException {
        try (Stream<Path> main = Files.walk(Path.of("src/main/java"));
                Stream<Path> test = Files.walk(Path.of("src/test/java"));
                Stream<Path> examples = Files.walk(Path.of("src/examples/java"))) {
            return Stream.of(main, test, examples)
                    .flatMap(files -> files)
                    .filter(file -> file.toString().endsWith(".java") && !file.endsWith("package-info.java"))
                    .collect(Collectors.toMap(
                            file -> file.getFileName().toString().replace(".java", ""), file -> file, (a, b) -> a));
        }
    }

    /** Names of all members of the class in a source file, inherited ones too. */
    private static Set<String> members(Path source) throws ClassNotFoundException {
        String inPackage = source.toString().replaceFirst("^src/\\w+/java/", "").replace(".java", "");
        Class<?> type = Class.forName(inPackage.replace('/', '.'));
        Stream<Member> members = Stream.of(
                        type.getMethods(), type.getDeclaredMethods(), type.getFields(), type.getDeclaredFields())
                .flatMap(Stream::of);
        return Stream.concat(
                        members.map(Member::getName),
                        Stream.of(type.getDeclaredClasses()).map(Class::getSimpleName))
                .collect(Collectors.toSet());
    }

    @Test
    void everythingThatARowNamesExists() throws IOException, ClassNotFoundException {
        Map<String, Path> sources = sources();
        String settings = Files.readString(Path.of("src/site/markdown/settings.md"));
        StringWriter list = new StringWriter();
        Main.execute(new PrintWriter(list), new PrintWriter(list), "list");
        List<String> entries =
                list.toString().lines().map(line -> line.split("\\s+")[1]).toList();
        for (Row row : rows()) {
            for (String name : codeOf(row.here())) {
                Matcher type = CLASS.matcher(name);
                if (type.matches()) {
                    assertThat(sources).as("%s", row).containsKey(type.group(1));
                    if (type.group(2) != null) {
                        assertThat(members(sources.get(type.group(1))))
                                .as("%s", row)
                                .contains(type.group(2));
                    }
                } else if (SETTING.matcher(name).matches()) {
                    assertThat(settings).as("%s", row).contains("`" + name.substring(name.lastIndexOf('.') + 1) + "`");
                } else {
                    assertThat(entries).as("%s", row).contains(name);
                }
            }
        }
    }

    @Test
    void everyRowSaysWhereItIsSeenOrWhyNot() throws IOException {
        List<Row> rows = rows();
        assertThat(rows).hasSizeGreaterThan(130);
        assertThat(rows).extracting(Row::thesis).containsAll(LEFT_OUT);
        Map<String, Path> sources = sources();
        for (Row row : rows) {
            assertThat(row.thesis()).as("%s", row).isNotEmpty();
            assertThat(row.here()).as("%s", row).isNotEmpty();
            boolean isLeftOut = LEFT_OUT.contains(row.thesis());
            assertThat(row.differs().startsWith(WHY_NOT)).as("%s", row).isEqualTo(isLeftOut);
            if (!isLeftOut) {
                assertThat(row.here()).as("%s", row).isNotEqualTo("none");
                assertThat(row.here() + row.see()).as("%s", row).matches(ThesisPageTest::shows);
            }
            codeOf(row.see()).stream()
                    .filter(name -> name.endsWith("Test"))
                    .forEach(name -> assertThat(sources).as("%s", row).containsKey(name));
        }
    }

    /** Whether there is a command to run or a page to look at: the name of a test alone shows nobody anything. */
    private static boolean shows(String cells) {
        return LINK.matcher(cells).find()
                || codeOf(cells).stream().anyMatch(name -> COMMANDS.contains(name.split(" ")[0]));
    }

    /** The row about something, as it says what differs. */
    private static String differs(String thesis) throws IOException {
        List<Row> found = new ArrayList<>(rows());
        found.removeIf(row -> !row.thesis().equals(thesis));
        assertThat(found).as(thesis).hasSize(1);
        return found.get(0).differs();
    }

    /**
     * The range at which the camera of the packaged scene first detects the drone, in the first run of its sweep, m.
     */
    private static double cameraRange(String... settings) {
        SceneRunner runner = new SceneRunner(new CameraRange()).only(0).set("sensors.camera.detection", "target-task");
        for (String setting : settings) {
            runner.set(setting.replaceFirst("=.*", ""), setting.replaceFirst(".*=", ""));
        }
        return runner.run().firstDetectionRange("camera", "quadrotor").orElseThrow();
    }

    private static String metres(double range) {
        return String.format(Locale.ROOT, "%.1f", range).replaceFirst("\\.0$", "") + " m";
    }

    /** What the rows say of light and visibility is what a run says. */
    @Test
    void theFiguresOfWeatherAndLightAreThoseOfARun() throws IOException {
        String clear = metres(cameraRange());
        assertThat(differs("dependence on light"))
                .contains(metres(cameraRange("world.light.illuminance=0.3 lx")) + " instead of " + clear
                        + ", with a 30°");
        assertThat(differs("weather and light"))
                .contains(
                        metres(cameraRange("world.light.visibility=200 m")) + " instead of " + clear + ", with a 30°");
    }

    private static double cumulatedEnergy(String... settings) {
        SceneRunner runner = new SceneRunner(new ClosedSpace())
                .set("sensors.microphone.propagation.listening", "thorough")
                .until(0.0);
        for (String setting : settings) {
            runner.set(setting.replaceFirst("=.*", ""), setting.replaceFirst(".*=", ""));
        }
        List<Double> energies = new ArrayList<>();
        runner.onFrame(frame -> frame.observations().stream()
                        .map(one -> one.figures().get("cumulated_energy"))
                        .filter(Objects::nonNull)
                        .forEach(energies::add))
                .run();
        return energies.get(0);
    }

    @Test
    void theFiguresOfDividedEnergyAreThoseOfARun() throws IOException {
        assertThat(
                        differs(
                                "reflected sound split into specular and scattered parts (the thesis: \"ratio of diffraction\")"))
                .contains(String.format(
                        Locale.ROOT,
                        "is %.3f instead of %.3f",
                        cumulatedEnergy("sensors.microphone.propagation.diffraction=0.5"),
                        cumulatedEnergy()));
    }

    /** The line that {@code bench} prints of the quadrotor's tree is on the page about the kernel. */
    @Test
    void theKernelsPageShowsTheTreeOfTheQuadrotor() throws IOException {
        String page = Files.readString(Path.of("src/site/markdown/kernel.md"));
        KDTree tree = KDTree.of(new ModelLoader(Path.of(""))
                .load(ModelSettings.packaged("quadrotor.obj").withUpAxis(UpAxis.Z))
                .mesh());
        assertThat(page.lines().map(String::strip))
                .contains(KDTreeStats.of(tree).toString());
    }

    @Test
    void nothingIsPutOff() throws IOException {
        assertThat(Files.readString(Path.of("src/site/markdown/thesis.md"))).doesNotContainPattern(PUT_OFF);
    }

    private static Set<String> commands() throws IOException {
        Set<String> commands = new LinkedHashSet<>();
        for (Row row : rows()) {
            codeOf(row.see()).stream().filter(name -> !name.endsWith("Test")).forEach(commands::add);
        }
        assertThat(commands).hasSizeGreaterThan(25);
        return commands;
    }

    /** As a shell parts them. */
    private static List<String> words(String command) {
        return new ArrayList<>(WORD.matcher(command)
                .results()
                .map(word -> word.group().replace("\"", ""))
                .toList());
    }

    @Test
    void everyCommandIsOne() throws IOException {
        for (String command : commands()) {
            List<String> words = words(command);
            words.addAll(OUTPUT.getOrDefault(words.get(0), List.of()));
            assertThat(Program.commands()
                            .setCaseInsensitiveEnumValuesAllowed(true)
                            .parseArgs(words.toArray(String[]::new)))
                    .as("%s", command)
                    .isNotNull();
        }
    }

    /** Those with overrides, too, but {@link #everyOverrideOfACommandShows} runs them in full. */
    @Test
    @EnabledIfSystemProperty(named = "dronewatch.commands", matches = "run")
    void everyCommandRuns() throws IOException {
        for (String command : commands()) {
            List<String> words = words(command);
            if (words.contains("--set")) {
                continue;
            }
            List<String> output = OUTPUT.getOrDefault(words.get(0), List.of());
            if (!output.isEmpty()) {
                words.add(output.get(0));
                words.add(directory.resolve(output.get(1)).toString());
            }
            if (words.get(0).equals("run")) {
                // A second shows that it runs; the scenes' own tests show their results.
                words.addAll(List.of("--set", "run.duration=1 s"));
            }
            run(words);
        }
    }

    /** Runs a command, and returns what it says. */
    private static String run(List<String> words) {
        StringWriter said = new StringWriter();
        PrintWriter writer = new PrintWriter(said);
        assertThat(Main.execute(writer, writer, words.toArray(String[]::new)))
                .as("%s: %s", words, said)
                .isZero();
        assertThat(said.toString()).as("%s", words).doesNotContain("has no effect");
        return said.toString();
    }

    /**
     * Minutes of work, for the CI and for whoever changes the page: the same command without one of its overrides
     * prints something else, or writes what the row names.
     */
    @Test
    @EnabledIfSystemProperty(named = "dronewatch.commands", matches = "run")
    void everyOverrideOfACommandShows() throws IOException {
        Map<List<String>, Shown> known = new HashMap<>();
        List<String> unseen = new ArrayList<>();
        for (Row row : rows()) {
            for (String command : codeOf(row.see())) {
                List<String> words = words(command);
                for (int i = words.indexOf("--set"); i >= 0 && i < words.size(); i += 2) {
                    List<String> fewer = new ArrayList<>(words);
                    fewer.subList(i, i + 2).clear();
                    List<String> files = codeOf(row.differs()).stream()
                            .filter(name -> RESULT.matcher(name).matches())
                            .toList();
                    if (!shown(words, known).differsFrom(shown(fewer, known), files)) {
                        unseen.add(words.get(i + 1) + " in " + command);
                    }
                }
            }
        }
        assertThat(known).hasSizeGreaterThan(50);
        assertThat(unseen).isEmpty();
    }

    /** What a reader sees of a command: lines, the picture that it draws, files of results. */
    private record Shown(String lines, Map<String, String> files) {
        boolean differsFrom(Shown other, List<String> named) {
            return !lines.equals(other.lines)
                    || !Objects.equals(files.get(PICTURE), other.files.get(PICTURE))
                    || named.stream().anyMatch(name -> !Objects.equals(files.get(name), other.files.get(name)));
        }
    }

    private Shown shown(List<String> command, Map<List<String>, Shown> known) throws IOException {
        Shown before = known.get(command);
        if (before != null) {
            return before;
        }
        Path out = Files.createDirectory(directory.resolve("shown-" + known.size()));
        List<String> words = new ArrayList<>(command);
        List<String> output = OUTPUT.getOrDefault(words.get(0), List.of());
        if (!output.isEmpty()) {
            words.add(output.get(0));
            words.add((words.get(0).equals("run") ? out : out.resolve(PICTURE)).toString());
        }
        String said = run(words);
        Map<String, String> files = new HashMap<>();
        try (Stream<Path> written = Files.list(out)) {
            for (Path file : written.filter(Files::isRegularFile).toList()) {
                files.put(file.getFileName().toString(), content(file));
            }
        }
        Shown shown = new Shown(said.replace(out.toString(), "OUT"), files);
        known.put(command, shown);
        return shown;
    }

    /** Of a report, which states the time and the command, the captions of its pictures. */
    private static String content(Path file) throws IOException {
        String text = Files.readString(file, StandardCharsets.ISO_8859_1);
        return file.toString().endsWith(".html")
                ? CAPTION.matcher(text).results().map(MatchResult::group).collect(Collectors.joining("\n"))
                : text;
    }
}
