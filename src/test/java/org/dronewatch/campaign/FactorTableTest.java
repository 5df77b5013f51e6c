package org.dronewatch.campaign;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class FactorTableTest {
    private static final String ROWS =
            """
            drones.intruder.flight.bearing,drones.intruder.speed
            10 deg,12 m/s
            -20 deg,36 km/h
            "30 deg", 14 m/s
            """;

    @TempDir
    private Path directory;

    @TempDir
    private Path other;

    @BeforeEach
    void write() throws IOException {
        Files.writeString(directory.resolve("factors.csv"), ROWS);
    }

    private CampaignPlan plan(String campaign) throws IOException {
        return CampaignSite.plan(directory, "scene: site.yaml\n" + campaign);
    }

    @ParameterizedTest
    @ValueSource(strings = {"vary: factors.csv", "vary: {factors.csv}", "table: factors.csv", "table: ./factors.csv"})
    void theRowsAreTheCases(String line) throws IOException {
        CampaignPlan plan = plan(line);

        assertThat(plan.size()).isEqualTo(3);
        assertThat(plan.paths()).containsExactly("drones.intruder.flight.bearing", "drones.intruder.speed");
        assertThat(plan.values(1)).containsExactly("-20 deg", "36 km/h");
        assertThat(plan.settings(1, "scene").drones().get("intruder").speed()).isEqualTo(10.0);
        assertThat(plan.settings(2, "scene").drones().get("intruder").speed()).isEqualTo(14.0);
        assertThat(CaseRun.of(plan, 2, "scene").isFailed()).isFalse();
    }

    @Test
    void otherSettingsMayBeDrawn() throws IOException {
        CampaignPlan plan = plan(
                """
                vary: {factors.csv, run.duration: {uniform: {from: 10 s, to: 20 s}}}
                runs: 2
                """);

        assertThat(plan.size()).isEqualTo(2);
        assertThat(plan.values(1)).hasSize(3).startsWith("-20 deg", "36 km/h");
        assertThat(plan("table: factors.csv\nruns: 9").size()).isEqualTo(3);
        assertThat(plan("table: factors.csv\nuntil: {of: detected, halfWidth: 0.4}")
                        .size())
                .isEqualTo(3);
    }

    @Test
    void aMistakeIsReportedWithLineAndColumn() throws IOException {
        wrong("drones.intruder.speed\n12 m/s\nfast\n", "factors.csv:3: drones.intruder.speed: ", "fast");
        wrong("drones.intruder.speed\n12 m/s\n12 kg\n", "factors.csv:3: drones.intruder.speed: ", "kg");
        wrong("drones.intruder.sped\n12 m/s\n", "factors.csv:2: drones.intruder.sped: ", "did you mean 'speed'?");
        wrong("a,b\n1,2\n3\n", "factors.csv:3: number of values is 1 but must be 2, one for each column");
        wrong("a,b\n1,\n", "factors.csv:2: b: is empty");
        wrong("a,a\n1,2\n", "factors.csv:1: column 2: a appears twice");
        wrong("a,\n1,2\n", "factors.csv:1: column 2 has no path");
        wrong("a.b,a\n1,2\n", "factors.csv:1: column 2: a: overlaps 'a.b', which varies as well");
        wrong("a,run.seed\n1,2\n", "factors.csv:1: column 2: run.seed: cannot be set, because each case has its own");
        wrong("a\n", "factors.csv: must have a line with the paths of settings and at least one row");
        wrong("a,b\n\0\u0001,2\n", "factors.csv: is not text; a table is a CSV file in UTF-8");
        wrong("", "factors.csv: must have a line");
        wrong("a\n\"1\n", "factors.csv");
    }

    private void wrong(String table, String... messages) throws IOException {
        Files.writeString(directory.resolve("factors.csv"), table);
        assertThatThrownBy(() -> plan("table: factors.csv"))
                .isInstanceOf(InputException.class)
                .message()
                .contains(messages)
                .doesNotContain("\n");
    }

    @Test
    void aTableIsReadFromTheDirectoryOfTheCampaignOnly() throws IOException {
        refused("table: ../factors.csv", "must lie in the directory of the campaign file or below it");
        refused("table: nowhere.csv", "no such file");
        refused("table: factors.csv\nvary: {drones.intruder.speed: {values: [1]}}", "is also a column of factors.csv");
        refused(
                "table: factors.csv\nvary: {drones.intruder.flight: {values: [1]}}",
                "vary.drones.intruder.flight: overlaps 'drones.intruder.flight.bearing', a column of factors.csv");
        refused("table: factors.csv\nvariants: {a: {drones.intruder.speed: 1}}", "which varies from case to case");
        Path elsewhere = Files.writeString(other.resolve("t.csv"), ROWS);
        Files.createSymbolicLink(directory.resolve("link.csv"), elsewhere);
        refused("table: link.csv", "is a link that leads out of");
        Files.delete(directory.resolve("link.csv"));
    }

    private void refused(String campaign, String message) {
        assertThatThrownBy(() -> plan(campaign))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(message);
    }
}
