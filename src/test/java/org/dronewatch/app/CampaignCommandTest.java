package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.xml.parsers.DocumentBuilderFactory;
import org.dronewatch.Thorough;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.campaign.CampaignSite;
import org.dronewatch.viewer.Viewer;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.w3c.dom.Document;
import org.w3c.dom.NodeList;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** A campaign as the command prints and writes it, and completes it after an interruption. */
class CampaignCommandTest {
    @TempDir
    private static Path directory;

    private static Outcome outcome;

    @BeforeAll
    static void run() throws IOException {
        CampaignSite.in(directory, CampaignSite.TWO_RANGES);
        outcome = campaign("whole");
        assertThat(outcome.code()).as(outcome.err()).isZero();
    }

    private static Outcome campaign(String out, String... more) {
        List<String> arguments = Stream.concat(
                        Stream.of(
                                "campaign",
                                directory.resolve("attacks.campaign.yaml").toString(),
                                "--out=" + directory.resolve(out)),
                        Stream.of(more))
                .toList();
        return Program.run(arguments.toArray(String[]::new));
    }

    private static JsonNode json(String file) throws IOException {
        return JsonMapper.builder().build().readTree(directory.resolve(file).toFile());
    }

    private static List<String> bytes(String out) throws IOException {
        return List.of(
                Files.readString(directory.resolve(out).resolve("runs.csv")),
                Files.readString(directory.resolve(out).resolve("campaign.json")),
                Files.readString(directory.resolve(out).resolve("plan.json")));
    }

    @Test
    void theFilesStateWhatCameOfIt() throws IOException {
        JsonNode file = json("whole/campaign.json");
        JsonNode far = file.get("variants").get("far");
        JsonNode inTime = file.get("pairs").get(2);

        assertThat(file.propertyNames())
                .containsExactly("format", "scene", "seed", "runs", "confidence", "variants", "pairs", "complete");
        assertThat(far.propertyNames())
                .containsExactly(
                        "n",
                        "failed",
                        "cut_short",
                        "failures",
                        "detected",
                        "alerted",
                        "in_time",
                        "range_m",
                        "warning_s",
                        "by_bearing",
                        "by_drone",
                        "by_sensor");
        assertThat(file.get("complete").asBoolean()).isTrue();
        assertThat(inTime.get("of").asString()).isEqualTo("in_time");
        assertThat(inTime.get("only_a").asInt()).isZero();
        assertThat(far.get("in_time").get("k").asInt()
                        - file.get("variants")
                                .get("near")
                                .get("in_time")
                                .get("k")
                                .asInt())
                .isEqualTo(inTime.get("only_b").asInt());
        assertThat(far.get("by_sensor").get("radar").asInt())
                .isEqualTo(far.get("detected").get("k").asInt());
        assertThat(Files.readAllLines(directory.resolve("whole/runs.csv")))
                .hasSize(121)
                .first()
                .asString()
                .startsWith("case,variant,seed,drones.intruder.flight.bearing,");
    }

    /** One case decides, which says nothing. */
    @Test
    void theReportDoesNotTakeChanceForAResult() throws IOException {
        assertThat(json("whole/campaign.json").get("pairs").get(2).get("p").asDouble())
                .isEqualTo(1.0);
        assertThat(Files.readString(directory.resolve("whole/report.html")))
                .contains("It is not clear which is better: the difference between far and near,")
                .contains("is no more than chance can explain (p = 1.000).");
    }

    @Test
    void itPrintsSharesWithIntervalsAndTheVariantsCompared() {
        assertThat(outcome.out())
                .containsPattern("near +60 +0 +\\d+\\.\\d \\(\\d+\\.\\d to \\d+\\.\\d\\)")
                .containsPattern(
                        "in time: near minus far = -\\d+\\.\\d points .*near alone in 0, far alone in \\d+ of 60 cases, p = ");
    }

    @Thorough
    @Test
    void theFilesAreTheSameForAnyNumberOfThreadsAndAfterAnInterruption() throws IOException {
        assertThat(campaign("again", "--threads=4").code()).isZero();
        assertThat(bytes("again")).isEqualTo(bytes("whole"));

        // As a process that was killed leaves it: a chunk that is missing, one that ends early, one half-written.
        Path chunks = directory.resolve("again/chunks");
        Files.delete(chunks.resolve("000001.csv"));
        String first = Files.readString(chunks.resolve("000000.csv"));
        Files.writeString(chunks.resolve("000000.csv"), first.substring(0, first.length() / 2));
        Files.writeString(chunks.resolve(".partial-1"), "case,var");
        Files.delete(directory.resolve("again/runs.csv"));
        assertThat(campaign("again", "--resume").code()).isZero();
        assertThat(bytes("again")).isEqualTo(bytes("whole"));
        assertThat(Files.list(chunks)).hasSize(2);
    }

    /** At most 104 cases, in three chunks; those of the last chunk that are not needed are left out. */
    @Thorough
    @Test
    void aCampaignEndsAsSoonAsTheProbabilityIsKnown() throws IOException {
        Path file = Files.writeString(
                directory.resolve("precise.campaign.yaml"),
                CampaignSite.TWO_RANGES.replace(
                        "runs: 60", "until: {of: in_time, variant: far, halfWidth: 0.12, confidence: 0.9}"));
        String[] command = {"campaign", file.toString(), "--out=" + directory.resolve("precise"), "--threads=3"};
        Outcome precise = Program.run(command);
        JsonNode until = json("precise/campaign.json").get("until");
        List<String> rows = Files.readAllLines(directory.resolve("precise/runs.csv"));
        List<String> before = bytes("precise");

        assertThat(precise.code()).as(precise.err()).isZero();
        assertThat(until.get("reached").asBoolean()).isTrue();
        assertThat(until.get("n").asInt()).isBetween(51, 104).isEqualTo((rows.size() - 1) / 2);
        assertThat(rows.stream().filter(row -> row.contains(",far,") && row.contains(",true,")))
                .hasSize(until.get("k").asInt());
        assertThat(precise.out())
                .containsPattern(
                        "'in time' for far to within 12 percentage points at 90 % confidence: .* after \\d+ cases");

        Files.delete(directory.resolve("precise/chunks/000001.csv"));
        Files.delete(directory.resolve("precise/runs.csv"));
        assertThat(Program.run(command).code()).isEqualTo(2);
        Outcome resumed = Program.run(
                Stream.concat(Stream.of(command), Stream.of("--resume")).toArray(String[]::new));
        assertThat(resumed.code()).isZero();
        assertThat(bytes("precise")).isEqualTo(before);
        assertThat(resumed.out()).isEqualTo(precise.out());
    }

    /** Room for the plan, or for a chunk or two; then for all. */
    @Thorough
    @ParameterizedTest
    @ValueSource(strings = {"4k", "8k", "20k", "28k"})
    void aFullDiskIsOneLineAndTheCampaignIsCompletedWhenThereIsRoom(String size) throws Exception {
        try (SmallDisk disk = new SmallDisk(directory.resolve("disk-" + size), size)) {
            Path out = disk.path().resolve("out");
            Outcome full = campaign(out.toString());
            assertThat(full.code()).isEqualTo(2);
            assertThat(full.complaints())
                    .hasSize(1)
                    .first()
                    .asString()
                    .startsWith("--out " + out)
                    .endsWith("cannot be written: " + disk.reasonOfAFullDisk());

            disk.resize("1m");
            assertThat(campaign(out.toString(), "--resume").code()).isZero();
            assertThat(bytes(out.toString())).isEqualTo(bytes("whole"));
        }
    }

    /** So do the files that values of settings name. */
    @Test
    void aCampaignWhoseVaryingModelHasChangedIsNotCompleted() throws IOException {
        Path changing = Files.createDirectory(directory.resolve("varying"));
        Path file = CampaignSite.in(
                changing,
                """
                scene: site.yaml
                vary: {drones.intruder.model: {values: [one.obj, two.obj]}}
                runs: 4
                """);
        Path two = changing.resolve("two.obj");
        for (String name : List.of("one.obj", "two.obj")) {
            Files.writeString(changing.resolve(name), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        }
        String[] command = {"campaign", file.toString(), "--out=" + changing.resolve("out"), "--resume"};
        assertThat(Program.run(command).code()).isZero();
        assertThat(Program.run(command).code()).isZero();
        String before = Files.readString(two);

        Files.writeString(two, before.replace("0 1 0", "0 2 0"));
        refused(Program.run(command), "holds another campaign: choose another directory");
        Files.delete(two);
        refused(Program.run(command), "holds another campaign: choose another directory");
        Files.writeString(two, before);
        assertThat(Program.run(command).code()).isZero();
    }

    /** Whatever the results depend on. */
    @Thorough
    @Test
    void aCampaignOfWhichAnythingHasChangedIsNotCompleted() throws IOException {
        Path changing = Files.createDirectory(directory.resolve("changing"));
        Path file = CampaignSite.in(changing, CampaignSite.TWO_RANGES);
        String[] command = {"campaign", file.toString(), "--out=" + changing.resolve("out"), "--resume"};
        assertThat(Program.run(command).code()).isZero();
        for (String name : List.of("ground.obj", "site.yaml", "attacks.campaign.yaml")) {
            Path changed = changing.resolve(name);
            String before = Files.readString(changed);
            Files.writeString(changed, before.replace("600", "601").replace("900", "901"));
            refused(Program.run(command), "holds another campaign: choose another directory");
            Files.writeString(changed, before);
        }
        Path plan = changing.resolve("out/plan.json");
        String text = Files.readString(plan);
        Files.writeString(plan, text.replaceFirst("\"hash\" : \"..", "\"hash\" : \"__"));
        refused(Program.run(command), "holds another campaign: choose another directory");
        Files.writeString(plan, text);
        assertThat(Program.run(command).code()).isZero();
    }

    /** The distance decides how early the radar, which sees farther than all of them, gives its warning. */
    @Test
    void furtherCasesShowWhichSettingsMatter() throws IOException {
        Path file = Files.writeString(
                directory.resolve("matters.campaign.yaml"),
                """
                scene: site.yaml
                vary:
                  drones.intruder.flight.distance: {uniform: {from: 100 m, to: 350 m}}
                  drones.intruder.flight.height: {uniform: {from: 39.9 m, to: 40 m}}
                runs: 1
                sensitivity: {method: sobol, base: 20}
                """);
        String[] command = {"campaign", file.toString(), "--out=" + directory.resolve("matters")};
        Outcome matters = Program.run(command);
        JsonNode distance = json("matters/campaign.json").get("sensitivity").get(0);
        String before = Files.readString(directory.resolve("matters/campaign.json"));

        assertThat(matters.code()).as(matters.err()).isZero();
        assertThat(matters.err())
                .contains("sensitivity: 100 more cases of scene, 5 in each of 20 groups, with 3 factors");
        assertThat(distance.propertyNames())
                .containsExactly("path", "first", "low", "high", "total", "total_low", "total_high");
        assertThat(distance.get("total").asDouble()).isBetween(0.9, 1.1);
        assertThat(matters.out())
                .contains("what explains the warning time with scene, in % of its variance")
                .containsPattern("drones.intruder.flight.distance +alone +\\d")
                .containsPattern("chance +alone");
        assertThat(Files.readAllLines(directory.resolve("matters/sensitivity.csv")))
                .hasSize(101);
        assertThat(Files.readString(directory.resolve("matters/report.html")))
                .contains(String.format(
                        Locale.ROOT,
                        "drones.intruder.flight.distance, alone: %.1f %% (",
                        100.0 * distance.get("first").asDouble()));

        Files.delete(directory.resolve("matters/sensitivity/000001.csv"));
        assertThat(Program.run(Stream.concat(Stream.of(command), Stream.of("--resume"))
                                .toArray(String[]::new))
                        .code())
                .isZero();
        assertThat(Files.readString(directory.resolve("matters/campaign.json"))).isEqualTo(before);
    }

    /** Seven attacks that are met in time, whose lower bound is 7 / (7 + 1.96^2), and one whose values contradict. */
    @Test
    void expectationsThatAreNotMetFailTheCommandAndItsReport() throws Exception {
        Path file = Files.writeString(
                directory.resolve("expected.campaign.yaml"),
                """
                scene: site.yaml
                table: expected.csv
                expect:
                  - {of: detected, low: 0.3}
                  - {of: in_time, variant: scene, low: 0.99}
                """);
        Files.writeString(
                directory.resolve("expected.csv"),
                "drones.intruder.flight.distance,drones.intruder.flight.standoff\n" + "500 m,0 m\n".repeat(7)
                        + "300 m,400 m\n");
        Path xml = directory.resolve("expected.xml");
        Outcome expected =
                Program.run("campaign", file.toString(), "--out=" + directory.resolve("expected"), "--junit=" + xml);
        Document document =
                DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(xml.toFile());
        NodeList suites = document.getElementsByTagName("testsuite");

        assertThat(expected.code()).as(expected.err()).isEqualTo(1);
        assertThat(expected.err())
                .contains("expectation not met: 'in time' for scene: lower bound 0.6457, must be at least 0.99")
                .doesNotContain("'detected' for");
        assertThat(suites.getLength()).isEqualTo(2);
        assertThat(attributes(suites.item(0))).isEqualTo("expectations 2 1");
        assertThat(attributes(suites.item(1))).isEqualTo("scene 8 1");
        assertThat(document.getElementsByTagName("testcase").getLength()).isEqualTo(10);
        assertThat(document.getElementsByTagName("failure").getLength()).isEqualTo(2);
    }

    /** Also what shows only when the cases are prepared. */
    @Test
    void aMistakeInTheFileIsReportedWithItsLine() throws IOException {
        Path file = directory.resolve("wrong.campaign.yaml");
        String[] command = {"campaign", file.toString(), "--out=" + directory.resolve("wrong")};
        String vary = "scene: site.yaml\nvary:\n  drones.intruder.speed: {normal: {mean: %s, deviation: %s}}\n";

        Files.writeString(file, String.format(vary, "10 m/s", "NaN"));
        refused(Program.run(command), "wrong.campaign.yaml:3:26: vary.drones.intruder.speed: deviation: 'NaN'");
        Files.writeString(file, String.format(vary, "1e308", "1e308"));
        refused(Program.run(command), "wrong.campaign.yaml:3:26: vary.drones.intruder.speed: mean 1.0E308 and");
        Files.writeString(file, "runs: 2\nscene: nowhere.yaml\n");
        refused(Program.run(command), "wrong.campaign.yaml:2:8: scene ", "nowhere.yaml cannot be read: no such file");
        Files.writeString(file, "runs: 2\nscene: ../site.yaml\n");
        refused(Program.run(command), "wrong.campaign.yaml:2:8: scene '../site.yaml': a scene file must lie");
        Files.writeString(file, "scene: site.yaml\nvary: ../t.csv\n");
        refused(Program.run(command), "wrong.campaign.yaml:2:7: table ../t.csv: must lie in the directory");
    }

    /** The results are kept, but nobody takes them for a success. */
    @Test
    void aCampaignOfWhichNoCaseCouldBeRunFails() throws IOException {
        Path file = Files.writeString(
                directory.resolve("none.campaign.yaml"),
                """
                scene: site.yaml
                vary:
                  drones.intruder.flight.distance: {values: [300 m]}
                  drones.intruder.flight.standoff: {values: [400 m, 500 m]}
                runs: 4
                """);
        Path out = directory.resolve("none-run");

        Outcome none = Program.run("campaign", file.toString(), "--out=" + out, "--set=alert.response=0 s");

        assertThat(none.code()).isEqualTo(1);
        assertThat(none.err())
                .contains("warning: 4 cases of scene could not be run")
                .containsPattern("no case could be run: .*standoff");
        assertThat(Files.readString(out.resolve("report.html")))
                .contains("No case could be run.")
                .doesNotContain("'In time' means");
    }

    /** Whatever the values draw: the others are run, and the counts say how many were not, and why. */
    @Test
    void aCaseThatFailsHasItsRowAndTheRestGoesOn() throws IOException {
        Path file = Files.writeString(
                directory.resolve("odd.campaign.yaml"),
                """
                scene: site.yaml
                vary:
                  drones.intruder.flight.distance: {values: [300 m, 500 m]}
                  drones.intruder.flight.standoff: {uniform: {from: 0 m, to: 400 m}}
                runs: 60
                """);
        Outcome odd = Program.run("campaign", file.toString(), "--out=" + directory.resolve("odd"), "--threads=3");
        List<String> rows = Files.readAllLines(directory.resolve("odd/runs.csv"));
        long failed = rows.stream().filter(row -> row.contains(",failed,")).count();
        JsonNode scene = json("odd/campaign.json").get("variants").get("scene");
        JsonNode reason = scene.get("failures").get(0);

        assertThat(odd.code()).as(odd.err()).isZero();
        assertThat(rows).hasSize(61);
        assertThat(failed).isBetween(1L, 59L);
        assertThat(scene.get("failed").asLong()).isEqualTo(failed);
        assertThat(scene.get("detected").get("n").asLong()).isEqualTo(60 - failed);
        assertThat(scene.get("failures")).as("numbers apart, it is one reason").hasSize(1);
        assertThat(reason.get("cases").asLong()).isEqualTo(failed);
        assertThat(rows.get(1 + reason.get("case").asInt()))
                .contains(reason.get("error").asString());
        String line = failed + " cases of scene could not be run (first: case "
                + reason.get("case").asInt() + "): " + reason.get("error").asString();
        assertThat(odd.err()).contains("warning: " + line);
        assertThat(Files.readString(directory.resolve("odd/report.html"))).contains(line);
    }

    private static String attributes(org.w3c.dom.Node suite) {
        return suite.getAttributes().getNamedItem("name").getNodeValue() + " "
                + suite.getAttributes().getNamedItem("tests").getNodeValue() + " "
                + suite.getAttributes().getNamedItem("failures").getNodeValue();
    }

    @Test
    void aCaseAloneIsThatOfTheCampaign() throws IOException {
        Outcome alone = campaign("none", "--case", "7");
        String row = Files.readAllLines(directory.resolve("whole/runs.csv")).get(16);

        assertThat(alone.code()).isZero();
        assertThat(row).startsWith("7,far,");
        assertThat(alone.out()).contains("case 7, seed " + row.split(",")[2], row.split(",")[3]);
        assertThat(directory.resolve("none")).doesNotExist();
    }

    /** Without a display: CaseWindowTest opens the window. */
    @Test
    void aCaseIsNotShownWithoutADisplay() {
        assumeTrue(Viewer.obstacle().isPresent(), "there is a display");
        Outcome shown = campaign("none", "--case=7", "--view");

        assertThat(shown.code()).isEqualTo(3);
        assertThat(shown.out()).isEmpty();
        assertThat(shown.complaints()).hasSize(1).first().asString().startsWith("cannot open a window: ");
    }

    @Test
    void aCaseIsDrawnWithoutADisplay() throws IOException {
        Path picture = directory.resolve("case.png");
        Outcome drawn = campaign("none", "--case=34", "--variant=far", "--picture=" + picture);

        assertThat(drawn.code()).as(drawn.err()).isZero();
        assertThat(ImageIO.read(picture.toFile()).getWidth()).isEqualTo(920);
        refused(campaign("new", "--case=34", "--picture=a.jpg"), "--picture a.jpg: must end in .png");
        refused(campaign("new", "--picture=a.png"), "--picture a.png: needs --case K");
    }

    @Test
    void seedAndSettingsMayBeOverridden() {
        Outcome first = campaign("none", "--case=7", "--variant=far");
        Outcome seeded = campaign("none", "--case=7", "--variant=far", "--seed=2");
        Outcome blind = campaign("none", "--case=7", "--set=sensors.radar.maxRange=12 m");

        assertThat(first.out()).contains("\nfar: ").doesNotContain("near: ");
        assertThat(seeded.out()).contains("case 7, seed ").isNotEqualTo(first.out());
        assertThat(blind.out().lines().toList())
                .as("near sets a range of its own")
                .anyMatch(line -> line.startsWith("near: first detected"))
                .anyMatch(line -> line.startsWith("far: never detected"));
    }

    @Test
    void whatIsThereIsNotOverwritten() throws IOException {
        assertThat(campaign("whole").code()).isEqualTo(2);
        assertThat(campaign("whole").err()).contains("already holds this campaign: add --resume");
        assertThat(campaign("whole", "--runs=61", "--resume").err()).contains("holds another campaign");
        assertThat(campaign("").err()).contains("holds other files");
        assertThat(campaign("site.yaml").err()).contains("is a file");
    }

    @Test
    void wrongInputIsOneLineAndLeavesNothing() throws IOException {
        refused(campaign("new", "--case=60"), "--case 60: must be 0 to 59");
        refused(campaign("new", "--view"), "--view: needs --case K, the case to be run");
        refused(
                campaign("new", "--case=1", "--variant=none"),
                "--variant none: no such variant; the campaign has near, far");
        refused(
                campaign("new", "--set=drones.intruder.speed=1"),
                "'drones.intruder.speed' would override 'drones.intruder.speed', which varies");
        refused(campaign("new", "--set=sensors.rader.maxRange=1"), "sensors.rader.maxRange");
        refused(campaign("new", "--runs=0"), "--runs=0: runs 0 must be 1 to 1e6");
        Path file = Files.writeString(
                directory.resolve("bad.yaml"), "scene: site.yaml\nvary: {a.b: {values: [1]}}\nruns: 5\n");
        refused(Program.run("campaign", file.toString(), "--out=" + directory.resolve("new")), "vary.a.b: ");
        Files.writeString(file, "scene: site.yaml\nvary: {}\nruns: many\n");
        refused(Program.run("campaign", file.toString(), "--out=" + directory.resolve("new")), "bad.yaml:3:7: runs");
        refused(Program.run("campaign", "nowhere.yaml"), "nowhere.yaml");
    }

    private static void refused(Outcome wrong, String... parts) {
        assertThat(wrong.code()).as(wrong.err()).isEqualTo(2);
        assertThat(wrong.err().lines().filter(line -> Stream.of(parts).allMatch(line::contains)))
                .as(wrong.err())
                .hasSize(1);
        assertThat(directory.resolve("new")).doesNotExist();
    }
}
