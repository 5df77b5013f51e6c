package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.dronewatch.Thorough;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.campaign.CampaignSite;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.json.JsonMapper;

class CompareCommandTest {
    @TempDir
    private static Path directory;

    private static String site;
    private static String campaign;

    @BeforeAll
    static void write() throws IOException {
        campaign = CampaignSite.in(directory, CampaignSite.TWO_RANGES).toString();
        site = directory.resolve("site.yaml").toString();
    }

    private static Outcome compare(String... arguments) {
        return Program.run(
                Stream.concat(Stream.of("compare"), Stream.of(arguments)).toArray(String[]::new));
    }

    @Test
    void aChangedSettingIsComparedOnTheCasesOfACampaignFile() throws IOException {
        Outcome outcome = compare(site, "--with=sensors.radar.maxRange=350m", "--vary=" + campaign);
        List<String> rows = outcome.out().lines().toList();
        int deciding = rows.indexOf(rows.stream()
                .filter(row -> row.startsWith("deciding cases"))
                .findFirst()
                .orElseThrow());

        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.out())
                .containsPattern(
                        "in time: site minus site-changed = \\+\\d+\\.\\d points .* site-changed alone in 0 of 60"
                                + " cases, p = \\d");
        assertThat(rows.subList(deciding + 1, rows.size()))
                .isNotEmpty()
                .allMatch(row -> row.matches(" +\\d+  site  +drones\\.intruder\\.flight\\.bearing=-?\\d.* deg"
                        + "  drones\\.intruder\\.flight\\.distance=.* m  drones\\.intruder\\.speed=[12]0 m/s"));
    }

    @Test
    void theSameSceneDoesNotDiffer() {
        Outcome outcome = compare(site, site, "--runs=30");

        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.err()).contains("varies: drones.intruder.flight.bearing");
        assertThat(outcome.out())
                .contains("= +0.0 points", "site alone in 0, site-changed alone in 0 of 30 cases, p = 1")
                .contains("there are no deciding cases: 'in time' is the same for both in every case");
    }

    @Test
    void aSensorMayBeSwitchedOffAndTheResultsBeWritten() throws IOException {
        Path out = directory.resolve("off");
        Outcome outcome = compare(site, "--with=sensors.radar.enabled=false", "--runs=20", "--seed=7", "--out=" + out);

        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.out()).containsPattern("site-changed +20 +0 +0\\.0 \\(0\\.0 to");
        assertThat(Files.readAllLines(out.resolve("runs.csv"))).hasSize(41);
        assertThat(Files.readString(out.resolve("report.html"))).contains("runs.csv", "provenance.json");
        assertThat(JsonMapper.builder()
                        .build()
                        .readTree(out.resolve("campaign.json").toFile())
                        .get("seed")
                        .asInt())
                .isEqualTo(7);
    }

    private static List<String> bytes(Path results) throws IOException {
        return List.of(
                Files.readString(results.resolve("runs.csv")),
                Files.readString(results.resolve("campaign.json")),
                Files.readString(results.resolve("report.html")),
                Files.readString(results.resolve("plan.json")));
    }

    /** As Ctrl-C leaves it, with whole chunks and no report. */
    @Thorough
    @Test
    void anInterruptedComparisonIsCompletedWithTheSameBytesAndCanBeRepeated() throws IOException {
        Path out = directory.resolve("interrupted");
        String[] command = {site, "--with=sensors.radar.maxRange=350m", "--runs=70", "--out=" + out};
        Outcome whole = compare(command);
        assertThat(whole.code()).as(whole.err()).isZero();
        List<String> before = bytes(out);
        Outcome again = Program.run("again", out.resolve("provenance.json").toString());
        assertThat(again.code()).as(again.out() + again.err()).isZero();
        assertThat(again.out()).contains("the results are byte-identical");

        Files.delete(out.resolve("chunks/000000.csv"));
        Files.delete(out.resolve("report.html"));
        Files.delete(out.resolve("campaign.json"));
        refused(compare(command), "already holds this campaign: add --resume");
        Outcome resumed =
                compare(Stream.concat(Stream.of(command), Stream.of("--resume")).toArray(String[]::new));
        assertThat(resumed.code()).as(resumed.err()).isZero();
        assertThat(bytes(out)).isEqualTo(before);
        assertThat(resumed.out()).isEqualTo(whole.out());
        refused(
                compare(site, "--with=sensors.radar.maxRange=340m", "--runs=70", "--out=" + out, "--resume"),
                "holds another campaign");
    }

    @Test
    void aSingleCaseIsThatOfTheComparison() throws IOException {
        Path out = directory.resolve("single");
        String[] command = {site, "--with=sensors.radar.maxRange=350m", "--runs=9", "--seed=5"};
        assertThat(compare(Stream.concat(Stream.of(command), Stream.of("--out=" + out))
                                .toArray(String[]::new))
                        .code())
                .isZero();
        Outcome single =
                compare(Stream.concat(Stream.of(command), Stream.of("--case=8")).toArray(String[]::new));
        List<String> row =
                List.of(Files.readAllLines(out.resolve("runs.csv")).get(17).split(","));

        assertThat(single.code()).as(single.err()).isZero();
        assertThat(single.out()).contains("case 8, seed " + row.get(2), "bearing=" + row.get(3), "site-changed: ");
    }

    /** The range of all, and then that of the second alone. */
    @Test
    void aSettingMayBeOverriddenInBoth() {
        Outcome neither = compare(site, site, "--set=sensors.radar.maxRange=12m", "--runs=3");
        Outcome second =
                compare(site, "--set=sensors.radar.maxRange=12m", "--with=sensors.radar.maxRange=400m", "--runs=3");

        assertThat(neither.out()).containsPattern("site +3 +0 +0\\.0 .*").containsPattern("site-changed +3 +0 +0\\.0 ");
        assertThat(second.out())
                .containsPattern("site +3 +0 +0\\.0 .*")
                .doesNotContainPattern("site-changed +3 +0 +0\\.0 ");
    }

    @Test
    void wrongInputIsOneLine() {
        refused(compare(site, site, "--resume"), "--resume: needs --out DIR");
        refused(compare(site, site, "--view"), "--view: needs --case K");
        refused(compare(site, "--set=sensors.radar.maxRange=1m"), "needs a second scene, or --with PATH=VALUE");
        refused(compare(site), "needs a second scene, or --with PATH=VALUE");
        refused(compare(site, "--with=sensors.radar"), "--with sensors.radar: must be PATH=VALUE");
        refused(compare(site, "--with=sensors.rader.maxRange=1"), "sensors.rader.maxRange");
        refused(compare(site, "nowhere.yaml"), "nowhere.yaml");
        refused(compare(site, site, "--runs=0"), "--runs=0: runs 0 must be 1 to 1e6");
        refused(
                compare(site, "--with=drones.intruder.speed=1", "--vary=" + campaign),
                "would override 'drones.intruder.speed', which varies");
    }

    private static void refused(Outcome wrong, String message) {
        assertThat(wrong.code()).as(wrong.err()).isEqualTo(2);
        assertThat(wrong.err().lines().filter(line -> line.contains(message)))
                .as(wrong.err())
                .hasSize(1);
    }
}
