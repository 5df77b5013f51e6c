package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dronewatch.Thorough;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.campaign.CampaignSite;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A campaign in parts on several machines: joined, they are the whole campaign, byte for byte. */
class CampaignShardTest {
    private static final String CAMPAIGN = CampaignSite.TWO_RANGES.replace("runs: 60", "runs: 130");

    @TempDir
    private static Path directory;

    @BeforeAll
    static void run() throws IOException {
        CampaignSite.in(directory, CAMPAIGN);
        assertThat(campaign("whole").code()).isZero();
        for (int part = 1; part <= 3; part++) {
            Outcome outcome = campaign("part-" + part, "--shard=" + part + "/3");
            assertThat(outcome.code()).as(outcome.err()).isZero();
        }
    }

    private static String at(String name) {
        return directory.resolve(name).toString();
    }

    private static Outcome campaign(String out, String... more) {
        List<String> words = new ArrayList<>(List.of("campaign", at("attacks.campaign.yaml"), "--out=" + at(out)));
        words.addAll(List.of(more));
        return Program.run(words.toArray(String[]::new));
    }

    private static List<String> bytes(String out) throws IOException {
        return List.of(
                Files.readString(directory.resolve(out).resolve("runs.csv")),
                Files.readString(directory.resolve(out).resolve("campaign.json")),
                Files.readString(directory.resolve(out).resolve("plan.json")));
    }

    @Thorough
    @Test
    void thePartsInAnyOrderGiveTheWholeAndCanBeRepeated() throws IOException {
        Outcome merged = Program.run("merge", at("part-3"), at("part-1"), at("part-2"), "--out", at("merged"));

        assertThat(merged.code()).as(merged.err()).isZero();
        assertThat(bytes("merged")).isEqualTo(bytes("whole"));
        assertThat(directory.resolve("merged/report.html"))
                .hasSameTextualContentAs(directory.resolve("whole/report.html"));
        assertThat(directory.resolve("part-1/report.html")).doesNotExist();
        Outcome again = Program.run("again", at("merged/provenance.json"));
        assertThat(again.code()).as(again.err()).isZero();
        assertThat(again.out()).contains("the results are byte-identical");
    }

    /** Three chunks of further cases, of which the first part has two. */
    @Thorough
    @Test
    void theFurtherCasesOfASensitivityAreDividedAndJoined() throws IOException {
        String further = CAMPAIGN.replace("runs: 130", "runs: 40") + "sensitivity: {method: sobol, base: 20}\n";
        Path file = Files.writeString(directory.resolve("matters.campaign.yaml"), further);
        assertThat(Program.run("campaign", file.toString(), "--out=" + at("matters"))
                        .code())
                .isZero();
        for (int part = 1; part <= 2; part++) {
            String[] command = {"campaign", file.toString(), "--shard=" + part + "/2", "--out=" + at("matters-" + part)
            };
            assertThat(Program.run(command).code()).isZero();
        }
        Outcome merged = Program.run("merge", at("matters-2"), at("matters-1"), "--out", at("matters-merged"));

        assertThat(merged.code()).as(merged.err()).isZero();
        assertThat(bytes("matters-merged")).isEqualTo(bytes("matters"));
        assertThat(directory.resolve("matters/campaign.json")).content().contains("\"sensitivity\"");
        for (String name : List.of("sensitivity.csv", "report.html")) {
            assertThat(directory.resolve("matters-merged").resolve(name))
                    .hasSameTextualContentAs(directory.resolve("matters").resolve(name));
        }
        refused(
                "no directory has cases 50 to 99 of the sensitivity analysis",
                "merge",
                at("matters-1"),
                "--out=" + at("none"));
    }

    /** A part alone cannot tell whether they are met. */
    @Test
    void expectationsAreJudgedWhenThePartsAreJoined() throws IOException {
        String hopeful =
                CAMPAIGN.replace("runs: 130", "runs: 60") + "expect: [{of: detected, variant: near, low: 0.999}]\n";
        Path file = Files.writeString(directory.resolve("hopeful.campaign.yaml"), hopeful);
        for (int part = 1; part <= 2; part++) {
            String[] command = {"campaign", file.toString(), "--shard=" + part + "/2", "--out=" + at("hopeful-" + part)
            };
            assertThat(Program.run(command).code()).isZero();
        }

        Outcome merged = Program.run("merge", at("hopeful-1"), at("hopeful-2"), "--out", at("hopeful"));

        assertThat(merged.code()).isEqualTo(1);
        assertThat(merged.err()).contains("expectation not met: 'detected' for near: lower bound");
        assertThat(directory.resolve("hopeful/report.html")).exists();
    }

    @Test
    void everyCaseIsInExactlyOnePartAsItIsInTheWhole() throws IOException {
        List<String> rows = new ArrayList<>();
        for (int part = 1; part <= 3; part++) {
            List<String> some = Files.readAllLines(directory.resolve("part-" + part + "/runs.csv"));
            assertThat(some.size()).isGreaterThan(1);
            rows.addAll(some.subList(1, some.size()));
        }
        List<String> whole = Files.readAllLines(directory.resolve("whole/runs.csv"));

        assertThat(rows).containsExactlyInAnyOrderElementsOf(whole.subList(1, whole.size()));
    }

    @Test
    void missingCasesAreNamedAndNothingIsWritten() {
        refused("no directory has cases 50 to 99", "merge", at("part-1"), at("part-3"), "--out=" + at("none"));
        refused("holds no campaign", "merge", at("part-1"), at("."), "--out=" + at("none"));
        refused("--out '': the path is empty", "merge", at("part-1"), at("part-2"), at("part-3"), "--out=");
        refused("holds other files", "merge", at("part-1"), at("part-2"), at("part-3"), "--out=" + directory);
        assertThat(directory.resolve("none")).doesNotExist();
    }

    @Test
    void partsOfAnotherCampaignAreRefused() {
        assertThat(campaign("other", "--runs=100", "--shard=2/3").code()).isZero();
        refused("other: holds another campaign", "merge", at("part-1"), at("other"), "--out=" + at("none"));
    }

    @Test
    void aPartMustBeOneOfThem() {
        for (String wrong : List.of("0/3", "4/3", "1", "1/0", "1/1000000", "-1/3", "x")) {
            Outcome outcome = campaign("none", "--shard=" + wrong);
            assertThat(outcome.code()).isEqualTo(2);
            assertThat(outcome.err())
                    .startsWith("--shard " + wrong + ": must be i/n")
                    .hasLineCount(1);
        }
        assertThat(directory.resolve("none")).doesNotExist();
    }

    private static void refused(String message, String... command) {
        Outcome outcome = Program.run(command);
        assertThat(outcome.code()).as(outcome.err()).isEqualTo(2);
        assertThat(outcome.complaints()).hasSize(1).first().asString().contains(message);
    }
}
