package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.networknt.schema.InputFormat;
import com.networknt.schema.Schema;
import com.networknt.schema.SchemaRegistry;
import com.networknt.schema.SpecificationVersion;
import java.io.File;
import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import javax.tools.ToolProvider;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Aimed;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.SettingsForm;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** A project of somebody else, whose jar adds one of each that can be added, and which the program has never seen. */
class ForeignProjectTest {
    private static final Path PROJECT = ForeignProject.DIRECTORY;

    @TempDir
    private static Path built;

    private static Path jar;

    @TempDir
    private Path directory;

    @BeforeAll
    static void buildTheJar() throws IOException {
        jar = ForeignProject.jar(built);
    }

    private Program.Outcome run(List<Path> jars, String... arguments) throws IOException, InterruptedException {
        try (Program.Child child = Program.startWith(directory, jars, List.of("-Xmx512m"), arguments)) {
            return child.await();
        }
    }

    private void copyTheScene() throws IOException {
        ForeignProject.copyScene(directory);
    }

    @Test
    void itsKindsAreListedWithTheirJar() throws IOException, InterruptedException {
        Program.Outcome outcome = run(List.of(jar), "list", "--kinds");
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.out().lines())
                .contains(
                        "sensor              camera              sees drones in daylight, by the pixels that they cover; built in",
                        "sensor              spotter             someone with binoculars; " + jar,
                        "flight path         zigzag              southward, swaying; " + jar,
                        "propagation         spherical           spreading alone; " + jar,
                        "detection function  any-pixel           one pixel is enough; " + jar,
                        "model file          .off                Object File Format; " + jar);
    }

    @Test
    void aSceneOfItsKindsRunsAndIsReported() throws IOException, InterruptedException {
        copyTheScene();
        Program.Outcome outcome = run(List.of(jar), "run", "scene.yaml", "--observations", "--out", "out");
        assertThat(outcome.code()).as(outcome.err()).isZero();
        Path out = directory.resolve("out");
        assertThat(Files.readString(out.resolve("report.html"))).contains("spotter", "spherical", "any-pixel");

        List<String> rows = Files.readAllLines(out.resolve("observations.csv"));
        List<String> names = Arrays.asList(rows.get(0).split(","));
        assertTheSpotterSeesAsFarAsItReaches(rows, names);
        assertTheEarHearsSphericalSpreading(rows, names);
        assertThat(rows.stream().filter(row -> row.contains(",camera,")))
                .isNotEmpty()
                .allMatch(row -> number(row, names, "threshold") == 1.0);
    }

    private static double number(String row, List<String> names, String column) {
        return Double.parseDouble(row.split(",")[names.indexOf(column)]);
    }

    private static void assertTheSpotterSeesAsFarAsItReaches(List<String> rows, List<String> names) {
        List<String> looks =
                rows.stream().filter(row -> row.contains(",spotter,")).toList();
        assertThat(looks).hasSizeGreaterThanOrEqualTo(60);
        assertThat(looks).allSatisfy(row -> {
            double time = number(row, names, "time_s");
            double range = Math.sqrt(
                    Math.pow(3.0 * Math.sin(time), 2) + Math.pow(190.0 - 5.0 * time, 2) + Math.pow(20.0 - 2.0, 2));
            assertThat(number(row, names, "range_m")).isCloseTo(range, within(1e-3));
            assertThat(number(row, names, "value")).isCloseTo(120.0 / range, within(1e-4));
        });
        assertThat(looks).anyMatch(row -> number(row, names, "value") < 1.0);
        assertThat(looks).anyMatch(row -> number(row, names, "value") > 1.0);
    }

    private static void assertTheEarHearsSphericalSpreading(List<String> rows, List<String> names) {
        List<String> looks =
                rows.stream().filter(row -> row.contains(",acoustic,")).toList();
        assertThat(looks).hasSizeGreaterThanOrEqualTo(300);
        double atOneMetre =
                number(looks.get(0), names, "value") + 20.0 * Math.log10(number(looks.get(0), names, "range_m"));
        assertThat(looks).allSatisfy(row -> assertThat(
                        number(row, names, "value") + 20.0 * Math.log10(number(row, names, "range_m")))
                .isCloseTo(atOneMetre, within(1e-3)));
    }

    /** A drone whose mesh and flight come from the other jar and whose sound is its own, beside one of the library. */
    @Test
    void aDroneOfForeignPartsFliesBesideAPackagedOne() throws IOException, InterruptedException {
        copyTheScene();
        Files.writeString(directory.resolve("kite.off"), "OFF\n3 1 0\n-1 0 0\n1 0 0\n0 0 1.5\n3 0 1 2\n");
        Files.writeString(
                directory.resolve("kite.yaml"),
                """
                world: {models: [wall.off]}
                drones:
                  kite:
                    model: {file: kite.off, upAxis: z}
                    flight: {kind: zigzag, from: [0, 190, 20], sway: 3 m}
                    speed: 5 m/s
                    sound: kite-motor
                    spectrum: [0, 0, 0, 0, 10, 0, 0, 0]
                    soundPowerLevel: 80 dB
                  quadrotor:
                    model: packaged:quadrotor.obj
                    flight: {kind: approach, from: [5, 190, 20], to: [5, 40, 20]}
                    speed: 5 m/s
                sensors:
                  ear: {kind: acoustic, position: [0, 0, 2], propagation: energy-model, rate: 1 Hz}
                  camera: {kind: camera, position: [0, 0, 2], aim: {lookAt: [0, 190, 20]}, rate: 1 Hz}
                run: {duration: 20 s}
                """);

        Program.Outcome outcome = run(List.of(jar), "run", "kite.yaml", "--observations", "--out", "kites");

        assertThat(outcome.code()).as(outcome.err()).isZero();
        List<String> rows = Files.readAllLines(directory.resolve("kites/observations.csv"));
        List<String> names = Arrays.asList(rows.get(0).split(","));
        for (String drone : List.of("kite", "quadrotor")) {
            for (String sensor : List.of("ear", "camera")) {
                assertThat(rows.stream()
                                .filter(row -> row.contains("," + sensor + ",") && row.contains("," + drone + ",")))
                        .as("%s of %s", sensor, drone)
                        .hasSizeGreaterThan(15)
                        .anyMatch(row -> number(row, names, "value") > 0.0);
            }
        }
    }

    @Test
    void aSensorIsSwappedForItsKindByOneSetting() throws IOException, InterruptedException {
        copyTheScene();
        Program.Outcome outcome =
                run(List.of(jar), "run", "scene.yaml", "--set", "sensors.camera=spotter", "--out", "out");
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(Files.readString(directory.resolve("out/detections.csv"))).contains(",camera,spotter,");
    }

    @Test
    void aSavedSceneHasItsKindsAndTheSameDetections() throws IOException, InterruptedException {
        copyTheScene();
        String[] swap = {"--set", "sensors.camera=spotter", "--set", "sensors.camera.reach=70 m"};
        Program.Outcome outcome =
                run(List.of(jar), "save", "scene.yaml", swap[0], swap[1], swap[2], swap[3], "--out", "saved.yaml");
        assertThat(outcome.code()).as(outcome.err()).isZero();
        run(List.of(jar), "run", "scene.yaml", swap[0], swap[1], swap[2], swap[3], "--out", "direct");
        outcome = run(List.of(jar), "run", "saved.yaml", "--out", "again");
        assertThat(outcome.code()).as(outcome.err()).isZero();
        String detections = Files.readString(directory.resolve("again/detections.csv"));
        assertThat(detections)
                .contains(",camera,spotter,")
                .isEqualTo(Files.readString(directory.resolve("direct/detections.csv")));
    }

    @Test
    void anEditorKnowsItsKinds() throws IOException, InterruptedException {
        String scene = Files.readString(PROJECT.resolve("scene.yaml"));
        Schema without = schema(run(List.of(), "schema"));
        assertThat(without.validate(scene, InputFormat.YAML)).isNotEmpty();

        Schema with = schema(run(List.of(jar), "schema"));
        assertThat(with.validate(scene, InputFormat.YAML)).isEmpty();
        for (String part : List.of("kind: spotter", "propagation: spherical", "kind: zigzag", "any-pixel")) {
            assertThat(scene).contains(part);
            assertThat(with.validate(scene.replace(part, part + "s"), InputFormat.YAML))
                    .isNotEmpty();
        }
        assertThat(with.validate(scene.replace("reach: 120 m", "reach: 6000"), InputFormat.YAML))
                .isNotEmpty();
        assertThat(with.validate(scene.replace("reach: 120 m", "raech: 120 m"), InputFormat.YAML))
                .isNotEmpty();
    }

    private static Schema schema(Program.Outcome outcome) {
        assertThat(outcome.code()).as(outcome.err()).isZero();
        return SchemaRegistry.withDefaultDialect(SpecificationVersion.DRAFT_2020_12)
                .getSchema(outcome.out(), InputFormat.JSON);
    }

    @Test
    void theSchemaSaysOfItsSettingsWhatItKnows() throws IOException, InterruptedException {
        JsonNode sensors = JsonMapper.builder()
                .build()
                .readTree(run(List.of(jar), "schema").out())
                .at("/$defs/SensorSettings/anyOf");
        JsonNode spotter = sensors.valueStream()
                .filter(kind -> kind.at("/properties/kind/const").asString("").equals("spotter"))
                .findFirst()
                .orElseThrow();
        assertThat(spotter.get("description").asString()).isEqualTo("someone with binoculars");
        assertThat(spotter.at("/required").toString()).isEqualTo("[\"position\"]");
        JsonNode reach = spotter.at("/properties/reach");
        assertThat(reach.get("description").asString()).isEqualTo("in m, or with a unit");
        assertThat(reach.get("exclusiveMinimum").asDouble()).isZero();
        assertThat(reach.get("maximum").asDouble()).isEqualTo(5000.0);
        assertThat(reach.get("default").asDouble()).isEqualTo(150.0);
        assertThat(spotter.at("/properties/enabled/type").asString()).isEqualTo("boolean");
    }

    /** A jar with one kind of flight that is called odd, whose settings have some more components. */
    private Path oddFlight(String defaults, String... components) throws IOException {
        String source = String.join(
                "\n",
                "package org.example.odd;",
                "import java.util.List;",
                "import org.dronewatch.flight.*;",
                "import org.dronewatch.setting.*;",
                "import org.dronewatch.world.Ground;",
                "public final class Odd implements KindGroup {",
                "    public record Branch(double length, List<Branch> branches) {}",
                "    public record Flight(double sway, " + String.join(", ", components)
                        + ") implements FlightPathSettings {",
                "        " + defaults,
                "        public FlightPath create(double speed, double acceleration, Ground ground) { return null; }",
                "    }",
                "    public List<Kind<?>> kinds() {",
                "        return List.of(Kind.of(FlightPathSettings.class, \"odd\", Flight.class, \"odd\"));",
                "    }",
                "}");
        Path classes = Files.createDirectories(directory.resolve("odd"));
        Path services = Files.createDirectories(classes.resolve("META-INF/services"));
        Files.writeString(services.resolve("org.dronewatch.setting.KindGroup"), "org.example.odd.Odd\n");
        Path file = Files.writeString(directory.resolve("Odd.java"), source);
        String[] options = {"-d", classes.toString(), "-cp", System.getProperty("java.class.path"), file.toString()};
        assertThat(ToolProvider.getSystemJavaCompiler().run(null, null, null, options))
                .isZero();
        Path odd = directory.resolve("odd.jar");
        ForeignProject.write(odd, List.of(classes));
        return odd;
    }

    @Test
    void whatOnlyJavaCanSetIsNotInTheSchema() throws IOException, InterruptedException {
        Path odd = oddFlight(
                "@Defaults({\"sway\", \"branches\"}) public static Flight of(double sway, List<Branch> branches) {"
                        + " return new Flight(sway, new int[0], branches); }",
                "int[] turns",
                "List<Branch> branches");
        Program.Outcome outcome = run(List.of(odd), "schema");
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.out())
                .contains("\"const\" : \"odd\"", "\"org.example.odd.Odd.Branch\" :")
                .doesNotContain("\"turns\"");
    }

    @Test
    void aKindThatRequiresWhatNoFileCanGiveIsRefusedInOneLine() throws IOException, InterruptedException {
        Path odd = oddFlight("", "int[] turns");
        Program.Outcome outcome = run(List.of(odd), "schema");
        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.out()).isEmpty();
        assertThat(outcome.complaints())
                .containsExactly("kind 'odd' from " + odd
                        + ": its settings cannot be described: no file can give its setting 'turns' of type int[]");
    }

    @Test
    void aKindWhoseDefaultsDoNotFitIsRefusedInOneLine() throws IOException, InterruptedException {
        Path odd = oddFlight(
                "@Defaults(\"swya\") public static Flight of(double sway) { return new Flight(sway, 1); }",
                "double turns");
        Program.Outcome outcome = run(List.of(odd), "schema");
        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.complaints())
                .containsExactly(
                        "kind 'odd' from " + odd + ": its @Defaults name swya, but its settings are sway, turns");
    }

    @Test
    void itsLimitsHoldInFiles() throws IOException, InterruptedException {
        copyTheScene();
        Program.Outcome outcome = run(List.of(jar), "check", "scene.yaml", "--set", "sensors.eyes.reach=6 km");
        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.complaints())
                .singleElement()
                .asString()
                .contains("reach 6000 m must be above 0 and at most 5000");
    }

    @Test
    void withoutItsJarTheKindIsUnknownAndNoClassIsTaken() throws IOException, InterruptedException {
        copyTheScene();
        String scene = Files.readString(directory.resolve("scene.yaml"));
        Program.Outcome outcome = run(List.of(), "check", "scene.yaml");
        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.err()).contains("unknown kind 'spotter'").doesNotContain("\tat ");
        Files.writeString(
                directory.resolve("scene.yaml"), scene.replace("spotter", "org.example.watch.SpotterSettings"));
        outcome = run(List.of(jar), "check", "scene.yaml");
        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.err()).contains("unknown kind 'org.example.watch.SpotterSettings'");
    }

    @Test
    void twoJarsWithTheSameKindAreRefusedInOneLineThatNamesBoth() throws IOException, InterruptedException {
        // The same classes once more, but for a provider of its own.
        Path other = directory.resolve("other.jar");
        Path services = Files.createDirectories(directory.resolve("more/META-INF/services"));
        Files.writeString(services.resolve("org.dronewatch.setting.Kind"), "org.example.again.SpotterAgain\n");
        Path source = directory.resolve("SpotterAgain.java");
        Files.writeString(
                source,
                Files.readString(PROJECT.resolve("src/main/java/org/example/watch/SpotterKind.java"))
                        .replace(
                                "package org.example.watch;", "package org.example.again;\nimport org.example.watch.*;")
                        .replace("class SpotterKind", "class SpotterAgain"));
        String classPath = System.getProperty("java.class.path") + File.pathSeparator + jar;
        int failed = ToolProvider.getSystemJavaCompiler()
                .run(null, null, null, "-d", directory.resolve("more").toString(), "-cp", classPath, source.toString());
        assertThat(failed).isZero();
        ForeignProject.write(other, List.of(directory.resolve("more")));

        Program.Outcome outcome = run(List.of(jar, other), "list");
        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.out()).isEmpty();
        assertThat(outcome.complaints())
                .singleElement()
                .asString()
                .contains("kind 'spotter' of SensorSettings is in", jar.toString(), other.toString());
    }

    @Test
    void itsSensorMovesToAnotherPositionWithAllElseAsItWas() throws IOException, ClassNotFoundException {
        try (URLClassLoader loader = new URLClassLoader(new URL[] {jar.toUri().toURL()})) {
            SettingsForm spotter = SettingsForm.of(loader.loadClass("org.example.watch.SpotterSettings"));
            Position there = new Position(7, 8, 9);
            SensorSettings<?> settings =
                    (SensorSettings<?>) spotter.create(Map.of("position", new Position(1, 2, 3), "reach", 90.0));

            assertThat(settings.withPosition(there))
                    .isEqualTo(spotter.create(Map.of("position", there, "reach", 90.0)));
            assertThat(settings.as(Aimed.class)).isEmpty();
        }
    }
}
