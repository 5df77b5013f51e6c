package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.campaign.CampaignRun;
import org.dronewatch.campaign.CampaignSite;
import org.dronewatch.placement.site.PlacedSite;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** {@code --time} ends the search for each objective, with a whole layout out of 60 candidates. */
class PlaceTimeTest {
    @TempDir
    private Path directory;

    private Outcome place(String lines, String... more) throws IOException {
        Path file = PlacedSite.in(directory, lines);
        // 3 radars, 53 receivers, 4 cameras.
        Files.writeString(
                file,
                Files.readString(file)
                        .replace("[-135, 0], to: [165, 0], every: 50 m", "[-135, 0], to: [125, 0], every: 5 m")
                        .replace("cell: 80 m, heights: [10 m, 40 m]", "cell: 100 m, heights: [40 m]"));
        Path scene = directory.resolve("site.yaml");
        Files.writeString(scene, Files.readString(scene) + "alert: {protect: {centre: [0, 0, 15], radius: 30}}\n");
        return run(List.of("place", file.toString(), "--quiet", "--gap=0"), more);
    }

    @Thorough
    @ParameterizedTest
    @ValueSource(
            strings = {
                "budget: 12",
                "budget: 12\nconditions: {fold: 2}",
                "objective: warning-time\nbudget: 12",
                "objective: warning-time\nwarning: mean\nbudget: 12",
                "objective: weakest-route\nbudget: 12"
            })
    void everyObjectiveEndsWithAWholeLayout(String lines) throws IOException {
        Outcome outcome = place(lines + "\n", "--time=1ms", "--out=" + directory);
        JsonNode json = json();

        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.err()).doesNotContain("interrupted");
        assertThat(outcome.out()).contains("from 60 candidates");
        assertThat(json.get("chosen").isEmpty()).isFalse();
        assertThat(json.get("cost").asDouble()).isBetween(1.0, 12.0);
        assertThat(json.get("bound").asDouble())
                .isGreaterThanOrEqualTo(json.get("value").asDouble());
        assertThat(json.get("complete").asBoolean()).isFalse();
        assertThat(json.get("stopped").get("time_limit_s").asDouble()).isEqualTo(0.001);
        assertThat(outcome.out()).contains("the time limit of 0.001 s".substring(1));
        assertThat(directory.resolve("report.html"))
                .content()
                .contains("he time limit of 0.001 s")
                .doesNotContain("was interrupted");
        assertThat(Program.run("check", directory.resolve("layout.yaml").toString())
                        .code())
                .isZero();
    }

    /**
     * Half a million attacks would take hours: those that are complete 10 s after the time count. That they are the
     * first ones is repeated in the long form only, since {@link PlaceInterruptionTest} shows it of fewer attacks.
     */
    @Thorough
    @Test
    void attacksEndSoonAfterTheTime() throws IOException {
        Path campaign = CampaignSite.in(directory, CampaignSite.TWO_RANGES);
        Files.writeString(directory.resolve("radars.place.yaml"), PlaceAttacksTest.CANDIDATES);
        List<String> words = List.of(
                "place",
                directory.resolve("radars.place.yaml").toString(),
                "--campaign=" + campaign,
                "--budgets=1",
                "--out=" + directory);
        Outcome outcome = run(words, "--time=1ms", "--runs=500000", "--threads=1");
        JsonNode json = json();
        int flown = json.at("/campaign/variants/layout/n").asInt(0);
        assertThat(flown).isBetween(1, 499_999).matches(number -> number % CampaignRun.CHUNK == 0);
        String report = Files.readString(directory.resolve("report.html"));

        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.err()).doesNotContain("interrupted");
        assertThat(outcome.out()).contains("10 s after the time limit of 0.001 s, the command had not completed");
        assertThat(json.get("complete").asBoolean()).isFalse();
        assertThat(json.get("stopped").get("left_out")).map(JsonNode::asString).contains("attacks");
        assertThat(outcome.out())
                .containsPattern("(?m)^This command gives the same figures for the attacks.* --runs " + flown + "$");
        assertThat(report)
                .contains(String.format(Locale.ROOT, "The attacks are %,d runs of the scene", flown))
                .doesNotContain("..</");
        if (LongForm.IS_ON) {
            Outcome whole = run(words, "--runs=" + flown);
            assertThat(whole.code()).as(whole.err()).isZero();
            assertThat(json.get("campaign").get("variants"))
                    .isEqualTo(json().get("campaign").get("variants"));
        }
    }

    private static Outcome run(List<String> words, String... more) {
        List<String> all = new ArrayList<>(words);
        all.addAll(List.of(more));
        return Program.run(all.toArray(String[]::new));
    }

    private JsonNode json() {
        return JsonMapper.builder()
                .build()
                .readTree(directory.resolve("place.json").toFile());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "0 | --time 0: must be 0.001 to 1,000,000 s",
                "-3 | --time -3: must be 0.001 to 1,000,000 s",
                "2e6 | --time 2e6: must be 0.001 to 1,000,000 s",
                "soon | --time soon: "
            })
    void otherTimesAreRefused(String time, String message) throws IOException {
        Outcome outcome = place("budget: 6\n", "--time=" + time);

        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.err().strip()).contains(message).doesNotContain("\n");
    }
}
