package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import org.dronewatch.Thorough;
import org.dronewatch.report.RunReport;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.Draws;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** What a run's files say of where they come from, and that the result itself says nothing of it. */
class ProvenanceTest {
    private static final JsonMapper JSON = JsonMapper.builder().build();

    @TempDir
    private Path directory;

    private Path scene;

    @BeforeEach
    void writeScene() throws IOException {
        scene = directory.resolve("site.yaml");
        Files.writeString(
                scene,
                """
                world: {models: [{file: site.obj, upAxis: z}], origin: {latitude: 50.08 deg, longitude: 14.42 deg, height: 250 m}}
                drones: {one: {model: packaged:quadrotor.obj, flight: {kind: hover, position: [0, 40, 10]}}}
                sensors:
                  eye: {kind: camera, position: [0, 0, 2], aim: {lookAt: [0, 40, 10]}}
                  own: {use: mine, position: [1, 0, 2]}
                run: {duration: 0.5 s}
                sweep: {parameter: sensors.eye.fov, values: [20 deg, 40 deg]}
                """);
        Files.writeString(
                directory.resolve("mine.yaml"),
                """
                title: mine
                basis: assumed
                source: a test
                note: none
                coverage: all round
                ranges: []
                sensor: {kind: radar, budget: {kind: data-sheet, range: 1000, crossSection: 0.01}}
                """);
        Files.writeString(
                directory.resolve("site.obj"), "mtllib site.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
        Files.writeString(directory.resolve("site.mtl"), "newmtl a\nKd 1 0 0\n");
    }

    private String run(String out, String... more) throws IOException {
        List<String> arguments = new ArrayList<>(
                List.of("run", scene.toString(), "--out", directory.resolve(out).toString()));
        arguments.addAll(List.of(more));
        Program.Outcome outcome = Program.run(arguments.toArray(String[]::new));
        assertThat(outcome.code()).as(outcome.err()).isZero();
        return Files.readString(directory.resolve(out).resolve("result.json"));
    }

    private JsonNode provenance(String out) throws IOException {
        return JSON.readTree(Files.readString(directory.resolve(out).resolve("provenance.json")));
    }

    private static String sha256(Path file) throws IOException, NoSuchAlgorithmException {
        return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(Files.readAllBytes(file)));
    }

    @Thorough
    @Test
    void theResultHasTheSameBytesForAnyThreadsDirectoryAndTime() throws IOException, InterruptedException {
        String first = run("one", "--threads", "1");
        Thread.sleep(1100);
        String second = run("two", "--threads", "2");

        assertThat(second).isEqualTo(first);
        assertThat(provenance("two").get("date")).isNotEqualTo(provenance("one").get("date"));
        JsonNode result = JSON.readTree(first);
        assertThat(result.propertyNames())
                .containsExactly(
                        "scene", "seed", "origin", "simulated_s", "complete", "seeds", "pairs", "alerts", "sweep");
        JsonNode summary = JSON.readTree(Files.readString(directory.resolve("one/summary.json")));
        for (String key : result.propertyNames()) {
            assertThat(summary.get(key)).as(key).isEqualTo(result.get(key));
        }
        assertThat(summary.propertyNames())
                .contains("threads", "load_s", "build_s", "wall_s", "looking_s", "real_time_factor");
    }

    /** Run 0 of a sweep has the seed as given, run k the one derived from it by the name "run" and its number. */
    @Thorough
    @Test
    void theResultStatesTheSeedOfEveryRun() throws IOException {
        long seed = 12_345L;
        Path out = directory.resolve("swept");
        Program.Outcome outcome = Program.run(
                "run",
                "camera-range",
                "--set",
                "run.duration=0.1",
                "--set",
                "run.seed=" + seed,
                "--out",
                out.toString());
        assertThat(outcome.code()).as(outcome.err()).isZero();
        JsonNode result = JSON.readTree(Files.readString(out.resolve("result.json")));

        assertThat(result.get("seed").asLong()).isEqualTo(seed);
        List<Long> seeds = new ArrayList<>();
        result.get("seeds").forEach(one -> seeds.add(one.asLong()));
        assertThat(seeds).hasSize(5);
        assertThat(seeds.get(0)).isEqualTo(seed);
        for (int k = 1; k < seeds.size(); k++) {
            assertThat(seeds.get(k)).as("run %d", k).isEqualTo(Draws.derivedSeed(seed, "run", k));
        }
    }

    @Test
    void theProvenanceNamesProgramCommandAndEveryFile() throws IOException, NoSuchAlgorithmException {
        Instant before = Instant.now().minusSeconds(1);
        run("out", "--threads", "1", "--set", "run.seed=7");
        JsonNode known = provenance("out");

        assertThat(known.get("program").asString()).isEqualTo("dronewatch");
        assertThat(known.get("version").asString()).matches("\\d+\\.\\d+\\.\\d+.*");
        assertThat(known.get("date").asString()).matches("\\d{4}-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\dZ");
        assertThat(Instant.parse(known.get("date").asString())).isBetween(before, Instant.now());
        assertThat(known.get("command").toString())
                .isEqualTo(JSON.writeValueAsString(List.of(
                        "run",
                        scene.toString(),
                        "--out",
                        directory.resolve("out").toString(),
                        "--threads",
                        "1",
                        "--set",
                        "run.seed=7")));
        assertThat(known.get("threads").asInt()).isEqualTo(1);
        assertThat(known.get("java_version").asString()).isEqualTo(System.getProperty("java.version"));
        assertThat(known.get("operating_system").asString()).contains(System.getProperty("os.name"));
        assertThat(known.get("architecture").asString()).isEqualTo(System.getProperty("os.arch"));
        JsonNode files = known.get("scene").get("files");
        assertThat(files.get(0).get("file").asString()).isEqualTo("site.yaml");
        assertThat(files.get(0).get("sha256").asString()).isEqualTo(sha256(scene));
        assertThat(files.get(1).get("file").asString()).isEqualTo("mine.yaml");
        assertThat(files.get(1).get("sha256").asString()).isEqualTo(sha256(directory.resolve("mine.yaml")));
        assertThat(files.size()).isEqualTo(2);
        JsonNode model = known.get("models").get(0);
        assertThat(model.get("file").asString()).isEqualTo("site.obj");
        assertThat(model.get("sha256").asString()).isEqualTo(sha256(directory.resolve("site.obj")));
        assertThat(model.get("materials").get(0).get("sha256").asString())
                .isEqualTo(sha256(directory.resolve("site.mtl")));
        assertThat(known.get("models").get(1).get("file").asString()).isEqualTo("packaged:quadrotor.obj");
        assertThat(known.get("models").get(1).get("materials").size()).isEqualTo(1);
    }

    @Thorough
    @Test
    void whatChangesChangesItsOwnHashOnly() throws IOException {
        run("one");
        Files.writeString(directory.resolve("site.mtl"), "newmtl a\nKd 0 1 0\n");
        run("two");
        JsonNode one = provenance("one");
        JsonNode two = provenance("two");
        assertThat(two.get("scene")).isEqualTo(one.get("scene"));
        assertThat(two.get("models").get(0).get("sha256"))
                .isEqualTo(one.get("models").get(0).get("sha256"));
        assertThat(two.get("models").get(0).get("materials"))
                .isNotEqualTo(one.get("models").get(0).get("materials"));

        Files.writeString(scene, Files.readString(scene) + "# a remark\n");
        run("three");
        JsonNode three = provenance("three").get("scene");
        assertThat(three.get("settings_sha256")).isEqualTo(two.get("scene").get("settings_sha256"));
        assertThat(three.get("files").get(0))
                .isNotEqualTo(two.get("scene").get("files").get(0));

        run("four", "--set", "drones.one.speed=9 m/s");
        JsonNode four = provenance("four").get("scene");
        assertThat(four.get("files")).isEqualTo(three.get("files"));
        assertThat(four.get("settings_sha256")).isNotEqualTo(three.get("settings_sha256"));
    }

    /** A scene that is edited while it runs: what it was run from counts. */
    @Test
    void theHashIsThatOfTheSceneThatWasRun() throws IOException, NoSuchAlgorithmException {
        SceneFile file = new SceneFile(scene);
        SceneRunner runner = new SceneRunner(file);
        String before = sha256(scene);
        runner.run();
        Files.writeString(scene, Files.readString(scene).replace("0.5 s", "0.7 s"));

        assertThat(runner.inputs().scene().get(0).sha256()).isEqualTo(before).isNotEqualTo(sha256(scene));
    }

    @Test
    void aRunByAProgramHasNoCommand() throws IOException {
        SceneFile file = new SceneFile(scene);
        Path out = directory.resolve("out");
        try (RunReport report = new RunReport(file, out, false)) {
            SceneResult result = new SceneRunner(file).listener(report).run();
            report.finish(result);
        }

        assertThat(provenance("out").has("command")).isFalse();
        assertThat(provenance("out").get("scene").get("settings_sha256").asString())
                .hasSize(64);
        assertThat(provenance("out").get("models").size()).isZero();
    }

    @Test
    void theCommandLineNamesTheVersionOfTheBuild() {
        assertThat(Program.run("--version").out().strip()).matches("(?s)dronewatch \\d+\\.\\d+\\.\\d+.*");
    }
}
