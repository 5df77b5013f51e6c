package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.GraphicsEnvironment;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.catalog.Positioners;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

class CommandLineTest {
    private static final JsonMapper JSON = JsonMapper.builder().build();
    private static final String TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

    @TempDir
    private Path directory;

    private record Outcome(int code, String out, String err) {}

    private Outcome command(String... arguments) {
        StringWriter out = new StringWriter();
        StringWriter err = new StringWriter();
        int code = Main.execute(new PrintWriter(out, true), new PrintWriter(err, true), arguments);
        return new Outcome(code, out.toString(), err.toString());
    }

    /** Runs a command line in which DIR stands for the test's directory. */
    private Outcome commandIn(String line) {
        return command(Stream.of(line.split("\\s+"))
                .filter(word -> !word.isEmpty())
                .map(word -> word.replace("DIR", directory.toString()))
                .toArray(String[]::new));
    }

    private Map<String, String> files() throws IOException {
        Map<String, String> files = new TreeMap<>();
        try (Stream<Path> all = Files.walk(directory)) {
            for (Path file : all.filter(Files::isRegularFile).toList()) {
                files.put(
                        directory.relativize(file).toString().replace('\\', '/'),
                        new String(Files.readAllBytes(file), java.nio.charset.StandardCharsets.ISO_8859_1));
            }
        }
        return files;
    }

    private void assertRefused(String line, String... parts) throws IOException {
        Map<String, String> before = files();
        Outcome outcome = commandIn(line);
        assertThat(outcome.code()).as(outcome.err()).isEqualTo(2);
        assertThat(outcome.out()).isEmpty();
        assertThat(outcome.err().strip())
                .isNotEmpty()
                .doesNotContain("Exception")
                .doesNotContain("\tat ");
        String last = outcome.err().strip().lines().reduce((a, b) -> b).orElseThrow();
        assertThat(last).contains(parts);
        // What was read well is noted before the mistake; the mistake itself takes one line.
        assertThat(outcome.err().strip().lines().filter(text -> !text.startsWith("read ")))
                .hasSize(1);
        assertThat(files()).isEqualTo(before);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "run no-such-scene                                        | no-such-scene | camera-range",
                "run java.lang.String                                     | java.lang.String | must extend",
                "run org.dronewatch.scene.Scene                           | org.dronewatch.scene.Scene | must extend",
                "run camera-range --set sensors.camera.width=0            | width 0 px    | 1 to 16384",
                "run camera-range --set sensors.camera.height=-1          | height -1 px  | 1 to 16384",
                "run camera-range --set world.models=a                    | world.models | is a list",
                "run camera-range --set sensors.camera.fov=60             | fov 3437.747 deg (60 rad) must be |"
                        + " 0.01 to 179 deg",
                "run camera-range --set sensors.camera.fov=0              | fov 0 deg   | 0.01 to 179 deg",
                "run camera-range --set sensors.camera.fov=180deg         | fov 180 deg   | 0.01 to 179 deg",
                "run camera-range --set sensors.camera.fov=3.141592653589793 | fov 180 deg | 0.01 to 179 deg",
                "run camera-range --set sensors.camera.rate=0             | rate 0 Hz   | above 0",
                "run camera-range --set drones.quadrotor.speed=-5         | speed -5 m/s | 0.001 to 400",
                "run camera-range --set drones.quadrotor.speed=NaN        | NaN           | number",
                "run camera-range --set run.duration=0                    | duration 0 s | above 0",
                "run camera-range --set sensors.camera                    | sensors.camera | PATH=VALUE",
                "run camera-range --set sensor.camera.fov=1               | 'sensor'      | sensors",
                "run camera-range --set world.models.0.file=DIR/none.obj  | none.obj      | does not exist",
                "run camera-range --set world.models.0.file=packaged:no.obj | no.obj      | no packaged model",
                "run camera-range --threads 0                             | 0             | 1 to 1024",
                "run camera-range --threads many                          | many          | --threads",
                "run camera-range --seed 1.5                              | 1.5           | --seed",
                "run camera-range --real-time -1                          | -1.0          | must be 0.001 to 1000000",
                "run camera-range --colour                                | --colour      | --help",
                "run                                                      | SCENE         | --help",
                "run acoustic-range --set world.surfaces.defaultSurface=brick_ruogh | 'brick_ruogh' | brick_rough",
                "run acoustic-range --set sensors.microphone.propagation.initialRays=0 | initialRays 0 | 1 to 100000",
                "run acoustic-range --set drones.quadrotor.sound=c1-quadcopter | 'c1-quadcopter' | c1-quadrotor",
                "run acoustic-range --set world.atmosphere.humidity=-5%   | humidity -0.05 | 0 to 1",
                "run acoustic-range --set sensors.microphone.propagation=loud | 'loud'     | energy-model",
                "run acoustic-range --set sensors.microphone.radius=0     | radius 0 m  | above 0",
                "check camera-range --set sensors.camera.fvo=4           | no 'fvo'      | did you mean 'fov'?",
                "check camera-range --set sensors.camra.fov=4            | no 'camra'    | did you mean 'camera'?",
                "check multi-sensor --set drones.quadrotor.flight.nearst=4 | no 'nearst' | did you mean 'standoff'?",
                "coverage camera-range --cells 1 --out DIR/a.png         | --cells 1: cells 1 | 2 to 2000",
                "coverage camera-range --side 0 --out DIR/a.png          | --side 0: side 0 m | above 0",
                "coverage camera-range --height low --out DIR/a.png      | --height low: 'low' | number",
                "check camera-range --set sensors.camera.fov=4            | fov 229.1831 deg | 0.01 to 179 deg",
                "render camera-range --camera eye --time 1 --out DIR/a.png | eye          | camera",
                "render camera-range --camera camera --time 40 --out DIR/a.png | 40        | 0 to 39",
                "render camera-range --camera camera --time soon --out DIR/a.png | soon    | number",
                "render camera-range --camera camera --time 1 --out DIR/a.gif | a.gif      | .png",
                "render camera-range --camera camera --time 1 --out DIR/no/a.png | no/a.png | no directory",
                "render camera-range --camera camera --time 1 --run 5 --out DIR/a.png | 5  | 0 to 4",
                "bench DIR/none.obj                                       | none.obj      | does not exist",
                "bench packaged:quadrotor.obj --passes 0                  | --passes 0    | 1 to 1000",
                "bench packaged:quadrotor.obj --traversal fast            | fast          | STACK",
                "bench packaged:quadrotor.obj --rays DIR/none.rays        | none.rays     | cannot be read",
                "bench packaged:quadrotor.obj --width 10                  | --width       | --rays",
                "bench packaged:quadrotor.obj --hits DIR/hits             | --hits        | --rays",
                "models --out DIR/no/such/place                           | no/such/place | ",
                "''                                                       | command       | run",
                "fly                                                      | fly           | --help",
                "rum camera-range                                         | unknown command 'rum' | did you"
                        + " mean 'run'?",
                "run camera-range --thread 2                              | unknown option '--thread' | did you"
                        + " mean '--threads'?",
                "run camera-range --sed=2                                 | unknown option '--sed' | did you"
                        + " mean '--se",
                "run camera-rnge                                          | unknown scene 'camera-rnge' | did"
                        + " you mean 'camera-range'?",
                "render camera-range --view orbitt --out DIR/a.png        | orbitt        | did you mean 'orbit'?",
                "bench packaged:quadrotor.obj --traversal stak            | stak          | did you mean 'stack'?",
            })
    void aMistakeIsOneLineAndLeavesNothing(String line, String value, String limit) throws IOException {
        assertRefused(
                line + (line.matches("run [a-z]+-range.*") ? " --out DIR/results" : ""),
                value,
                limit == null ? "" : limit);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "v 0 0 0;v 1 0 0;v 0 1 0;f 1 2 9     | bad.obj:4: | 9",
                "v 0 0 0;v 1 0 0;v 0 NaN 0;f 1 2 3   | bad.obj:3: | NaN",
                "v 0 0 0;v 1 0 0;v 0 1 0;f 1 2 3;f 1 | bad.obj:5: | 3",
                "v 0 0 0;v 1 0 0;v 0 1               | bad.obj:3: | 3",
                "v 0 0 0;v 1 0 0                     | bad.obj    | no faces",
                "''                                  | bad.obj    | no faces",
            })
    void aBadModelIsNamedWithItsLine(String text, String place, String what) throws IOException {
        Files.writeString(directory.resolve("bad.obj"), text.replace(';', '\n'));

        assertRefused("run camera-range --out DIR/results --set world.models.0.file=DIR/bad.obj", place, what);
        assertRefused("check camera-range --set drones.quadrotor.model.file=DIR/bad.obj", place, what);
        assertRefused("bench DIR/bad.obj", place, what);
    }

    @Test
    void outputThatCannotBeWrittenIsFoundBeforeTheWork() throws IOException {
        Files.writeString(directory.resolve("file"), "keep me");

        assertRefused("run camera-range --out DIR/file", "file", "is a file");
        assertRefused("run camera-range --out DIR/file/below", "file", "is a file");
        assertRefused("render camera-range --camera camera --time 1 --out DIR/file/a.png", "file", "no directory");
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 3, 10, 27, 29})
    void aRayFileOfTheWrongSizeIsRefused(int bytes) throws IOException {
        Files.writeString(directory.resolve("model.obj"), TRIANGLE + "f 1 2 3\n");
        byte[] file = new byte[bytes];
        if (bytes > 4) {
            file[0] = 1;
        }
        Files.write(directory.resolve("bad.rays"), file);

        assertRefused("bench DIR/model.obj --rays DIR/bad.rays --hits DIR/hits", "bad.rays");
    }

    @Test
    void aRayWithoutDirectionIsRefused() throws IOException {
        Files.writeString(directory.resolve("model.obj"), TRIANGLE + "f 1 2 3\n");
        Files.write(directory.resolve("bad.rays"), rays(new float[] {0, 0, 0, 0, 0, 0}));
        assertRefused("bench DIR/model.obj --rays DIR/bad.rays", "ray 0", "direction");
        Files.write(directory.resolve("bad.rays"), rays(new float[] {0, 0, Float.NaN, 0, 0, 1}));
        assertRefused("bench DIR/model.obj --rays DIR/bad.rays", "ray 0", "NaN");
    }

    private static byte[] rays(float[]... rays) {
        ByteBuffer buffer = ByteBuffer.allocate(4 + 24 * rays.length).order(ByteOrder.LITTLE_ENDIAN);
        buffer.putInt(rays.length);
        for (float[] ray : rays) {
            for (float value : ray) {
                buffer.putFloat(value);
            }
        }
        return buffer.array();
    }

    @Test
    void benchTracesTheRaysOfAFile() throws IOException {
        Files.writeString(directory.resolve("model.obj"), TRIANGLE + "v 1 1 1\nf 1 2 2\nf 1 2 3\n");
        Files.write(
                directory.resolve("my.rays"),
                rays(new float[] {0.2f, 0.2f, -2, 0, 0, 1}, new float[] {0.2f, 0.2f, -2, 0, 0, -1}));
        for (String traversal : List.of("stack", "sequential")) {
            Outcome outcome =
                    commandIn("bench DIR/model.obj --rays DIR/my.rays --hits DIR/my.hits --passes 2 --threads 2"
                            + " --traversal " + traversal);

            assertThat(outcome.code()).isZero();
            JsonNode line = JSON.readTree(outcome.out());
            assertThat(line.get("set").asString()).isEqualTo("file");
            assertThat(line.get("rays").asInt()).isEqualTo(2);
            assertThat(line.get("hits").asInt()).isEqualTo(1);
            assertThat(line.get("traversal").asString()).isEqualTo(traversal);
            assertThat(line.get("threads").asInt()).isEqualTo(2);
            assertThat(line.get("mrays_min").asDouble())
                    .isLessThanOrEqualTo(line.get("mrays").asDouble());
            assertThat(line.get("mrays").asDouble())
                    .isLessThanOrEqualTo(line.get("mrays_max").asDouble());
            assertThat(line.has("build_s")).isTrue();
            ByteBuffer hits = ByteBuffer.wrap(Files.readAllBytes(directory.resolve("my.hits")))
                    .order(ByteOrder.LITTLE_ENDIAN);
            // The triangle without area is dropped, but counts: the hit is the file's second triangle.
            assertThat(hits.getFloat()).isEqualTo(2.0f);
            assertThat(hits.getInt()).isEqualTo(1);
            assertThat(hits.getFloat()).isInfinite();
            assertThat(hits.getInt()).isEqualTo(-1);
            assertThat(hits.hasRemaining()).isFalse();
        }
    }

    @Test
    void benchMakesCameraAndDiffuseRaysItself() {
        Outcome outcome = commandIn("bench packaged:house.obj --passes 1");

        assertThat(outcome.code()).isZero();
        assertThat(outcome.out().lines()).hasSize(2);
        assertThat(outcome.out()
                        .lines()
                        .map(line -> JSON.readTree(line).get("set").asString()))
                .containsExactly("camera", "diffuse");
    }

    @Test
    void everyCommandHasHelpWithAnExample() {
        for (String name : List.of("run", "check", "render", "bench", "list", "models", "schema")) {
            Outcome outcome = command(name, "--help");
            assertThat(outcome.code()).isZero();
            assertThat(outcome.out()).contains("Usage:").contains(name);
            if (!name.equals("list")) {
                assertThat(outcome.out()).contains("Example");
            }
        }
        assertThat(command("--help").out()).contains("Example");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--heard-only      | --heard-only: has no effect without --rays",
                "--max-order=2     | --max-order 2: has no effect without --rays",
                "--cut=-5000m      | --cut -5000m: must be above the site's lowest point, ",
            })
    void optionsOfAPictureThatWouldShowNothingAreRefused(String option, String message) {
        Outcome outcome = command(
                "render",
                "camera-range",
                "--view",
                "top",
                option,
                "--out",
                directory.resolve("no.png").toString());

        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.err().lines().reduce((first, last) -> last).orElse(""))
                .contains(message);
        assertThat(directory.resolve("no.png")).doesNotExist();
    }

    @Test
    void listTellsEachSceneInALine() {
        assertThat(command("list").out().lines().map(line -> line.split("\\s+")[1]))
                .startsWith("closed-space", "camera-range", "acoustic-range", "multi-sensor")
                .containsSubsequence(Catalog.packagedNames())
                .endsWith(Positioners.packagedNames().toArray(String[]::new));
    }

    @Test
    void checkRunsNothing() throws IOException {
        Outcome outcome = command("check", "camera-range");

        assertThat(outcome.code()).isZero();
        assertThat(outcome.out().strip())
                .matches("camera-range is valid: 1 model, 1 drone, 1 sensor, 5 runs of [0-9.]+ s");
        assertThat(files()).isEmpty();
    }

    @Test
    void checkCountsSensorsThatAreSwitchedOff() {
        Outcome outcome = command("check", "multi-sensor", "--set", "sensors.north-east-1.enabled=false");

        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.out()).contains(" drone, 13 sensors (1 switched off), ");
    }

    @Test
    void runWarnsThatThereAreNoRaysToWrite() throws IOException {
        String run = "run multi-sensor --set run.duration=1 --out DIR/out --rays DIR/rays.obj";
        assertThat(commandIn(run).err()).containsPattern("[1-9][0-9,]* ray segments written");

        Outcome outcome = commandIn(run + " --set sensors.microphone.enabled=false");
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.err())
                .containsOnlyOnce("warning: --rays ")
                .contains("rays.obj: the file contains no rays: the scene has no drone, or no acoustic sensor"
                        + " that is switched on")
                .doesNotContain("pieces");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "list",
                "run",
                "check",
                "save",
                "schema",
                "view",
                "render",
                "coverage",
                "bench",
                "costs",
                "models"
            })
    void helpBreaksNoNameOrValueInTwo(String name) {
        String help = commandIn(name + " --help").out();

        // A row of the table of commands may begin with a small letter.
        assertThat(help).doesNotContainPattern("\\S\\.\\R(?! *\\w+ {2}) *[a-z]");
        if (help.contains("Example")) {
            String examples = help.substring(help.indexOf("Example"));
            assertThat(examples.lines().skip(1)).allMatch(line -> line.startsWith("  dronewatch "));
        }
    }

    @Test
    void renderDrawsThePictureOfACamera() throws IOException {
        Outcome outcome = commandIn("render camera-range --camera camera --time 35 --out DIR/view.png"
                + " --set sensors.camera.width=480 --set sensors.camera.height=270");
        assertThat(outcome.code()).as(outcome.err()).isZero();
        BufferedImage image = ImageIO.read(directory.resolve("view.png").toFile());
        assertThat(image.getWidth()).isEqualTo(480);
        assertThat(image.getHeight()).isEqualTo(270);

        commandIn("render camera-range --camera camera --time 35 --out DIR/view.pfm"
                + " --set sensors.camera.width=480 --set sensors.camera.height=270");
        assertThat(Files.size(directory.resolve("view.pfm")))
                .isEqualTo("Pf\n480 270\n-1.0\n".length() + 4L * 480 * 270);
        assertThat(files()).containsOnlyKeys("view.png", "view.pfm");
    }

    /** The same files for the same seed, whatever the number of threads, but for what depends on the clock. */
    @Test
    void aRunWritesTheSameFilesForAnyNumberOfThreads() throws IOException {
        String scene = "run camera-range --observations --set sensors.camera.width=480 --set sensors.camera.height=270"
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
        Outcome outcome = commandIn("run camera-range --out DIR/results --set sensors.camera.fov=0.6 --seed 9");
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

    @Test
    void theRaysOfARunAreLinesThatAModelProgramReads() throws IOException {
        Outcome outcome = commandIn("run closed-space --out DIR/results --rays DIR/rays.obj");
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
        Outcome outcome = commandIn("run DIR/site.yaml --out DIR/results");
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(files().get("results/map.geojson")).contains("eye detects one", "50.08");
        assertThat(files().get("results/map.kml")).contains("eye detects one", "14.42,50.08,2");

        Files.writeString(file, scene.replace("ORIGIN", ""));
        assertThat(commandIn("run DIR/site.yaml --out DIR/results").code()).isZero();
        assertThat(files())
                .containsKey("results/summary.json")
                .doesNotContainKeys("results/map.geojson", "results/map.kml");
    }

    @Test
    void modelsAreWrittenAsTheyAreShipped() throws IOException {
        Outcome outcome = commandIn("models --out DIR");

        assertThat(outcome.code()).as(outcome.err()).isZero();
        for (Map.Entry<String, String> file : files().entrySet()) {
            assertThat(file.getValue().getBytes(java.nio.charset.StandardCharsets.ISO_8859_1))
                    .isEqualTo(Files.readAllBytes(Path.of("models", file.getKey())));
        }
        assertThat(files()).containsKeys("hill.obj", "quadrotor.obj", "house.obj", "house.mtl");
    }

    @ParameterizedTest
    @ValueSource(strings = {"view multi-sensor", "run multi-sensor --view --out DIR/results"})
    void withoutADisplayAWindowIsRefusedInOneLine(String line) throws IOException {
        assumeTrue(GraphicsEnvironment.isHeadless());
        Outcome outcome = commandIn(line);

        assertThat(outcome.code()).isEqualTo(3);
        assertThat(outcome.out()).isEmpty();
        assertThat(outcome.err().lines()).hasSize(1);
        assertThat(outcome.err())
                .startsWith("cannot open a window: there is no display")
                .contains("'render'");
        assertThat(files()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"top", "side", "orbit"})
    void rendersTheSite(String view) throws IOException {
        Outcome outcome =
                commandIn("render closed-space --rays --max-order 1 --size 320x200 --out DIR/site.png --view " + view);

        assertThat(outcome.code()).isZero();
        assertThat(outcome.out()).contains("320 x 200 pixels");
        BufferedImage image = ImageIO.read(directory.resolve("site.png").toFile());
        assertThat(image.getWidth()).isEqualTo(320);
        assertThat(image.getHeight()).isEqualTo(200);
        assertThat(java.util.Arrays.stream(image.getRGB(0, 0, 320, 200, null, 0, 320))
                        .distinct())
                .hasSizeGreaterThan(1000);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--view orbit --camera camera | mutually exclusive",
                "--time 1 | --view",
                "--view below | below",
                "--view top --size 10x10 | --size 10x10: must be like 1280x800",
                "--view top --size wide | --size wide: must be like 1280x800",
                "--view top --size 9000x9000 | from 64 to 8192",
                "--view top --scale 0 | --scale 0.0: must be 0.5 to 8",
                "--view top --focus nobody | --focus nobody: no such sensor or drone; the scene has camera, quadrotor",
                "--view orbit --bearing north | --bearing north",
                "--view orbit --cut roof | --cut roof",
                "--view orbit --max-order -1 --rays | --max-order -1",
                "--view orbit --rays | no sensor of the scene traces rays",
                "--view orbit --time 99 | --time 99: must be 0 to 39",
            })
    void aPictureThatCannotBeIsRefusedInOneLine(String options, String said) throws IOException {
        Outcome outcome = commandIn("render camera-range --out DIR/site.png " + options);

        assertThat(outcome.code()).as(outcome.err()).isEqualTo(2);
        assertThat(outcome.err()).contains(said);
        assertThat(outcome.err().lines().filter(line -> !line.startsWith("read ")))
                .hasSize(1);
        assertThat(files()).isEmpty();
    }
}
