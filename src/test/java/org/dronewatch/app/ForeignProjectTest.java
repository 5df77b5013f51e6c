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
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Aimed;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.SettingsForm;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** A project of somebody else, whose jar adds one of each that can be added, and which the program has never seen. */
class ForeignProjectTest {
    private static final Path PROJECT = ForeignProject.DIRECTORY;
    private static final List<String> OPTIONS = List.of("-Xmx512m", "-XX:+UseSerialGC");

    @TempDir
    private static Path built;

    private static Path jar;

    /** Most commands are executed there: it is started once. */
    private static CommandProcess withJar;

    @TempDir
    private Path directory;

    @BeforeAll
    static void buildTheJar() throws IOException {
        jar = ForeignProject.jar(built);
        withJar = CommandProcess.start(built, List.of(jar), OPTIONS);
    }

    @AfterAll
    static void endTheProcess() {
        withJar.close();
    }

    private String at(String name) {
        return directory.resolve(name).toString();
    }

    /** Runs a command in a process of its own. */
    private Program.Outcome run(List<Path> jars, String... arguments) throws IOException, InterruptedException {
        try (Program.Child child = Program.startWith(directory, jars, OPTIONS, arguments)) {
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
                        "sound emission      hum                 louder the faster it flies; " + jar,
                        "propagation         spherical           spreading alone; " + jar,
                        "detection function  any-pixel           one pixel is enough; " + jar,
                        "model file          .off                Object File Format; " + jar);
    }

    @Thorough
    @Test
    void aSceneOfItsKindsRunsAndIsReported() throws IOException {
        copyTheScene();
        Program.Outcome outcome = withJar.run("run", at("scene.yaml"), "--observations", "--out", at("out"));
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

    /** Of a drone of 55 dB that hums louder by 1 dB for each metre per second above 5. */
    private static void assertTheEarHearsSphericalSpreading(List<String> rows, List<String> names) {
        List<String> looks =
                rows.stream().filter(row -> row.contains(",acoustic,")).toList();
        assertThat(looks).hasSizeGreaterThanOrEqualTo(300);
        assertThat(looks).allSatisfy(row -> assertThat(
                        number(row, names, "value") + 20.0 * Math.log10(number(row, names, "range_m")))
                .isCloseTo(50.0 + Math.hypot(5.0, 3.0 * Math.cos(number(row, names, "time_s"))), within(1e-3)));
    }

    /**
     * A drone whose mesh, flight and sound come from the other jar, beside one of the library: where it is, what it
     * looks like and what it sounds like follow from its kinds' closed forms.
     */
    @Thorough
    @Test
    void aDroneOfForeignPartsFliesBesideAPackagedOne() throws IOException {
        Files.writeString(directory.resolve("kite.off"), "OFF\n3 1 0\n-1 0 0\n1 0 0\n0 0 1.5\n3 0 1 2\n");
        Files.writeString(
                directory.resolve("far.off"), "OFF\n3 1 0\n30000 0 30000\n30001 0 30000\n30000 0 30002\n3 0 1 2\n");
        Files.writeString(
                directory.resolve("kite.yaml"),
                """
                world: {models: [{file: far.off, upAxis: z}]}
                drones:
                  kite:
                    model: {file: kite.off, upAxis: z}
                    flight: {kind: zigzag, from: [0, 190, 20], sway: 3 m}
                    speed: 5 m/s
                    emission: {kind: hum, perSpeed: 3 dB}
                    soundPowerLevel: 80 dB
                  quadrotor:
                    model: packaged:quadrotor.obj
                    flight: {kind: approach, from: [5, 190, 20], to: [5, 40, 20]}
                    speed: 5 m/s
                sensors:
                  ear: {kind: acoustic, position: [0, 0, 2], propagation: energy-model, rate: 1 Hz}
                  camera:
                    kind: camera
                    position: [0, 0, 2]
                    aim: {lookAt: [0, 190, 20]}
                    width: 960
                    height: 540
                    fov: 40 deg
                    fovAxis: horizontal
                    rate: 1 Hz
                run: {duration: 20 s}
                """);

        Program.Outcome outcome = withJar.run("run", at("kite.yaml"), "--observations", "--out", at("kites"));

        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(Files.readString(directory.resolve("kites/report.html"))).contains("emission hum");
        List<String> rows = Files.readAllLines(directory.resolve("kites/observations.csv"));
        List<String> names = Arrays.asList(rows.get(0).split(","));
        assertThat(rows.stream().filter(row -> row.contains(",kite,")))
                .hasSizeGreaterThan(38)
                .allSatisfy(row -> assertThat(number(row, names, "range_m"))
                        .isCloseTo(new Position(0, 0, 2).distance(zigzag(number(row, names, "time_s"))), within(1e-3)));
        assertThat(rows.stream().filter(row -> row.contains(",camera,camera,kite,")))
                .hasSize(21)
                .allSatisfy(row -> assertPixels(zigzag(number(row, names, "time_s")), number(row, names, "value")));
        assertThat(rows.stream().filter(row -> row.contains(",ear,acoustic,kite,")))
                .hasSizeGreaterThan(18)
                .allSatisfy(row -> assertThat(number(row, names, "value"))
                        .isCloseTo(hum(number(row, names, "time_s"), number(row, names, "range_m")), within(0.02)));
        for (String sensor : List.of("ear", "camera")) {
            assertThat(rows.stream().filter(row -> row.contains("," + sensor + ",") && row.contains(",quadrotor,")))
                    .hasSizeGreaterThan(18)
                    .allMatch(row -> number(row, names, "value") > 0.0);
        }
    }

    /** Where the kite is. */
    private static Position zigzag(double time) {
        return new Position(3.0 * Math.sin(time), 190.0 - 5.0 * time, 20.0);
    }

    /**
     * How loud the kite is at a distance: 80 dB and 3 dB more for each metre per second above 5, spreading on a sphere,
     * and 5.0 dB/km in air of 20 degrees and 70 % at 1 kHz, where A-weighting is 0 dB (ISO 9613-2, table 2).
     */
    private static double hum(double time, double range) {
        double speed = Math.hypot(5.0, 3.0 * Math.cos(time));
        return 80.0 + 3.0 * (speed - 5.0) - 10.0 * Math.log10(4.0 * Math.PI * range * range) - 0.005 * range;
    }

    /**
     * As many pixels as have their centres in the triangle's picture: counted one by one, but for those within a
     * millionth of a pixel of an edge; and about as many as its picture has area, by Nosarzewska's inequality for the
     * lattice points in a convex figure (Colloquium Mathematicum 1, 1948): between A - L/2 and A + L/2 + 1, where L is
     * its perimeter.
     */
    private static void assertPixels(Position kite, double pixels) {
        Position camera = new Position(0, 0, 2);
        Position axis = new Position(0, 190, 18).unit();
        Position up = new Position(0, -axis.z(), axis.y());
        double focal = 480.0 / Math.tan(Math.toRadians(20.0));
        double[][] corners = Stream.of(new Position(1, 0, 0), new Position(-1, 0, 0), new Position(0, 0, 1.5))
                .map(corner -> kite.plus(corner).minus(camera))
                .map(ray -> new double[] {
                    480.0 + focal * ray.x() / ray.dot(axis), 270.0 - focal * ray.dot(up) / ray.dot(axis)
                })
                .toArray(double[][]::new);
        double area = 0.0;
        double perimeter = 0.0;
        for (int i = 0; i < 3; i++) {
            double[] a = corners[i];
            double[] b = corners[(i + 1) % 3];
            area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
            perimeter += Math.hypot(b[0] - a[0], b[1] - a[1]);
        }
        assertThat(pixels)
                .isBetween((double) centresWithin(corners, -1e-6), (double) centresWithin(corners, 1e-6))
                .isBetween(Math.abs(area) - 0.5 * perimeter, Math.abs(area) + 0.5 * perimeter + 1.0)
                .isGreaterThan(50.0);
    }

    /**
     * The number of pixel centres in a triangle, and in a border about it of a width, or within, if that is negative.
     */
    private static int centresWithin(double[][] corners, double border) {
        int count = 0;
        for (int row = 0; row < 540; row++) {
            for (int column = 0; column < 960; column++) {
                double least = Double.POSITIVE_INFINITY;
                double most = Double.NEGATIVE_INFINITY;
                for (int i = 0; i < 3; i++) {
                    double[] a = corners[i];
                    double[] b = corners[(i + 1) % 3];
                    double side = (b[0] - a[0]) * (row + 0.5 - a[1]) - (b[1] - a[1]) * (column + 0.5 - a[0]);
                    double distance = side / Math.hypot(b[0] - a[0], b[1] - a[1]);
                    least = Math.min(least, distance);
                    most = Math.max(most, distance);
                }
                count += least >= -border || most <= border ? 1 : 0;
            }
        }
        return count;
    }

    /** High and low; one half, at which the threshold does not move, in the long form. */
    private static DoubleStream probabilities() {
        return LongForm.IS_ON ? DoubleStream.of(0.9, 0.5, 0.05) : DoubleStream.of(0.9, 0.05);
    }

    /**
     * A listener of the other jar is not sure of what it hears. The probability asked for moves the threshold by the
     * logit, in the closed form of that kind; and as many looks as asked for detect the drone at the range.
     */
    @Thorough
    @ParameterizedTest
    @MethodSource("probabilities")
    void aSensorOfSlopingProbabilityIsCalibratedToAProbability(double probability) throws IOException {
        Files.copy(PROJECT.resolve("wall.off"), directory.resolve("wall.off"));
        String scene =
                """
                world: {models: [wall.off], backgroundNoise: 20}
                drones:
                  quadrotor:
                    model: packaged:quadrotor.obj
                    flight: {kind: hover, position: [0, 80, 2]}
                    emission: {kind: hum, perSpeed: 0 dB}
                sensors:
                  ear: %s
                run: {duration: 200 s}
                """;
        String position = "position: [0, 0, 2], rate: 10 Hz";
        Files.writeString(
                directory.resolve("listener.yaml"),
                scene.formatted("{kind: acoustic, propagation: {kind: spherical, slope: 2.5 dB}, " + position + "}"));
        Program.Outcome outcome = withJar.run(
                "calibrate",
                at("listener.yaml"),
                "--sensor=ear",
                "--drone=quadrotor",
                "--range=80m",
                "--out",
                at("fitted.yaml"),
                "--probability=" + probability);
        assertThat(outcome.code()).as(outcome.err()).isZero();

        double logit = Math.log(probability / (1.0 - probability));
        double threshold = 55.0 - 20.0 * Math.log10(80.0) - 20.0 - 2.5 * logit;
        assertThat(Double.parseDouble(outcome.out().replaceFirst("(?s)threshold ([-0-9.]+) dB: 80\\.000 m.*", "$1")))
                .isCloseTo(threshold, within(2e-6));

        assertThat(Files.readString(directory.resolve("fitted.yaml")))
                .as("by what sound the range holds")
                .contains("kind: hum", "soundLevel: 55 dB");

        Files.writeString(directory.resolve("again.yaml"), scene.formatted("{use: fitted, " + position + "}"));
        outcome = withJar.run("run", at("again.yaml"), "--observations", "--out", at("again"));
        assertThat(outcome.code()).as(outcome.err()).isZero();
        List<String> looks = Files.readAllLines(directory.resolve("again/observations.csv"));
        long detected = looks.stream().filter(row -> row.contains(",dB,true,")).count();
        // Of 2001 looks, as many as a binomial distribution gives within four standard deviations.
        assertThat(looks).hasSize(2002);
        double spread = Math.sqrt(2001 * probability * (1.0 - probability));
        assertThat(detected / 1.0).isCloseTo(2001 * probability, within(4.0 * spread));
    }

    @Test
    void aSensorIsSwappedForItsKindByOneSetting() throws IOException {
        copyTheScene();
        Program.Outcome outcome =
                withJar.run("run", at("scene.yaml"), "--set", "sensors.camera=spotter", "--out", at("out"));
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(Files.readString(directory.resolve("out/detections.csv"))).contains(",camera,spotter,");
    }

    @Thorough
    @Test
    void aSavedSceneHasItsKindsAndTheSameDetections() throws IOException {
        copyTheScene();
        String[] swap = {"--set", "sensors.camera=spotter", "--set", "sensors.camera.reach=70 m"};
        Program.Outcome outcome =
                withJar.run("save", at("scene.yaml"), swap[0], swap[1], swap[2], swap[3], "--out", at("saved.yaml"));
        assertThat(outcome.code()).as(outcome.err()).isZero();
        withJar.run("run", at("scene.yaml"), swap[0], swap[1], swap[2], swap[3], "--out", at("direct"));
        outcome = withJar.run("run", at("saved.yaml"), "--out", at("again"));
        assertThat(outcome.code()).as(outcome.err()).isZero();
        String detections = Files.readString(directory.resolve("again/detections.csv"));
        assertThat(detections)
                .contains(",camera,spotter,")
                .isEqualTo(Files.readString(directory.resolve("direct/detections.csv")));
    }

    @Test
    void anEditorKnowsItsKinds() throws IOException {
        String scene = Files.readString(PROJECT.resolve("scene.yaml"));
        Schema without = schema(Program.run("schema"));
        assertThat(without.validate(scene, InputFormat.YAML)).isNotEmpty();

        Schema with = schema(withJar.run("schema"));
        assertThat(with.validate(scene, InputFormat.YAML)).isEmpty();
        for (String part :
                List.of("kind: spotter", "propagation: spherical", "kind: zigzag", "kind: hum", "any-pixel")) {
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
    void theSchemaSaysOfItsSettingsWhatItKnows() throws IOException {
        JsonNode sensors = JsonMapper.builder()
                .build()
                .readTree(withJar.run("schema").out())
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

    @Thorough
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
    void itsLimitsHoldInFiles() throws IOException {
        copyTheScene();
        Program.Outcome outcome = withJar.run("check", at("scene.yaml"), "--set", "sensors.eyes.reach=6 km");
        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.complaints())
                .singleElement()
                .asString()
                .contains("reach 6000 m must be above 0 and at most 5000");
    }

    @Test
    void withoutItsJarTheKindIsUnknownAndNoClassIsTaken() throws IOException {
        copyTheScene();
        String scene = Files.readString(directory.resolve("scene.yaml"));
        Program.Outcome outcome = Program.run("check", at("scene.yaml"));
        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.err()).contains("unknown kind 'spotter'").doesNotContain("\tat ");
        Files.writeString(
                directory.resolve("scene.yaml"), scene.replace("spotter", "org.example.watch.SpotterSettings"));
        outcome = withJar.run("check", at("scene.yaml"));
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
