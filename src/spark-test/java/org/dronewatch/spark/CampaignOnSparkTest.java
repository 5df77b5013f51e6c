package org.dronewatch.spark;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.stream.Stream;
import org.dronewatch.app.Main;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.campaign.CampaignReader;
import org.dronewatch.campaign.CampaignSite;
import org.dronewatch.campaign.CaseRun;
import org.dronewatch.report.campaign.RemoteChunks;
import org.dronewatch.setting.input.FileHash;
import org.dronewatch.spark.SparkHome.Outcome;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A campaign on a cluster of two processes: its files are those of {@code campaign}, byte for byte. */
class CampaignOnSparkTest {
    private static final String WITH_SENSITIVITY =
            CampaignSite.TWO_RANGES.replace("runs: 60", "runs: 330\nsensitivity: {method: morris, base: 20}");

    @TempDir
    private static Path directory;

    private static SparkHome spark;
    private static Path file;

    @BeforeAll
    static void runHere() throws IOException {
        spark = new SparkHome(directory.resolve("spark"));
        file = CampaignSite.in(Files.createDirectories(directory.resolve("site")), WITH_SENSITIVITY);
        here("campaign", file.toString(), "--out", at("whole"));
    }

    private static String at(String name) {
        return directory.resolve(name).toString();
    }

    private static String here(String... words) {
        StringWriter out = new StringWriter();
        StringWriter err = new StringWriter();
        int code = Main.execute(new PrintWriter(out, true), new PrintWriter(err, true), words);
        assertThat(code).as(err.toString()).isZero();
        return out.toString();
    }

    /** All files by their names, but for the one that states when and how they were made. */
    private static Map<String, String> files(String name) throws IOException {
        Path results = directory.resolve(name);
        Map<String, String> files = new TreeMap<>();
        try (Stream<Path> all = Files.walk(results)) {
            for (Path one : all.filter(Files::isRegularFile).toList()) {
                files.put(
                        results.relativize(one).toString(),
                        FileHash.ofText(Files.readString(one, StandardCharsets.UTF_8)));
            }
        }
        assertThat(files.remove("provenance.json")).isNotNull();
        return files;
    }

    @Test
    void itWritesTheFilesOfCampaignAndPrintsTheSame() throws Exception {
        Outcome outcome = spark.submit(List.of(), file.toString(), "--out", at("cluster"));

        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(files("cluster")).isEqualTo(files("whole")).containsKeys("runs.csv", "report.html");
        assertThat(outcome.out()).isEqualTo(here("campaign", file.toString(), "--out", at("whole"), "--resume"));
        assertThat(here("again", at("cluster/provenance.json"))).contains("the results have the same bytes");
        assertThatCasesAloneInABatchAndInAPartAreTheSame("cluster");
    }

    private static void assertThatCasesAloneInABatchAndInAPartAreTheSame(String cluster) throws IOException {
        here("campaign", file.toString(), "--shard=2/3", "--out", at("part"));
        CampaignPlan plan = new CampaignPlan(CampaignReader.read(file), file.getParent(), note -> {});
        for (int number : List.of(50, 77, 200, 249)) {
            List<String> alone = new ArrayList<>();
            for (String variant : plan.variants()) {
                byte[] rows = new RemoteChunks(plan).write(List.of(CaseRun.of(plan, number, variant)));
                alone.add(new String(rows, StandardCharsets.UTF_8)
                        .lines()
                        .toList()
                        .get(1));
            }
            for (String results : List.of(cluster, "whole", "part")) {
                List<String> rows = Files.readAllLines(
                                directory.resolve(results).resolve("runs.csv"))
                        .stream()
                        .filter(row -> row.startsWith(number + ","))
                        .toList();
                assertThat(FileHash.ofText(String.join("\n", rows)))
                        .as("case %d of %s", number, results)
                        .isEqualTo(FileHash.ofText(String.join("\n", alone)));
            }
        }
    }

    @Test
    void anExecutorThatIsHaltedAmidATaskChangesNothing() throws Exception {
        Path marker = directory.resolve("halted");
        spark.add(HaltOnce.class);
        Outcome outcome = spark.submit(
                List.of("spark.plugins=" + HaltOnce.class.getName(), HaltOnce.MARKER + "=" + marker),
                file.toString(),
                "--out",
                at("halted-once"));

        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(marker).exists();
        assertThat(outcome.err()).contains("Lost executor");
        assertThat(files("halted-once")).isEqualTo(files("whole"));
    }

    /** What executors read from a shared directory must be what the driver has read; then it can be completed. */
    @Test
    void aChangedSceneIsRefusedAndTheRightOneCompletesTheCampaign() throws Exception {
        Path other = CampaignSite.in(Files.createDirectories(directory.resolve("other")), WITH_SENSITIVITY);
        Path scene = other.resolveSibling("site.yaml");
        Files.writeString(scene, Files.readString(scene).replace("response: 12 s", "response: 13 s"));

        Outcome refused =
                spark.submit(List.of(SparkCluster.SHARED + "=" + other), file.toString(), "--out", at("shared"));
        assertThat(refused.code()).as(refused.err()).isEqualTo(2);
        assertThat(refused.err())
                .contains(other + ": the campaign, its scene, a model or the version of dronewatch differs on an"
                        + " executor from what the driver has read")
                .doesNotContain("at org.dronewatch");
        assertThat(refused.out()).isEmpty();

        Files.writeString(scene, Files.readString(file.resolveSibling("site.yaml")));
        Outcome completed = spark.submit(
                List.of(SparkCluster.SHARED + "=" + other), file.toString(), "--out", at("shared"), "--resume");
        assertThat(completed.code()).as(completed.err()).isZero();
        assertThat(files("shared")).isEqualTo(files("whole"));
    }

    @Test
    void aCampaignThatEndsByItsOutcomesEndsWithTheSameCase() throws Exception {
        Path until = Files.writeString(
                file.resolveSibling("until.campaign.yaml"),
                CampaignSite.TWO_RANGES.replace("runs: 60", "until: {of: in_time, variant: near, halfWidth: 0.06}"));
        here("campaign", until.toString(), "--out", at("until"));

        Outcome outcome = spark.submit(List.of(), until.toString(), "--out", at("until-cluster"));

        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(files("until-cluster")).isEqualTo(files("until"));
    }

    /** Spark brings libraries of its own; those of dronewatch that it has in other versions have other names. */
    @Test
    void theJarHoldsNothingOfSparkAndNothingThatItWouldReplace() throws IOException {
        try (JarFile jar = new JarFile(SparkHome.program().toFile())) {
            assertThat(jar.stream().map(JarEntry::getName))
                    .contains("org/dronewatch/spark/CampaignOnSpark.class")
                    .noneMatch(name -> name.matches(
                            "(org/apache/(spark|hadoop|logging)|scala|com/fasterxml|org/snakeyaml|org/slf4j)/.*"));
        }
    }
}
