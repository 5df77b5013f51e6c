package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.dronewatch.Thorough;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.drone.DroneClass;
import org.dronewatch.drone.RadarSignature;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.terrain.io.TiffFixture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What 'new' creates is ready to run, and what is wrong leaves nothing behind. */
class NewCommandTest {
    private static final String SRTM = "sites/monaco-srtm.asc";
    private static final String MAP = "sites/monaco.osm.gz";

    @TempDir
    private Path directory;

    private Outcome make(String options) {
        List<String> words =
                new ArrayList<>(List.of("new", directory.resolve("town").toString()));
        words.addAll(List.of(options.strip().split(" ")));
        return Program.run(words.toArray(String[]::new));
    }

    private SceneSettings settings() {
        return new SceneRunner(new SceneFile(directory.resolve("town/town.yaml"))).settings();
    }

    private List<String> left() throws IOException {
        try (Stream<Path> all = Files.list(directory)) {
            return all.map(file -> file.getFileName().toString()).toList();
        }
    }

    @Test
    void aSceneHasASensorOfEachKindOnItsHighestPoints() throws IOException {
        Outcome outcome =
                make("--at 43.7314,7.4202 --radius 1500m --terrain " + SRTM + " --crs EPSG:4326 --buildings " + MAP);
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.out()).contains("scene in ").contains("town.yaml");
        assertThat(outcome.err()).containsOnlyOnce("read monaco.osm.gz").contains("next: dronewatch view");
        assertThat(left()).containsExactly("town");

        SceneSettings scene = settings();
        assertThat(scene.sensors().values())
                .extracting(SensorSettings::kind)
                .containsExactlyInAnyOrder("radar", "rf", "camera", "thermal", "acoustic");
        // The Rock is 60 to 70 m high there, its houses 9 m more.
        assertThat(scene.sensors().get("radar").position().z()).isBetween(70.0, 90.0);
        assertThat(scene.alert().protect()).isPresent();
        // Its echo is as measured, not the round figure of data sheets.
        RadarSignature echo = scene.drones().get("intruder").radar();
        assertThat(echo.droneClass()).contains(DroneClass.SMALL_UAV);
        assertThat(echo.deviation()).isEqualTo(3.74);
        assertThat(scene.world().terrain().orElseThrow().allFiles()).containsExactly("monaco-srtm.asc");
        assertThat(scene.world().buildings().orElseThrow().landCover()).isTrue();
        // The intruder is about as high as the mast, a little lower; its elevation is not -0.
        assertThat(Files.readString(directory.resolve("town/town.yaml")))
                .containsPattern("of the path: \\d+ % of it is hidden\\.")
                .contains("elevation: 0 deg}")
                .doesNotContain("-0 ")
                .doesNotContainPattern("\\.\\d{3,} m\\b");
    }

    /** A map alone, or elevations alone, make a site as well; a directory may exist if it is empty. */
    @Thorough
    @ParameterizedTest
    @CsvSource({"--buildings " + MAP, "--terrain " + SRTM + " --crs EPSG:4326"})
    void oneOfBothIsEnough(String files) throws IOException {
        Files.createDirectory(directory.resolve("town"));
        Outcome outcome = make("--at 43.7314,7.4202 --radius 500m " + files);
        assertThat(outcome.code()).as(outcome.err()).isZero();
        SceneSettings scene = settings();
        Outcome run = Program.run(
                "run",
                directory.resolve("town/town.yaml").toString(),
                "--set",
                "run.duration=1s",
                "--out",
                directory.resolve("out").toString());
        assertThat(run.code()).as(run.err()).isZero();
        assertThat(scene.sensors()).hasSize(5);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--at 43.7314,7.4202 | needs --terrain, --buildings or both",
                "--at 43.7314 --buildings MAP | --at 43.7314: must be latitude and longitude in degrees",
                "--at 93,7 --buildings MAP | --at 93,7: must be latitude and longitude in degrees",
                "--at x,7 --buildings MAP | --at x,7: must be latitude and longitude in degrees",
                "--at 43.7,7.4 --radius 5m --buildings MAP | --radius 5m: must be 200 m to 20000 m",
                "--at 43.7,7.4 --radius far --buildings MAP | --radius far: ",
                "--at 43.7,7.4 --buildings none.osm | --buildings none.osm: no such file",
                "--at 43.7,7.4 --terrain src | --terrain src: is a directory",
                "--at 43.7314,7.4202 --terrain SRTM | --terrain SRTM: does not state a known coordinate reference system",
                "--at 43.7314,7.4202 --terrain SRTM --crs EPSG:1 | --crs EPSG:1: ",
                "--at 43.7314,7.4202 --terrain SRTM SRTM --crs EPSG:4326 | another file has the same name",
                "--at 10,10 --buildings MAP | --buildings MAP: has no building within 2000 m of the origin, at latitude",
                "--at 7.42,43.73 --buildings MAP | latitude and longitude of the origin seem to be swapped",
                "--at 10,10 --terrain SRTM --crs EPSG:4326 | --terrain SRTM: no posts within 2000.0 m of the origin, at",
                "--at 7.42,43.73 --terrain SRTM --crs EPSG:4326 | latitude and longitude of the origin seem to be swapped",
                "--at 43.73,7.42 --terrain SRTM --crs EPSG:32632 | seem to be longitude and latitude, for which crs is EPSG:4326",
                "--at 43.7,7.4 --buildings README.md | --buildings README.md: is not OpenStreetMap XML",
                "--at 43.7,7.4 --buildings SRTM | --buildings SRTM: is an ESRI ASCII grid, which belongs under world.terrain, not",
                "--at 43.7,7.4 --terrain README.md | --terrain README.md: is not a GeoTIFF file",
                "--at 43.7,7.4 --terrain src/test/resources/fuzz/README.md --buildings scenes/scene.schema.json"
                        + " | --terrain src/test/resources/fuzz/README.md: is not a GeoTIFF file",
                "--at 43.7,7.4 --buildings scenes/scene.schema.json | --buildings scenes/scene.schema.json: 'type' is",
            })
    void whatIsWrongLeavesNothingBehind(String options, String message) throws IOException {
        Outcome outcome = make(options.replace("MAP", MAP).replace("SRTM", SRTM));
        assertThat(outcome.code()).as(outcome.err()).isEqualTo(2);
        assertThat(outcome.err().lines().filter(line -> !line.startsWith("read ")))
                .singleElement()
                .asString()
                .contains(message.replace("SRTM", SRTM).replace("MAP", MAP))
                .doesNotContain(".new-")
                .doesNotContain(".yaml");
        assertThat(left()).isEmpty();
    }

    /** A square house at 43.7384 N 7.4246 E, which EPSG:32632 has at 373139.3367, 4844024.1247 (PROJ 9.5.1). */
    private String house(double x, double y, double side) throws IOException {
        Path file = directory.resolve("house.geojson");
        Files.writeString(
                file,
                String.format(
                        Locale.ROOT,
                        "{\"type\": \"Feature\", \"properties\": {\"height\": 12}, \"geometry\": {\"type\": \"Polygon\","
                                + " \"coordinates\": [[[%1$s,%2$s],[%3$s,%2$s],[%3$s,%4$s],[%1$s,%4$s],[%1$s,%2$s]]]}}",
                        x,
                        y,
                        x + side,
                        y + side));
        return file.toString();
    }

    /** A system that is given is that of the files that do not state theirs, of maps, too, and of no other. */
    @Test
    void theGivenSystemReachesTheFilesThatNeedOne() throws IOException {
        String inGrid = house(373139.3367, 4844024.1247, 20.0);
        Outcome without = make("--at 43.7384,7.4246 --buildings " + inGrid);
        assertThat(without.code()).isEqualTo(2);
        assertThat(without.err())
                .contains("--buildings " + inGrid
                        + ": does not state a known coordinate reference system: add --crs, as in");
        Outcome with = make("--at 43.7384,7.4246 --crs EPSG:32632 --buildings " + inGrid);
        assertThat(with.code()).as(with.err()).isZero();
        assertThat(settings().world().buildings().orElseThrow().crs()).contains("EPSG:32632");
    }

    @Test
    void filesThatNeedNoSystemDoNotGetOne() throws IOException {
        String inDegrees = house(7.4246, 43.7384, 2e-4);
        Outcome mixed = make("--at 43.7384,7.4246 --crs EPSG:4326 --terrain " + SRTM + " --buildings " + inDegrees);
        assertThat(mixed.code()).as(mixed.err()).isZero();
        assertThat(mixed.err()).doesNotContain("has no effect");
        assertThat(settings().world().terrain().orElseThrow().crs()).contains("EPSG:4326");
        assertThat(settings().world().buildings().orElseThrow().crs()).isEmpty();
    }

    /** The place that the message suggests works; the house is 600 m away, too far for masts. */
    @Test
    void whereNothingIsNearAPlaceIsSuggested() throws IOException {
        String options = " --crs EPSG:32632 --buildings " + house(373139.3367 + 600.0, 4844024.1247, 20.0);
        Outcome far = make("--at 43.7384,7.4246" + options);
        assertThat(far.code()).isEqualTo(2);
        assertThat(far.err())
                .contains("there is neither ground nor a building for the sensors within 250 m of the origin");
        String place = far.err().strip().replaceFirst("(?s).* give --at ", "");
        assertThat(make("--at " + place + options).code()).isZero();
    }

    @Test
    void aSystemThatNoFileNeedsHasNoEffect() throws IOException {
        Outcome outcome = make("--at 43.7384,7.4246 --crs EPSG:32632 --buildings " + house(7.4246, 43.7384, 2e-4));
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.err())
                .contains(
                        "warning: --crs EPSG:32632 has no effect: all files state their coordinate reference systems");
    }

    /** A file whose code is not known needs --crs, and gets it. */
    @Test
    void theGivenSystemReplacesACodeThatIsNotKnown() throws IOException {
        TiffFixture grid = new TiffFixture(80, 80, new double[80 * 80]);
        grid.keys.put(3072, 9999);
        grid.tie = new double[] {0, 0, 0, 372_740, 4_844_424, 0};
        Path file = Files.write(directory.resolve("odd.tif"), grid.bytes());
        String options = "--at 43.7384,7.4246 --radius 300m --terrain " + file;
        Outcome without = make(options);
        assertThat(without.code()).isEqualTo(2);
        assertThat(without.err()).contains("does not state a known coordinate reference system: add --crs");
        Outcome with = make(options + " --crs EPSG:32632");
        assertThat(with.code()).as(with.err()).isZero();
        assertThat(with.err()).contains("states EPSG:9999").doesNotContain("has no effect");
        assertThat(settings().world().terrain().orElseThrow().crs()).contains("EPSG:32632");
    }

    /** Others can read what the command creates if they can read what its user creates elsewhere. */
    @Test
    void theDirectoryHasTheUsualPermissions() throws IOException {
        Path usual = Files.createDirectory(directory.resolve("usual"));
        assumeTrue(Files.getFileStore(usual).supportsFileAttributeView("posix"));
        Outcome outcome = make("--at 43.7384,7.4246 --buildings " + house(7.4246, 43.7384, 2e-4));
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(Files.getPosixFilePermissions(directory.resolve("town")))
                .isEqualTo(Files.getPosixFilePermissions(usual));
        assertThat(left()).containsExactlyInAnyOrder("usual", "house.geojson", "town");
    }

    /** A latitude that was meant in degrees is far from the data; the hint comes before what is then missing. */
    @Test
    void aLatitudeWithoutAUnitIsDoubtedThoughTheSiteDoesNotLoad() throws IOException {
        house(-78.48, -0.18, 2e-4);
        Path scene = directory.resolve("quito.yaml");
        Files.writeString(
                scene,
                """
                world:
                  origin: {latitude: -0.18, longitude: -78.48 deg, height: 0}
                  buildings: {file: house.geojson}
                sensors: {c: {kind: camera, position: [0, 0, 30]}}
                run: {duration: 2 s}
                """);
        for (String command : List.of("check", "run")) {
            Outcome outcome = Program.run(command, scene.toString());
            assertThat(outcome.code()).isEqualTo(2);
            assertThat(outcome.err())
                    .contains("has no building within")
                    .containsOnlyOnce(
                            "world.origin.latitude is -10.31324 deg (-0.18 rad); for degrees, write -0.18 deg");
        }
    }

    /** No powers of ten. */
    @Test
    void coordinatesAreWrittenAsAPersonWould() throws IOException {
        Outcome outcome = make("--at 0.0001,0.0001 --buildings " + house(0.0, 0.0, 2.0e-4));
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(Files.readString(directory.resolve("town/town.yaml")))
                .contains("latitude: 0.0001 deg, longitude: 0.0001 deg");
    }

    @Test
    void whatIsThereIsNotTouched() throws IOException {
        Files.createDirectory(directory.resolve("town"));
        Files.writeString(directory.resolve("town/notes.txt"), "mine");
        Outcome outcome = make("--at 43.7314,7.4202 --buildings " + MAP);
        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.err()).contains("is not empty: choose a new directory");
        assertThat(Files.readString(directory.resolve("town/notes.txt"))).isEqualTo("mine");
    }
}
