package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageIO;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.app.Program.Outcome;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Coverage under conditions, against the coverage of scenes that are changed by {@code --set}. */
class CoverageConditionsTest {
    private static final String SENSORS = FieldSite.ROUND
            + """
              eye: {kind: camera, position: [0, 0, 4], aim: {azimuth: 180 deg, elevation: 30 deg}, fov: 60 deg, width: 640, height: 480,
                detection: {kind: target-task}}
            """;

    @TempDir
    private static Path directory;

    private static Outcome outcome;
    private static JsonNode json;

    @BeforeAll
    static void run() throws IOException {
        FieldSite.in(directory, SENSORS);
        Path file = directory.resolve("conditions.yaml");
        Files.writeString(
                file,
                """
                dark:
                  world.light.illuminance: 0.001 lx
                dark, no radar:
                  world: {light: {illuminance: 0.001 lx}}
                  sensors.round.enabled: false
                no radar:
                  sensors: {round: {enabled: false}}
                """);
        outcome = coverage("--conditions=" + file, "--out=" + directory.resolve("field"));
        assertThat(outcome.code()).as(outcome.err()).isZero();
        json = json("field");
    }

    private static Outcome coverage(String... more) {
        List<String> command = new ArrayList<>(List.of(
                "coverage",
                directory.resolve("site.yaml").toString(),
                "--heights=10,40",
                "--side=160",
                "--cell=20",
                "--heading=best"));
        command.addAll(List.of(more));
        return Program.run(command.toArray(String[]::new));
    }

    private static JsonNode json(String out) {
        return JsonMapper.builder()
                .build()
                .readTree(directory.resolve(out).resolve("coverage.json").toFile());
    }

    /** The same settings by {@code --set}, in a command of their own. */
    @Test
    void aConditionIsTheSceneWithItsChanges() {
        Outcome dark = coverage("--set=world.light.illuminance=0.001 lx", "--out=" + directory.resolve("dark"));
        assertThat(dark.code()).as(dark.err()).isZero();
        JsonNode alone = json("dark");
        for (int height = 0; height < 2; height++) {
            JsonNode under = json.get("conditions").get("dark").get("heights").get(height);
            JsonNode set = alone.get("heights").get(height);
            for (String key : List.of("height_m", "known", "covered_share", "causes")) {
                assertThat(under.get(key)).as(key).isEqualTo(set.get(key));
            }
            assertThat(under.get("sensors").get("eye").asDouble())
                    .as("a camera at night")
                    .isZero();
            assertThat(under.get("sensors").get("round").asDouble()).isPositive();
        }
    }

    /** What is lost without the radar is what the coverage says about its failure. */
    @Test
    void whatIsLostIsWhatTheSensorAdded() {
        assertThat(json.get("conditions").propertyNames()).containsExactly("dark", "dark, no radar", "no radar");
        for (int height = 0; height < 2; height++) {
            JsonNode asItIs = json.get("heights").get(height);
            JsonNode without =
                    json.get("conditions").get("no radar").get("heights").get(height);
            double lost = without.get("lost_share").asDouble();
            assertThat(lost)
                    .isPositive()
                    .isCloseTo(asItIs.get("n_minus_1").get("round").asDouble(), within(1e-9));
            assertThat(without.get("covered_share").asDouble())
                    .isPositive()
                    .isCloseTo(asItIs.get("covered_share").asDouble() - lost, within(1e-5));
            assertThat(without.get("sensors").propertyNames()).containsExactly("eye");
            JsonNode nothing =
                    json.get("conditions").get("dark, no radar").get("heights").get(height);
            assertThat(nothing.get("covered_share").asDouble()).isZero();
            assertThat(nothing.get("lost_share")).isEqualTo(asItIs.get("covered_share"));
        }
        assertThat(json.get("complete").asBoolean()).isTrue();
    }

    @Test
    void theTablesStateWhatIsLostAndWhoHolds() {
        assertThat(outcome.out())
                .contains("covered under each condition, in % of the known cells:")
                .contains("dark, no radar: half of the coverage or more is lost at 10 to 40 m")
                .contains("sensor that covers most under each condition");
        String row = outcome.out()
                .lines()
                .dropWhile(line -> !line.startsWith("sensor that covers most"))
                .skip(2)
                .findFirst()
                .orElseThrow();
        assertThat(row).matches(" +10 m +round \\d+\\.\\d +round \\d+\\.\\d +none +eye \\d+\\.\\d");
    }

    /** A site whose sensors cover nothing as it is cannot lose anything. */
    @Test
    void whereNothingIsCoveredNothingIsLost() throws IOException {
        Outcome nothing = coverage(
                "--set=sensors.round.enabled=false",
                "--set=world.light.illuminance=0.001 lx",
                "--conditions=" + Files.writeString(directory.resolve("rain.yaml"), "rain: {world.rain: 10 mm/h}"),
                "--out=" + directory.resolve("nothing"));
        assertThat(nothing.out()).contains("rain: nothing is covered in the scene as it is, so nothing can be lost");
        assertThat(Files.readString(directory.resolve("nothing/report.html"))).doesNotContain("most by");
    }

    /** A column for each condition: light for what is covered, dark for what is not. */
    @Test
    void thePictureIsDarkWhereNothingIsCovered() throws IOException {
        BufferedImage matrix =
                ImageIO.read(directory.resolve("field/conditions.png").toFile());
        double asItIs = json.get("heights").get(0).get("covered_share").asDouble();
        int bottom = 120 + 58 + 4;
        assertThat(matrix.getRGB(24 + 90 + 4, bottom) >> 16 & 0xff)
                .isCloseTo((int) Math.round(0x2c + asItIs * (0xff - 0x2c)), within(2));
        assertThat(matrix.getRGB(24 + 90 + 2 * 190 + 4, bottom) & 0xffffff).isEqualTo(0x2c4a86);
        assertThat(Files.readString(directory.resolve("field/report.html"))).contains("Under other conditions");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "night: {world.lihgt.illuminance: 1 lx} | 1:34: ",
                "night: {world.light.illuminance: -1 lx} | 1:34: ",
                "night: 5 | 1:8: must give settings by their paths",
                "night: {} | 1:1: night changes no setting",
                "As it is: {world.rain: 1 mm/h} | 1:1: As it is: in tables, this is the name of the scene without a condition",
                "night: {world.rain: [1, 2]} | 1:21: world.rain: must be a single value, or named values",
            })
    void wrongConditionsAreRefusedWithTheirPlace(String text, String message) throws IOException {
        Path file = directory.resolve("wrong.yaml");
        Files.writeString(file, text + "\n");
        Outcome wrong = coverage("--conditions=" + file);
        assertThat(wrong.code()).isEqualTo(2);
        assertThat(wrong.complaints()).singleElement().asString().startsWith(file + ":" + message);
    }

    @Test
    void otherWrongFilesAreRefused() throws IOException {
        Path file = directory.resolve("wrong.yaml");
        Files.writeString(file, "");
        assertThat(coverage("--conditions=" + file).code()).isEqualTo(2);
        assertThat(coverage("--conditions=" + directory.resolve("nowhere.yaml")).code())
                .isEqualTo(2);
        Outcome plan = Program.run("coverage", "multi-sensor", "--conditions=" + file, "--out=plan.png");
        assertThat(plan.code()).isEqualTo(2);
        assertThat(plan.err()).startsWith("--conditions: has no effect on a plan");
    }

    /**
     * Without a protected zone, drones fly inbound to the middle of the sensors of the scene as it is: a receiver far
     * away that covers nothing moves it, whether it is switched on or not. A site without any sensor covers nothing.
     */
    @Test
    void aConditionDoesNotMoveTheTarget() throws IOException {
        Path there = Files.createDirectories(directory.resolve("moved"));
        FieldSite.in(there, FieldSite.ROUND + "  deaf: {kind: rf, position: [400, 0, 4], threshold: 100}\n");
        Path file = Files.writeString(
                there.resolve("failures.yaml"),
                """
                no receiver: {sensors.deaf.enabled: false}
                no radar: {sensors.round.enabled: false}
                nothing: {sensors: {deaf: {enabled: false}, round: {enabled: false}}}
                """);
        Outcome inbound = Program.run(
                "coverage",
                there.resolve("site.yaml").toString(),
                "--heights=10,40",
                "--side=400",
                "--cell=20",
                "--centre=0,0",
                "--heading=inbound",
                "--conditions=" + file,
                "--out=" + there.resolve("field"));
        assertThat(inbound.code()).as(inbound.err()).isZero();
        JsonNode found = json("moved/field");
        for (int height = 0; height < 2; height++) {
            JsonNode asItIs = found.get("heights").get(height);
            assertThat(asItIs.get("n_minus_1").get("deaf").asDouble()).isZero();
            JsonNode without =
                    found.get("conditions").get("no receiver").get("heights").get(height);
            assertThat(without.get("lost_share").asDouble()).isZero();
            assertThat(without.get("covered_share")).isEqualTo(asItIs.get("covered_share"));
            assertThat(asItIs.get("covered_share").asDouble()).isBetween(0.1, 0.9);
            for (String all : List.of("no radar", "nothing")) {
                JsonNode lost = found.get("conditions").get(all).get("heights").get(height);
                assertThat(lost.get("covered_share").asDouble()).isZero();
                assertThat(lost.get("lost_share")).isEqualTo(asItIs.get("covered_share"));
            }
        }
    }

    /** A model that is missing under a condition alone. */
    @Test
    void whatCannotBeLoadedNamesTheCondition() throws IOException {
        Path file = Files.writeString(directory.resolve("model.yaml"), "swapped: {drones.one.model: nowhere.obj}\n");
        Outcome missing = coverage("--conditions=" + file);
        assertThat(missing.code()).isEqualTo(2);
        assertThat(missing.complaints()).singleElement().asString().contains("swapped", "nowhere.obj");
    }

    /** The packaged conditions fit the packaged scene. */
    @Test
    void thePackagedConditionsFit() {
        Outcome meadow = Program.run(
                "coverage",
                "scenes/meadow.yaml",
                "--conditions=scenes/conditions/weather.yaml",
                "--side=1000",
                "--cell=500",
                "--heights=60");
        assertThat(meadow.code()).as(meadow.err()).isZero();
        assertThat(meadow.out()).contains("as it is", "street lighting", "full moon, heavy rain");
    }
}
