package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.terrain.TerrainSettings;
import org.dronewatch.world.Obstacle;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Scenes whose ground comes from a file of elevations, as a user writes and runs them. */
class TerrainSceneTest {
    private static final String SITE =
            """
            world:
              origin: {latitude: 50.0 deg, longitude: 15.0 deg, height: 200 m}
              terrain: {file: ground.asc, crs: EPSG:32633, accuracy: 0}
            """;

    @TempDir
    private Path directory;

    /** A wall of ground 20 m high runs north to south 50 m east of the origin, which is at grid 500000, 5538630.74. */
    @BeforeEach
    void writeGround() throws IOException {
        StringBuilder text =
                new StringBuilder("ncols 41\nnrows 41\nxllcenter 499900\nyllcenter 5538530.74\ncellsize 5\n");
        for (int row = 0; row < 41; row++) {
            for (int column = 0; column < 41; column++) {
                text.append(column == 30 ? "220 " : "200 ");
            }
            text.append('\n');
        }
        Files.writeString(directory.resolve("ground.asc"), text);
    }

    private Path scene(String text) throws IOException {
        return Files.writeString(directory.resolve("site.yaml"), text);
    }

    private World world(String text, List<String> notes) throws IOException {
        SceneRunner runner = new SceneRunner(new SceneFile(scene(text))).notes(notes::add);
        SceneSettings settings = runner.settings();
        return runner.stage(settings).world();
    }

    @Test
    void theGroundAloneIsAWorld() throws IOException {
        List<String> notes = new ArrayList<>();
        World world = world(SITE, notes);
        assertThat(world.surfaceHeight(10.0, 7.0).orElseThrow()).isBetween(-0.01, 0.01);
        Obstacle wall = new Visibility(world)
                .obstacle(new Position(0, 0, 10), new Position(80, 0, 10))
                .orElseThrow();
        assertThat(wall.model().role()).isEqualTo(ModelRole.TERRAIN);
        assertThat(wall.model().file()).isEqualTo("ground.asc");
        assertThat(wall.material()).isEqualTo("pasture_uncompacted");
        assertThat(new Visibility(world).isFree(0, 0, 10, 80, 0, 40)).isTrue();
        assertThat(String.join("\n", notes))
                .contains("read ground.asc: 41 x 41 posts, EPSG:32633")
                .contains("0.10 km west, 0.10 km east, 0.10 km north and 0.10 km south of the origin")
                .contains("200.0 to 220.0 m high, 200.0 m at the origin (z = 0.0 m)")
                .contains("3,200 of 3,200 triangles, maximum vertical error 0.000 m (accuracy: 0.0 m), no holes");
    }

    /** Models stand on the ground, and each hides as what it is. */
    @Test
    void groundAndModelsMakeOneWorld() throws IOException {
        Files.writeString(
                directory.resolve("house.obj"),
                "v 20 0 -9\nv 20 0 9\nv 20 15 9\nv 20 15 -9\nusemtl brick_rough\nf 1 2 3 4\n");
        List<String> notes = new ArrayList<>();
        World world = world(
                SITE.replace("accuracy: 0", "accuracy: 0, surface: dsm, material: grass_turf")
                        + "  models: [house.obj]\n",
                notes);
        Visibility visibility = new Visibility(world);
        assertThat(visibility
                        .obstacle(new Position(0, 0, 10), new Position(40, 0, 10))
                        .orElseThrow()
                        .model()
                        .role())
                .isEqualTo(ModelRole.BUILDING);
        Obstacle ground = visibility
                .obstacle(new Position(25, 0, 10), new Position(80, 0, 10))
                .orElseThrow();
        assertThat(ground.model().role()).isEqualTo(ModelRole.TERRAIN);
        assertThat(ground.material()).isEqualTo("grass_turf");
        assertThat(world.surfaces()).extracting(surface -> surface.name()).containsExactly("grass_turf", "brick_rough");
        assertThat(notes)
                .anyMatch(line -> line.contains("world.terrain.surface is dsm: its heights may include roofs")
                        && line.contains("house.obj"));
    }

    /** Pictures get the colour of the material, unless a model has a material of this name with a colour. */
    @Test
    void theGroundLooksLikeItsMaterial() throws IOException {
        String water = SITE.replace("accuracy: 0", "accuracy: 0, material: water_surface");
        assertThat(colours(SITE)).containsEntry("pasture_uncompacted", TerrainSettings.COLOUR);
        assertThat(colours(water))
                .containsEntry(
                        "water_surface",
                        TerrainSettings.DEFAULT.withMaterial("water_surface").colour());

        Files.writeString(directory.resolve("pool.mtl"), "newmtl water_surface\nKd 1 0 0\n");
        Files.writeString(
                directory.resolve("pool.obj"),
                "mtllib pool.mtl\nv 0 0 9\nv 5 0 9\nv 5 5 9\nusemtl water_surface\nf 1 2 3\n");
        assertThat(colours(water + "  models: [pool.obj]\n")).containsEntry("water_surface", 0xFF0000);
    }

    private Map<String, Integer> colours(String text) throws IOException {
        SceneRunner runner = new SceneRunner(new SceneFile(scene(text))).notes(note -> {});
        return runner.stage(runner.settings()).colours();
    }

    @Test
    void checkSaysWhatWasRead() throws IOException {
        Outcome outcome = Program.run(
                "check",
                scene(SITE).toString(),
                "--set",
                "world.terrain.accuracy=1",
                "--set",
                "world.terrain.radius=50");
        assertThat(outcome.code()).isZero();
        assertThat(outcome.out()).contains("site is valid: terrain, 0 models, 0 drones");
        assertThat(outcome.err())
                .contains("read ground.asc: 41 x 41 posts")
                .contains("maximum vertical error 0.00")
                .contains("(accuracy: 1.0 m)");
    }

    /** Nine tiles of 100 m, of which the middle one is missing: what lies behind it is not known to be free. */
    @Test
    void whatLiesBehindAMissingTileIsUnknown() throws IOException {
        List<String> tiles = new ArrayList<>();
        for (int tile = 0; tile < 9; tile++) {
            if (tile != 4) {
                String name = "tile" + tile + ".asc";
                tiles.add(name);
                Files.writeString(
                        directory.resolve(name),
                        "ncols 11\nnrows 11\nxllcenter " + (499850 + 100 * (tile % 3)) + "\nyllcenter "
                                + (5538480.74 + 100 * (tile / 3)) + "\ncellsize 10\n" + "200 ".repeat(121) + "\n");
            }
        }
        Path scene = scene(
                SITE.replace("file: ground.asc", "files: [" + String.join(", ", tiles) + "]")
                        + """
                drones:
                  across: {model: packaged:quadrotor.obj, flight: {kind: hover, position: [90, 0, 10]}}
                  beside: {model: packaged:quadrotor.obj, flight: {kind: hover, position: [-90, 90, 10]}}
                sensors:
                  eye: {kind: rf, position: [-90, -40, 10]}
                  camera: {kind: camera, position: [-90, -40, 10], aim: {azimuth: 40 deg}, fov: 90 deg, width: 200, height: 150}
                  radar: {kind: radar, position: [-90, -40, 10], budget: {range: 5000, crossSection: 0.01}}
                  ear: {kind: acoustic, position: [-90, -40, 10], propagation: {kind: level-model, initialRays: 1, reflectionsPerHit: 1, maxOrder: 0}}
                run: {duration: 1 s}
                """);
        Path out = directory.resolve("out");
        Outcome run = Program.run("run", scene.toString(), "--observations", "--out", out.toString());

        assertThat(run.code()).as(run.err()).isZero();
        assertThat(run.out())
                .contains("over unknown ground")
                .contains("run 0 eye across")
                .doesNotContain("eye beside,");
        List<String> observations = Files.readAllLines(out.resolve("observations.csv"));
        for (String sensor : List.of("eye,rf", "camera,camera", "radar,radar", "ear,acoustic")) {
            assertThat(observations)
                    .filteredOn(line -> line.contains(sensor + ",across,"))
                    .as(sensor)
                    .isNotEmpty()
                    .allMatch(line -> line.contains("unknown=1"));
            assertThat(observations)
                    .filteredOn(line -> line.contains(sensor + ",beside,"))
                    .as(sensor)
                    .isNotEmpty()
                    .noneMatch(line -> line.contains("unknown"));
        }
        assertThat(Files.readString(out.resolve("result.json")).split("}"))
                .filteredOn(pair -> pair.contains("\"unknown_ground\" : true"))
                .hasSizeGreaterThan(1)
                .allMatch(pair -> pair.contains("\"across\""));
        assertThat(Files.readString(out.resolve("report.html"))).contains("(over unknown ground)");

        Outcome coverage = Program.run(
                "coverage",
                scene.toString(),
                "--set",
                "sensors.camera.enabled=false",
                "--set",
                "sensors.ear.enabled=false",
                "--side",
                "280",
                "--cells",
                "28",
                "--out",
                directory.resolve("plan.png").toString());
        assertThat(coverage.code()).as(coverage.err()).isZero();
        assertThat(coverage.out())
                .contains("in % of the 400 cells with ground below them")
                .contains("unknown");
        assertHatched(ImageIO.read(directory.resolve("plan.png").toFile()));
    }

    /**
     * A cell with ground that lies behind the hole has diagonal stripes, five pixels wide; one in front of it has none.
     * The plan is centred on the sensors.
     */
    private static void assertHatched(BufferedImage plan) {
        int left = column(20.0) + 2;
        int top = row(80.0) + 2;
        for (int i = 0; i < 30; i++) {
            for (int j = 0; j < 30; j++) {
                assertThat(isDark(plan, left + i, top + j))
                        .as("pixel %d, %d", left + i, top + j)
                        .isEqualTo((left + i + top + j) / 5 % 2 == 0);
            }
        }
        for (int i = 0; i < 30; i++) {
            assertThat(isDark(plan, column(-90.0) + i, row(35.0))).isTrue();
        }
    }

    private static int column(double east) {
        return (int) Math.ceil((east + 90.0 + 140.0) / 0.28);
    }

    private static int row(double north) {
        return (int) Math.ceil((140.0 - north - 40.0) / 0.28);
    }

    private static boolean isDark(BufferedImage plan, int column, int row) {
        return (plan.getRGB(column, row) & 0xFF) < 0xB0;
    }

    /** As in a file, so in Java. */
    @Test
    void aSceneInJavaHasGroundToo() throws IOException {
        TerrainSettings ground = TerrainSettings.of(
                        directory.resolve("ground.asc").toString())
                .withCrs("EPSG:32633")
                .withAccuracy(0.0);
        Scene scene = new Scene() {
            @Override
            protected void build() {
                loadTerrain(ground);
                setOrigin(Origin.at(Math.toRadians(50.0), Math.toRadians(15.0)).withHeight(200.0));
                surface("pasture_uncompacted", "grass_turf");
            }
        };
        SceneRunner runner = new SceneRunner(scene);
        World world = runner.stage(runner.settings()).world();
        assertThat(world.mesh().triangleCount()).isEqualTo(3200);
        assertThat(world.surfaces()).extracting(surface -> surface.name()).containsExactly("grass_turf");
        assertThat(world.surfaceHeight(10.0, 7.0).orElseThrow()).isBetween(-0.01, 0.01);
    }

    /** A sweep over the accuracy reads the files once for each of its values. */
    @Test
    void theAccuracyCanBeSwept() throws IOException {
        Outcome outcome = Program.run(
                "check",
                scene(SITE + "sweep: {parameter: world.terrain.accuracy, values: [0, 5, 30]}\n")
                        .toString());
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.err())
                .contains("3,200 of 3,200 triangles")
                .contains("(accuracy: 5.0 m)")
                .contains("terrain: 2 of 3,200 triangles, maximum vertical error 20.0");
    }

    /** Nothing hides what flies where nothing is known: a line says so, once for each sensor and each drone. */
    @Test
    void whatLeavesTheGroundIsNamed() throws IOException {
        String scene = SITE
                + """
                drones:
                  far:
                    model: packaged:quadrotor.obj
                    flight: {kind: waypoints, points: [[0, 0, 30], [0, 200, 30]]}
                    speed: 10 m/s
                  near:
                    model: packaged:quadrotor.obj
                    flight: {kind: hover, position: [10, 10, 30]}
                sensors:
                  outside: {kind: camera, position: [300, 0, 10]}
                  inside: {kind: camera, position: [0, 0, 10]}
                  round: {kind: rf, position: [0, 0, 10], groundReflection: {roundEarth: true}}
                  level: {kind: rf, position: [0, 0, 10], groundReflection: {roughness: 1 cm}}
                run: {duration: 20 s}
                """;
        Outcome outcome = Program.run("check", scene(scene).toString());
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.err())
                .containsPattern(
                        "warning: drone 'far' has no terrain below it at 1[0-9][.]. s, at \\(0[.]0, 1..[.].\\) m")
                .contains("warning: sensor 'outside' at (300.0, 0.0) m has no terrain below it")
                .containsOnlyOnce("warning: sensor 'round' has groundReflection.roundEarth, but the ground from files")
                .doesNotContain("'level' has groundReflection")
                .doesNotContain("'near' has")
                .doesNotContain("'inside' at");
    }

    @Test
    void groundAtTheOriginsHeightIsAtZero() throws IOException {
        Outcome outcome =
                Program.run("check", scene(SITE.replace("200 m", "200.01 m")).toString());
        assertThat(outcome.err()).contains("200.0 m at the origin (z = 0.0 m)");
    }

    /** Each mistake is a line with its place in the file, and exit code 2. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "file: ground.asc, crs: EPSG:32633|file: missing.asc|site.yaml:3:19: world.terrain.file: file 'missing.asc' does not exist",
                "file: ground.asc, crs: EPSG:32633|file: ground.asc|site.yaml:3:12: world.terrain: ground.asc: does not state its coordinate reference system",
                "EPSG:32633|EPSG:99999|site.yaml:3:36: world.terrain.crs: coordinate reference system 'EPSG:99999' is not known",
                "EPSG:32633|EPSG:32632|site.yaml:3:12: world.terrain: ground.asc: no posts within 2000.0 m of the origin",
                "file: ground.asc|files: [ground.asc, missing.asc]|world.terrain.files.1: file 'missing.asc' does not exist",
                "file: ground.asc|files: [ground.asc], file: ground.asc|files and 'file' are both given",
                "file: ground.asc|files: [../ground.asc]|must be a relative path to a file in",
                "file: ground.asc, crs: EPSG:32633|radius: 1 km|world.terrain needs a 'file'",
                "accuracy: 0|accuracy: -1|world.terrain.accuracy: accuracy -1 m must be 0 to 1000",
                "accuracy: 0|accurracy: 0|unknown setting 'accurracy'; did you mean 'accuracy'?",
                "  origin: {latitude: 50.0 deg, longitude: 15.0 deg, height: 200 m}||world.terrain needs a world.origin",
            })
    void mistakesAreNamedWithTheirPlace(String from, String to, String message) throws IOException {
        Outcome outcome = Program.run(
                "check", scene(SITE.replace(from, to == null ? "" : to)).toString());
        assertThat(outcome.err()).contains(message);
        assertThat(outcome.complaints()).as(outcome.err()).hasSize(1);
        assertThat(outcome.code()).isEqualTo(2);
    }

    @Test
    void aWorldOfNothingIsRefused() throws IOException {
        Outcome outcome = Program.run("check", scene("world: {rain: 1}\n").toString());
        assertThat(outcome.err()).contains("world.models is empty: a world needs at least one, or a terrain");
        assertThat(outcome.code()).isEqualTo(2);
    }

    @Test
    void aSavedSceneHasTheSameGround() throws IOException {
        Path saved = directory.resolve("saved.yaml");
        Outcome outcome = Program.run("save", scene(SITE).toString(), "--out", saved.toString());
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(Files.readString(saved)).contains("ground.asc").contains("EPSG:32633");
        assertThat(new SceneFile(saved).describe()).isEqualTo(new SceneFile(directory.resolve("site.yaml")).describe());
        Path elsewhere = Files.createDirectory(directory.resolve("elsewhere")).resolve("saved.yaml");
        Outcome refused = Program.run("save", directory.resolve("site.yaml").toString(), "--out", elsewhere.toString());
        assertThat(refused.code()).isEqualTo(2);
        assertThat(refused.err()).contains("world.terrain.file: file '").contains("is neither in");
        String several = SITE.replace("file: ground.asc", "files: [ground.asc]");
        Path list = Files.writeString(directory.resolve("list.yaml"), several);
        assertThat(Program.run("save", list.toString(), "--out", saved.toString())
                        .code())
                .isZero();
        assertThat(new SceneFile(saved)
                        .describe()
                        .world()
                        .terrain()
                        .orElseThrow()
                        .files())
                .containsExactly("ground.asc");
    }

    /** What lies in the documentation for readers to copy. */
    @Test
    void theExampleIsValid() {
        Outcome outcome = Program.run("check", "scenes/monaco.yaml");
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.err())
                .contains("-2.0 to 608.0 m high")
                .contains("of 5,118 triangles")
                .contains("1 post without a height (a hole)")
                .contains("889 buildings within 2000 m of the origin, 554,760 m2")
                .contains("cells of 1 m: water 8,795,460 m2, residential area 1,038,957 m2, road 328,346 m2")
                .containsOnlyOnce("warning: monaco.osm.gz: 889 of 889 buildings have no height")
                .containsOnlyOnce("warning: world.terrain.surface is dsm");
    }
}
