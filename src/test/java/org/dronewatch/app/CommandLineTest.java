package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.GraphicsEnvironment;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.dronewatch.Thorough;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.catalog.Positioners;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class CommandLineTest extends CommandLines {
    private static final String TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

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
                "coverage camera-range --heights 10,low                  | --heights low: 'low' | number",
                "coverage camera-range --heights 30,10                   | height 10.0 m | ascending order",
                "coverage camera-range --cell 1mm                        | 500000 cells | at most 2000",
                "coverage camera-range --heading north                   | --heading north | worst, best or inbound",
                "coverage camera-range --covered 0                       | --covered 0: | 0.008 to 0.996, or 1",
                "coverage camera-range --height 10                       | --height      | needs --out FILE.png",
                "coverage camera-range --cells 10 --out DIR/field        | --cells       | needs --out FILE.png",
                "coverage camera-range --heights 10 --out DIR/a.png      | --heights     | a plan",
                "check camera-range --set sensors.camera.fov=4            | fov 229.1831 deg | 0.01 to 179 deg",
                "render camera-range --camera eye --time 1 --out DIR/a.png | eye          | camera",
                "render camera-range --camera camera --time 40 --out DIR/a.png | 40        | 0 to 39",
                "render camera-range --camera camera --time soon --out DIR/a.png | soon    | number",
                "render camera-range --camera camera --time 1 --out DIR/a.bmp | a.bmp      | .png",
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
                "help rum                                                 | unknown command 'rum' | did you"
                        + " mean 'run'? (see 'dronewatch --help')",
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

    @Test
    void everyCommandHasHelpWithAnExample() {
        for (String name : List.of("run", "check", "render", "bench", "list", "models", "schema")) {
            Program.Outcome outcome = Program.run(name, "--help");
            assertThat(outcome.code()).isZero();
            assertThat(outcome.out()).contains("Usage:").contains(name);
            if (!name.equals("list")) {
                assertThat(outcome.out()).contains("Example");
            }
        }
        assertThat(Program.run("--help").out()).contains("Example");
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
        Program.Outcome outcome = Program.run(
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

    /** Each entry of the list, by the name in its second column, states where its figures come from. */
    @Test
    void listPrintsEveryEntryWithItsSource() {
        List<String> names = Program.run("list")
                .out()
                .lines()
                .filter(line -> !line.startsWith("scene "))
                .map(line -> line.split("\\s+")[1])
                .toList();
        assertThat(names).hasSizeGreaterThan(15).contains("spotterrf-c550", "liteye", "viper");
        assertThat(names)
                .allSatisfy(name -> assertThat(Program.run("list", name).out()).contains("title: ", "source: "));
        assertThat(Program.run("list", "spotter-c550").complaints())
                .singleElement()
                .asString()
                .startsWith("no entry 'spotter-c550' in the catalogue; closest matches: spotterrf-c550, ");
        assertThat(Program.run("list", "spotter-c550").code()).isEqualTo(2);
        assertThat(Program.run("list", "--kinds", "viper").code()).isEqualTo(2);
    }

    @Test
    void listTellsEachSceneInALine() {
        assertThat(Program.run("list").out().lines().map(line -> line.split("\\s+")[1]))
                .startsWith("closed-space", "camera-range", "acoustic-range", "multi-sensor")
                .containsSubsequence(Catalog.packagedNames())
                .endsWith(Positioners.packagedNames().toArray(String[]::new));
    }

    @Test
    void checkRunsNothing() throws IOException {
        Program.Outcome outcome = Program.run("check", "camera-range");

        assertThat(outcome.code()).isZero();
        assertThat(outcome.out().lines().findFirst().orElseThrow())
                .matches("camera-range is valid: 1 model, 1 drone, 1 sensor, 5 runs of [0-9.]+ s");
        assertThat(files()).isEmpty();
    }

    @Test
    void checkShowsWhatEachSensorStandsOn() {
        Program.Outcome outcome = Program.run(
                "check",
                "multi-sensor",
                "--set",
                "sensors.microphone.position=100, 0, 200",
                "--set",
                "sensors.north-east-1.position=0, 0, -500");

        assertThat(outcome.out().lines())
                .contains("sensor 'north-east-2' is 0.9 m above house.obj")
                .contains("sensor 'north-east-1' is not above any surface")
                .anyMatch(line -> line.matches("sensor 'microphone' is [0-9.]+ m above the ground"));
        assertThat(Program.run("check", "multi-sensor", "--json").out())
                .containsPattern("\"north-east-2\" : \\{\\s+\"above_m\" : 0.89[0-9]+,\\s+\"surface\" : \"house.obj\"");
    }

    @Test
    void checkSaysWhichSensorsAreSwitchedOffAndOfWhichRunItSpeaks() {
        Program.Outcome outcome = Program.run("check", "camera-range", "--set", "sensors.camera.enabled=false");

        assertThat(outcome.out().lines().skip(1))
                .singleElement()
                .asString()
                .endsWith(" in the first run (switched off)");
    }

    @Test
    void checkShowsTheLabelOfADroneThatHasOne() {
        Program.Outcome outcome = Program.run(
                "check",
                "camera-range",
                "--set",
                "drones.quadrotor.label.purpose=espionage",
                "--set",
                "drones.quadrotor.label.weight=1.25 kg");

        assertThat(outcome.out().lines().skip(1))
                .startsWith("drone 'quadrotor' is labelled attack, espionage, 1.25 kg");
    }

    @Test
    void checkCountsSensorsThatAreSwitchedOff() {
        Program.Outcome outcome = Program.run("check", "multi-sensor", "--set", "sensors.north-east-1.enabled=false");

        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.out()).contains(" drone, 13 sensors (1 switched off), ");
    }

    @Thorough
    @Test
    void runWarnsThatThereAreNoRaysToWrite() throws IOException {
        String run = "run multi-sensor --set run.duration=0.1 --out DIR/out --rays DIR/rays.obj";
        assertThat(commandIn(run).err()).containsPattern("[1-9][0-9,]* ray segments written");

        Program.Outcome outcome = commandIn(run + " --set sensors.microphone.enabled=false");
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.err())
                .containsOnlyOnce("warning: --rays ")
                .contains("rays.obj: the file contains no rays, since the scene has no drone, or no acoustic sensor"
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
        Program.Outcome outcome = commandIn("render camera-range --camera camera --time 35 --out DIR/view.png"
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

    @Thorough
    @Test
    void modelsAreWrittenAsTheyAreShipped() throws IOException {
        Program.Outcome outcome = commandIn("models --out DIR");

        assertThat(outcome.code()).as(outcome.err()).isZero();
        for (Map.Entry<String, String> file : files().entrySet()) {
            assertThat(file.getValue().getBytes(java.nio.charset.StandardCharsets.ISO_8859_1))
                    .isEqualTo(Files.readAllBytes(Path.of("models", file.getKey())));
        }
        assertThat(files()).containsKeys("hill.obj", "quadrotor.obj", "house.obj", "house.mtl");
    }

    @Test
    void overridesWithoutASceneAreRefused() {
        Program.Outcome outcome = commandIn("view --set run.duration=1");

        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.err()).contains("--set changes the settings of one scene: name the SCENE as well");
    }

    @Test
    void aSceneToCompareWithNeedsAFirstOneAndMustBeThere() {
        Program.Outcome alone = commandIn("view --beside multi-sensor");
        assertThat(alone.code()).isEqualTo(2);
        assertThat(alone.err()).contains("--beside compares with a scene: name the SCENE as well");

        Program.Outcome unknown = commandIn("view multi-sensor --beside multi-senso");
        assertThat(unknown.code()).isEqualTo(2);
        assertThat(unknown.err()).contains("unknown scene 'multi-senso'");
    }

    @ParameterizedTest
    @ValueSource(strings = {"view", "view multi-sensor", "run multi-sensor --view --out DIR/results"})
    void withoutADisplayAWindowIsRefusedInOneLine(String line) throws IOException {
        assumeTrue(GraphicsEnvironment.isHeadless());
        Program.Outcome outcome = commandIn(line);

        assertThat(outcome.code()).isEqualTo(3);
        assertThat(outcome.out()).isEmpty();
        assertThat(outcome.err().lines()).hasSize(1);
        assertThat(outcome.err())
                .startsWith("cannot open a window: there is no display")
                .contains("'render'");
        assertThat(files()).isEmpty();
    }

    @Thorough
    @ParameterizedTest
    @ValueSource(strings = {"top", "side", "orbit"})
    void rendersTheSite(String view) throws IOException {
        Program.Outcome outcome =
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
                "--view top --size 10x10 | --size 10x10: must be WIDTHxHEIGHT, as in 1280x800",
                "--view top --size wide | --size wide: must be WIDTHxHEIGHT, as in 1280x800",
                "--view top --size 9000x9000 | from 64 to 8192",
                "--view top --scale 0 | --scale 0.0: must be 0.5 to 8",
                "--view top --focus nobody | --focus nobody: no such sensor or drone; the scene has camera, quadrotor",
                "--view orbit --bearing north | --bearing north",
                "--view orbit --cut roof | --cut roof",
                "--view orbit --max-order -1 --rays | --max-order -1",
                "--view orbit --rays | no sensor of the scene traces rays",
                "--view orbit --rays --focus camera | the sensor given by --focus, camera, traces no rays",
                "--view orbit --time 99 | --time 99: must be 0 to 39",
            })
    void aPictureThatCannotBeIsRefusedInOneLine(String options, String said) throws IOException {
        Program.Outcome outcome = commandIn("render camera-range --out DIR/site.png " + options);

        assertThat(outcome.code()).as(outcome.err()).isEqualTo(2);
        assertThat(outcome.err()).contains(said);
        assertThat(outcome.err().lines().filter(line -> !line.startsWith("read ")))
                .hasSize(1);
        assertThat(files()).isEmpty();
    }
}
