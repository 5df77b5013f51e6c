package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.dronewatch.Thorough;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** What a run writes, and what it leaves alone. */
class RunFilesTest extends CommandLines {
    private static final JsonMapper JSON = JsonMapper.builder().build();
    private static final String TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

    /** The same files for the same seed, whatever the number of threads, but for what depends on the clock. */
    @Test
    void aRunWritesTheSameFilesForAnyNumberOfThreads() throws IOException {
        String scene = "run camera-range --observations --set sensors.camera.width=320 --set sensors.camera.height=180"
                + " --seed 5 --out DIR/";
        assertThat(commandIn(scene + "one --threads 1").code()).isZero();
        assertThat(commandIn(scene + "two --threads 2").code()).isZero();
        assertThat(commandIn(scene + "again --threads 2").code()).isZero();

        Map<String, String> files = files();
        List<String> names = files.keySet().stream()
                .filter(name -> name.startsWith("one/"))
                .map(name -> name.substring(4))
                .toList();
        assertThat(names)
                .contains(
                        "detections.csv",
                        "observations.csv",
                        "summary.json",
                        "result.json",
                        "provenance.json",
                        "plots/range-over-sensors-camera-fov.png");
        assertThat(files).hasSize(3 * names.size());
        for (String name : names) {
            // These say when and how the run was made; ProvenanceTest looks at them.
            if (!List.of("provenance.json", "summary.json", "report.html").contains(name)) {
                assertThat(files.get("two/" + name)).as(name).isEqualTo(files.get("one/" + name));
                assertThat(files.get("again/" + name)).as(name).isEqualTo(files.get("one/" + name));
            }
        }
    }

    @Test
    void theFilesOfARunAreWhatScriptsRelyOn() throws IOException {
        Program.Outcome outcome = commandIn("run camera-range --out DIR/results --set sensors.camera.fov=0.6 --seed 9");
        assertThat(outcome.code()).as(outcome.err()).isZero();

        JsonNode summary = JSON.readTree(Files.readString(directory.resolve("results/summary.json")));
        for (String key : List.of("scene", "seed", "threads", "simulated_s", "load_s", "build_s", "wall_s")) {
            assertThat(summary.has(key)).as(key).isTrue();
        }
        assertThat(summary.get("scene").asString()).isEqualTo("camera-range");
        assertThat(summary.get("seed").asLong()).isEqualTo(9);
        assertThat(summary.get("simulated_s").asDouble()).isEqualTo(39.0);
        assertThat(summary.get("real_time_factor").asDouble()).isPositive();
        assertThat(summary.get("complete").asBoolean()).isTrue();
        assertThat(summary.has("sweep")).isFalse();
        JsonNode pair = summary.get("pairs").get(0);
        assertThat(pair.get("sensor").asString()).isEqualTo("camera");
        assertThat(pair.get("kind").asString()).isEqualTo("camera");
        assertThat(pair.get("drone").asString()).isEqualTo("quadrotor");
        assertThat(pair.get("range_m").asDouble()).isBetween(50.0, 200.0);
        assertThat(pair.get("max_range_m").asDouble())
                .isGreaterThanOrEqualTo(pair.get("range_m").asDouble());

        List<String> rows = Files.readAllLines(directory.resolve("results/detections.csv"));
        assertThat(rows.get(0)).isEqualTo("run,time_s,event,sensor,kind,drone,range_m,value,threshold,unit,heard_s");
        assertThat(rows.get(1))
                .startsWith("0,")
                .contains(",gained,camera,camera,quadrotor,")
                .containsPattern(",12,px,[0-9.]+$");
    }

    @Thorough
    @Test
    void theRaysOfARunAreLinesThatAModelProgramReads() throws IOException {
        Program.Outcome outcome = commandIn("run closed-space --out DIR/results --rays DIR/rays.obj");
        assertThat(outcome.code()).as(outcome.err()).isZero();

        List<String> lines = Files.readAllLines(directory.resolve("rays.obj"));
        long pieces = lines.stream().filter(line -> line.startsWith("l ")).count();
        assertThat(pieces).isGreaterThan(1000);
        assertThat(lines.stream().filter(line -> line.startsWith("v "))).hasSize((int) (2 * pieces));
        assertThat(lines).contains("g microphone_quadrotor_order_0_received");
        // The first ray leads from the drone, 5 m east and 5 m up, to the microphone.
        assertThat(lines).contains("v 5.0000 5.0000 0.0000", "v -5.0000 5.0000 0.0000");
        assertThat(outcome.err().lines().filter(line -> line.startsWith("read cathedral")))
                .as("models are read once")
                .hasSize(1);
    }

    @Test
    void aRunKeepsTheOtherFilesOfItsDirectory() throws IOException {
        Path results = Files.createDirectory(directory.resolve("results"));
        Files.writeString(results.resolve("notes.txt"), "mine");
        Files.writeString(results.resolve("observations.csv"), "of an older run");

        commandIn("run camera-range --out DIR/results --set sensors.camera.fov=1 --set run.duration=1");

        assertThat(files()).containsEntry("results/notes.txt", "mine");
        assertThat(files()).containsKey("results/summary.json").doesNotContainKey("results/observations.csv");
    }

    @Test
    void onlyASceneWithAnOriginHasMaps() throws IOException {
        String scene =
                """
                world: {models: [{file: site.obj, upAxis: z}]ORIGIN}
                drones: {one: {model: packaged:quadrotor.obj, flight: {kind: hover, position: [0, 40, 10]}}}
                sensors: {eye: {kind: camera, position: [0, 0, 2], aim: {lookAt: [0, 40, 10]}}}
                run: {duration: 0.5 s}
                """;
        Files.writeString(directory.resolve("site.obj"), TRIANGLE + "f 1 2 3\n");
        Path file = directory.resolve("site.yaml");
        Files.writeString(file, scene.replace("ORIGIN", ", origin: {latitude: 50.08 deg, longitude: 14.42 deg}"));
        Program.Outcome outcome = commandIn("run DIR/site.yaml --out DIR/results");
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(files().get("results/map.geojson")).contains("eye detects one", "50.08");
        assertThat(files().get("results/map.kml")).contains("eye detects one", "14.42,50.08,2");

        Files.writeString(file, scene.replace("ORIGIN", ""));
        assertThat(commandIn("run DIR/site.yaml --out DIR/results").code()).isZero();
        assertThat(files())
                .containsKey("results/summary.json")
                .doesNotContainKeys("results/map.geojson", "results/map.kml");
    }
}
