package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.campaign.CampaignSite;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** The layout that {@code place} finds, and the scene's own radar, face the same attacks. */
class PlaceAttacksTest {
    static final String CANDIDATES =
            """
            scene: site.yaml
            budget: 2
            candidates:
              radar:
                sensor: {use: spotterrf-c550ext, aim: {azimuth: 45 deg, elevation: 0 deg}}
                price: 1
                places: [[0, 0, 10], [0, 200, 10]]
                aims: 4
            air: {side: 600 m, cell: 100 m, heights: [40 m]}
            """;

    @TempDir
    private static Path directory;

    private static Path campaign;
    private static Outcome outcome;
    private static JsonNode json;

    @BeforeAll
    static void run() throws IOException {
        campaign = CampaignSite.in(directory, CampaignSite.TWO_RANGES);
        Files.writeString(directory.resolve("radars.place.yaml"), CANDIDATES);
        outcome = place(".", "--campaign=" + campaign, "--runs=30", "--seed=5", "--budgets=1", "--threads=1");
        assertThat(outcome.code()).as(outcome.err()).isZero();
        json = json(Files.readString(directory.resolve("place.json")));
    }

    private static Outcome place(String out, String... more) {
        List<String> words = new ArrayList<>(
                List.of("place", directory.resolve("radars.place.yaml").toString(), "--out=" + directory.resolve(out)));
        words.addAll(List.of(more));
        return Program.run(words.toArray(String[]::new));
    }

    private static JsonNode json(String text) {
        return JsonMapper.builder().build().readTree(text);
    }

    /** Exactly: the same seeds, the same values that vary, and the layout as it was written. */
    @Test
    void compareGivesTheSameFigures() {
        JsonNode attacks = json.get("campaign");
        List<String> words = new ArrayList<>(ShellWords.printed(outcome.out(), "compare"));
        words.add("--json");
        Outcome compare = Program.run(words.toArray(String[]::new));
        assertThat(compare.code()).as(compare.err()).isZero();
        JsonNode again = json(compare.out());

        assertThat(attacks.get("runs").asInt()).isEqualTo(30);
        assertThat(attacks.get("seed").asInt()).isEqualTo(5);
        assertThat(attacks.get("variants").propertyNames()).containsExactly("layout", "today");
        assertThat(attacks.get("variants").get("layout"))
                .isEqualTo(again.get("variants").get("layout"));
        assertThat(attacks.get("variants").get("today"))
                .isEqualTo(again.get("variants").get("site"));
        assertThat(attacks.get("pairs").size()).isEqualTo(3);
        for (int pair = 0; pair < 3; pair++) {
            for (String key : List.of("of", "n", "only_a", "only_b", "difference", "low", "high", "p", "cases")) {
                assertThat(attacks.get("pairs").get(pair).get(key))
                        .isEqualTo(again.get("pairs").get(pair).get(key));
            }
        }
        // Radars that look south, too, can be no worse here; attacks from the sides are what they add.
        assertThat(attacks.get("pairs").get(0).get("only_b").asInt()).isZero();
        assertThat(attacks.get("pairs").get(0).get("only_a").asInt()).isPositive();
        assertThat(json.propertyNames()).endsWith("campaign", "complete");
        assertThat(json.get("complete").asBoolean()).isTrue();
    }

    @Test
    void theLinesAndTheReportCompareBothLayouts() throws IOException {
        assertThat(outcome.out())
                .contains("numbers of cases, and percentages of them with 95 % confidence intervals:")
                .contains("the same cases compared:")
                .contains("detected: layout minus today = +");
        assertThat(Files.readString(directory.resolve("report.html")))
                .contains("<h2>The same attacks against the layout and today's sensors</h2>")
                .contains("In 30 attacks, the alert is in time in ")
                .contains("The attacks are 30 runs of the scene with each layout")
                .contains("This command gives the same figures for the attacks");
    }

    @Test
    void anyNumberOfThreadsGivesTheSameBytes() {
        place("other", "--campaign=" + campaign, "--runs=30", "--seed=5", "--budgets=1", "--threads=3");

        assertThat(directory.resolve("other/place.json")).hasSameBinaryContentAs(directory.resolve("place.json"));
    }

    /** With the attacks, and for as many budgets: one here, not twelve. */
    @Test
    void againRepeatsIt() {
        Outcome again =
                Program.run("again", directory.resolve("provenance.json").toString());

        assertThat(again.code()).as(again.out()).isZero();
        assertThat(again.out()).contains("same       place.json").doesNotContain("changed since");
        assertThat(json.get("front").size()).isEqualTo(1);
    }

    /** A change of the campaign file is a change of what the results depend on. */
    @Test
    void theProvenanceNamesTheCampaignFile() throws IOException {
        assertThat(Files.readString(directory.resolve("provenance.json"))).contains("attacks.campaign.yaml");
    }

    @Test
    void withoutSensorsTodayOnlyTheLayoutIsAttacked() throws IOException {
        Files.writeString(
                directory.resolve("bare.yaml"),
                Files.readString(directory.resolve("site.yaml"))
                        .replaceAll("(?m)^  radar: .*$", "")
                        .replace("sensors:\n\n", ""));
        Files.writeString(directory.resolve("bare.place.yaml"), CANDIDATES.replace("site.yaml", "bare.yaml"));
        Outcome bare = Program.run(
                "place",
                directory.resolve("bare.place.yaml").toString(),
                "--campaign=" + campaign,
                "--runs=5",
                "--json");

        assertThat(bare.code()).as(bare.err()).isZero();
        assertThat(json(bare.out()).get("campaign").get("variants").propertyNames())
                .containsExactly("layout");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "drones.intruder.speed | 0 | '--runs=0: runs 0 must be 1 to 1e6'",
                "drones.intruder.pace  | 5 | 'vary.drones.intruder.pace: '",
                "sensors.radar.maxRange | 5 | '''sensors.radar.maxRange'' cannot vary: only sensors named in ''keep'' are in every layout'",
            })
    void namesWhatIsWrongBeforeItSearches(String path, int runs, String message) throws IOException {
        Path bad = Files.writeString(
                directory.resolve("bad.campaign.yaml"),
                "scene: site.yaml\nvary:\n  " + path + ": {values: [100, 200]}\nruns: 4\n");
        Outcome refused = place("refused", "--campaign=" + bad, "--runs=" + runs);

        assertThat(refused.code()).as(refused.err()).isEqualTo(2);
        assertThat(refused.err()).contains(message).doesNotContain("\tat ");
        assertThat(refused.complaints()).hasSize(1);
        assertThat(directory.resolve("refused")).doesNotExist();
    }

    @Test
    void namesAFileThatIsMissingAndAnOptionThatNeedsOne() {
        Outcome missing = place("refused", "--campaign=" + directory.resolve("none.yaml"));
        Outcome alone = place("refused", "--runs=3");

        assertThat(missing.code()).isEqualTo(2);
        assertThat(missing.err()).contains("none.yaml");
        assertThat(alone.code()).isEqualTo(2);
        assertThat(alone.err()).contains("--runs 3: needs --campaign FILE");
    }
}
