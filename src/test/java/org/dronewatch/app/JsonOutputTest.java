package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.placement.site.PlacedSite;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;
import tools.jackson.databind.DeserializationFeature;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** With {@code --json}, standard output is a single object whose keys the page about the command line names. */
class JsonOutputTest {
    private static final Path PAGE = Path.of("src", "site", "markdown", "commands.md");
    private static final Pattern KEY = Pattern.compile("\\*\\*`([a-z0-9_]+)`\\*\\*");
    private static final JsonMapper STRICT = JsonMapper.builder()
            .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
            .build();

    /** Commands that print at most a line, or what is to be a file. */
    private static final Set<String> WITHOUT =
            Set.of("view", "new", "save", "schema", "render", "costs", "completion", "help");

    /** Each form of each command that prints a table; earlier ones leave files for later ones. DIR is the test's. */
    private static final List<String> COMMANDS = List.of(
            "list",
            "list --kinds",
            "list spotterrf-c550",
            "run DIR/site.yaml --out DIR/run",
            "check DIR/site.yaml",
            "height DIR/site.yaml --at 10,20,5",
            "height DIR/mapped.yaml --at 50.0001,14.0001",
            "coverage DIR/site.yaml --side=100 --cell=50 --heights=10",
            "coverage DIR/site.yaml --side=100 --cells=4 --out DIR/plan.png",
            "route DIR/site.yaml --side=200 --cell=40 --heights=10",
            "place DIR/radars.place.yaml",
            "campaign DIR/few.campaign.yaml --out DIR/campaign",
            "campaign DIR/few.campaign.yaml --out DIR/part-1 --shard 1/2",
            "campaign DIR/few.campaign.yaml --out DIR/part-2 --shard 2/2",
            "campaign DIR/few.campaign.yaml --case 1",
            "compare DIR/site.yaml --with=sensors.round.maxRange=10 --runs=1",
            "compare DIR/site.yaml --with=sensors.round.maxRange=10 --runs=1 --case=0",
            "merge DIR/part-1 DIR/part-2 --out DIR/merged",
            "again DIR/run/provenance.json",
            "alarms scenes/false-alarms.yaml",
            "alarms scenes/false-alarms.yaml --sensor radar --per-hour 20",
            "calibrate acoustic-range --sensor microphone --drone quadrotor --range 150m --out DIR/mic.yaml",
            "bench packaged:quadrotor.obj --passes 1 --rays DIR/one.rays",
            "models --out DIR/models");

    @TempDir
    private static Path directory;

    /** What each command line printed. */
    private static final Map<String, Outcome> PRINTED = new LinkedHashMap<>();

    @BeforeAll
    static void runAll() throws IOException {
        PlacedSite.in(directory, "budget: 4\n");
        Files.writeString(directory.resolve("few.campaign.yaml"), "scene: site.yaml\nruns: 2\n");
        Files.createDirectory(directory.resolve("models"));
        ByteBuffer ray = ByteBuffer.allocate(28).order(ByteOrder.LITTLE_ENDIAN).putInt(1);
        for (float number : new float[] {0, 0, 5, 0, 0, -1}) {
            ray.putFloat(number);
        }
        Files.write(directory.resolve("one.rays"), ray.array());
        Files.writeString(
                directory.resolve("mapped.yaml"),
                """
                world: {models: [packaged:hill.obj], origin: {latitude: 50 deg, longitude: 14 deg, height: 300 m}}
                """);
        for (String line : COMMANDS) {
            String[] words = (line + " --json --quiet")
                    .replace("DIR", directory.toString())
                    .split(" ");
            PRINTED.put(line, Program.run(words));
        }
    }

    private static JsonNode object(String line) {
        JsonNode object = STRICT.readTree(PRINTED.get(line).out());
        assertThat(object.isObject()).as(line).isTrue();
        return object;
    }

    @Test
    void everyCommandThatPrintsATableHasTheOption() {
        Map<String, CommandLine> all = Program.commands().getSubcommands();
        Set<String> with = COMMANDS.stream().map(JsonOutputTest::name).collect(Collectors.toSet());

        assertThat(Stream.of(with, WITHOUT).flatMap(Collection::stream))
                .containsExactlyInAnyOrderElementsOf(all.keySet());
        all.forEach((name, command) -> assertThat(command.getCommandSpec().findOption("--json") != null)
                .as(name)
                .isEqualTo(with.contains(name)));
    }

    private static String name(String line) {
        return line.replaceFirst(" .*", "");
    }

    @Test
    void standardOutputIsOneObjectAndQuietCommandsSayNothingElse() {
        PRINTED.forEach((line, outcome) -> {
            assertThat(outcome.code()).as("%s: %s", line, outcome.err()).isZero();
            assertThat(object(line)).as(line).isNotEmpty();
            assertThat(outcome.err().lines()).as(line).allMatch(said -> said.startsWith("warning: "));
        });
    }

    /** Where a command also writes a file of its results, that and no other object is printed. */
    @Test
    void theObjectIsThatOfTheFile() throws IOException {
        Map<String, String> files = Map.of(
                "run", "run/result.json",
                "campaign", "campaign/campaign.json",
                "merge", "merged/campaign.json");
        for (Map.Entry<String, String> file : files.entrySet()) {
            String line = COMMANDS.stream()
                    .filter(one -> name(one).equals(file.getKey()))
                    .findFirst()
                    .orElseThrow();
            Path path = directory.resolve(file.getValue());
            assertThat(object(line)).as(line).isEqualTo(STRICT.readTree(Files.readString(path)));
        }
    }

    @Test
    void thePageNamesEachKeyAndNoOther() throws IOException {
        Map<String, Set<String>> printed = new LinkedHashMap<>();
        for (String line : COMMANDS) {
            object(line).propertyNames().forEach(key -> printed.computeIfAbsent(name(line), any -> new TreeSet<>())
                    .add(key));
        }
        Map<String, Set<String>> documented = new LinkedHashMap<>();
        for (String row : rows()) {
            Set<String> keys =
                    KEY.matcher(row).results().map(key -> key.group(1)).collect(Collectors.toSet());
            for (String name : names(row)) {
                documented.computeIfAbsent(name, any -> new TreeSet<>()).addAll(keys);
            }
        }
        assertThat(documented).isEqualTo(printed);
    }

    private static List<String> rows() throws IOException {
        try (Stream<String> lines = Files.lines(PAGE)) {
            return lines.dropWhile(line -> !line.startsWith("| command | keys |"))
                    .skip(2)
                    .takeWhile(line -> line.startsWith("|"))
                    .toList();
        }
    }

    /** The commands of a row: the first words in its first cell. */
    private static Set<String> names(String row) {
        List<String> names = new ArrayList<>();
        Pattern.compile("`([a-z]+)[^`]*`")
                .matcher(row.split("\\|")[1])
                .results()
                .forEach(found -> names.add(found.group(1)));
        return new LinkedHashSet<>(names);
    }

    /** What the table shows and what the object holds are the same numbers. */
    @Test
    void theObjectAgreesWithTheTable() {
        String line = "alarms scenes/false-alarms.yaml --sensor radar --per-hour 20";
        JsonNode object = object(line);
        assertThat(Program.run(line.split(" ")).out().strip().split("=")[0])
                .isEqualTo(object.get("setting").asString());
        String height = Program.run("height", directory + "/site.yaml", "--at", "10,20,5")
                .out();
        double z =
                object("height DIR/site.yaml --at 10,20,5").at("/surfaces/0/z").asDouble();
        assertThat(height).contains(String.format(java.util.Locale.ROOT, "z %.2f m", z));
    }

    @Test
    void aMistakePrintsNoObject() {
        Outcome refused = Program.run("run", "no-such-scene", "--json");

        assertThat(refused.code()).isEqualTo(2);
        assertThat(refused.out()).isEmpty();
        assertThat(refused.err()).contains("no-such-scene");
    }
}
