package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.flight.TerrainFollowing;
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.InputException;
import org.dronewatch.world.GroundPoint;
import org.dronewatch.world.World;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Scenes whose positions are given by latitude and longitude, or above the surface. */
class PlacedSceneTest {
    private static final String SITE =
            """
            world:
              origin: {latitude: 50.0 deg, longitude: 15.0 deg, height: 200 m}
              terrain: {file: ground.asc, crs: EPSG:32633, accuracy: 0}
              noiseSources: {pump: {positions: [{east: 50.02, north: 0, above: 1 m}], soundPowerLevel: 90}}
            drones:
              one:
                model: packaged:quadrotor.obj
                flight: {kind: waypoints, points: [{latitude: 50.0005 deg, longitude: 15.0 deg, above: 40 m}, [0, 0, 50]]}
              two:
                model: packaged:quadrotor.obj
                flight:
                  kind: terrain-following
                  points: [{latitude: 50.0005 deg, longitude: 15.0 deg}, [0, 0]]
                  height: 5 m
            sensors:
              eye:
                kind: camera
                position: {east: 50.02, north: 10, above: 2 m}
                aim: {lookAt: {latitude: 50.0 deg, longitude: 15.0 deg, height: 230 m}}
            alert: {protect: {centre: {latitude: 50.0 deg, longitude: 15.0 deg}}}
            """;

    @TempDir
    private Path directory;

    /**
     * A wall 20 m high runs north to south 50.02 m east of the origin, on ground at 200 m; a post in the north-west has
     * no height.
     */
    @BeforeEach
    void writeGround() throws IOException {
        StringBuilder text = new StringBuilder(
                "ncols 41\nnrows 41\nxllcenter 499900\nyllcenter 5538530.74\ncellsize 5\nNODATA_value -9999\n");
        for (int row = 0; row < 41; row++) {
            for (int column = 0; column < 41; column++) {
                text.append(column == 30 ? "220 " : row == 5 && column == 5 ? "-9999 " : "200 ");
            }
            text.append('\n');
        }
        Files.writeString(directory.resolve("ground.asc"), text);
    }

    private SceneRunner runner(String text) throws IOException {
        return new SceneRunner(new SceneFile(Files.writeString(directory.resolve("site.yaml"), text)));
    }

    private String refusal(String text, String... overrides) throws IOException {
        SceneRunner runner = runner(text);
        for (String override : overrides) {
            runner.set(override.split("=")[0], override.split("=")[1]);
        }
        try {
            runner.settings();
            return "";
        } catch (InputException e) {
            return e.getMessage().replace(directory.toString(), "DIR");
        }
    }

    /** The wall is steep: 2 mm, by which the grid's scale moves it, are 8 mm in height. */
    private static void assertNear(Position position, double x, double y, double z) {
        assertThat(position.distance(new Position(x, y, z))).as("%s", position).isLessThan(1e-2);
    }

    @Test
    void everyPositionMayBeAPlace() throws IOException {
        SceneSettings settings = runner(SITE).settings();
        assertNear(settings.sensors().get("eye").position(), 50.02, 10, 22);
        assertNear(settings.world().noiseSources().get("pump").positions().get(0), 50.02, 0, 21);
        assertNear(settings.alert().protect().orElseThrow().centre(), 0, 0, 0);
        FlightPathSettings.Waypoints one =
                (FlightPathSettings.Waypoints) settings.drones().get("one").flight();
        // 111,229 m for a degree of latitude at 50 degrees.
        assertNear(one.points().get(0), 0, 55.6146, 40);
        assertNear(one.points().get(1), 0, 0, 50);
        TerrainFollowing two = (TerrainFollowing) settings.drones().get("two").flight();
        assertNear(new Position(two.points().get(0).x(), two.points().get(0).y(), 0), 0, 55.6146, 0);
    }

    @Test
    void aPointInPlanMayNameItsCoordinates() throws IOException {
        String named =
                SITE.replace("{latitude: 50.0005 deg, longitude: 15.0 deg}, [0, 0]", "{east: 3, north: 40}, [0, 0]");
        TerrainFollowing two =
                (TerrainFollowing) runner(named).settings().drones().get("two").flight();
        assertThat(two.points().get(0)).isEqualTo(new GroundPoint(3, 40));
        assertThat(refusal(named.replace("north: 40}", "north: 40, above: 3 m}")))
                .contains("points.0: unknown setting 'above'")
                .hasLineCount(1);
    }

    /** Overrides of the site move what stands on it. */
    @Test
    void theyStandOnTheSiteAsItIsOverridden() throws IOException {
        SceneSettings lower = runner(SITE).set("world.origin.height", "150 m").settings();
        assertNear(lower.sensors().get("eye").position(), 50.02, 10, 72);
        SceneSettings north =
                runner(SITE).set("world.origin.latitude", "50.0002 deg").settings();
        assertNear(north.alert().protect().orElseThrow().centre(), 0, -22.2458, 0);
        SceneSettings raised =
                runner(SITE).set("world.terrain.verticalOffset", "7 m").settings();
        assertNear(raised.alert().protect().orElseThrow().centre(), 0, 0, 7);
    }

    /** What was loaded for the places is the site of the run. */
    @Test
    void theSiteIsReadOnce() throws IOException {
        List<String> notes = new ArrayList<>();
        SceneRunner runner = runner(SITE).notes(notes::add);
        World world = runner.stage(runner.settings()).world();
        runner.settings();
        assertThat(world.surfaceHeight(50.02, 10).orElseThrow()).isBetween(19.99, 20.01);
        assertThat(notes).filteredOn(line -> line.startsWith("read ground.asc")).hasSize(1);
        assertThat(runner.inputs().models()).containsKey("ground.asc");
    }

    /** Saved scenes have numbers, and run alike. */
    @Test
    void aSavedSceneHasTheSamePositions() throws IOException {
        SceneRunner runner = runner(SITE);
        SceneSettings settings = runner.settings();
        Path saved = directory.resolve("saved.yaml");
        Files.writeString(saved, runner.text(settings, saved));
        assertThat(new SceneRunner(new SceneFile(saved)).settings()).isEqualTo(settings);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "{east: 50.02, north: 10, above: 2 m} | {east: -75, north: 75, above: 2 m} | site.yaml:18:15: sensors.eye.position: no"
                        + " surface at east -75.0 m, north 75.0 m: the site has a hole or ends there",
                "longitude: 15.0 deg, above: 40 m | longitude: 15.1 deg, above: 40 m | site.yaml:8:40: drones.one.flight.points.0:"
                        + " no surface at latitude 50.000500 deg, longitude 15.100000 deg",
                "above: 40 m | above: -1 m | site.yaml:8:92: drones.one.flight.points.0.above: above -1 m must be 0 to 100000",
                "above: 40 m | above: 40 m, height: 3 | omit one of them",
                "above: 40 m | abvoe: 40 m | unknown setting 'abvoe'; did you mean 'above'?",
                "longitude: 15.0 deg, above: 40 m | lon: 15, above: 40 m | needs 'longitude'",
                "accuracy: 0 | accuracy: -1 | site.yaml:3:58: world.terrain.accuracy",
                "file: ground.asc | file: other.asc | world.terrain.file: file 'other.asc' does not exist",
            })
    void mistakesHaveTheirPlace(String old, String wrong, String message) throws IOException {
        assertThat(SITE).contains(old);
        assertThat(refusal(SITE.replace(old, wrong)).replace("DIR/", "")).contains(message);
    }

    @Test
    void theSiteMustBeKnownAndOne() throws IOException {
        String models = SITE.replaceFirst(" {2}terrain:.*", "  models: [packaged:hill.obj]");
        assertThat(refusal(models.replaceFirst(" {2}origin:.*\n", "")))
                .contains("sensors.eye.aim.lookAt: needs a world.origin");
        assertThat(refusal(models.replace(", height: 200 m", "")))
                .contains("sensors.eye.aim.lookAt: height 230.0 m above sea level has no meaning");
        assertThat(refusal(SITE.replaceFirst(" {2}origin:.*\n", "")).lines())
                .singleElement()
                .asString()
                .contains("world.terrain needs a world.origin");
        assertThat(
                        refusal(
                                SITE.replaceFirst(
                                        " {2}noiseSources",
                                        "  models: [{file: packaged:hill.obj, position: {latitude: 50 deg, longitude: 15 deg}}]\n  noiseSources")))
                .contains("world.models.0.position: must be numbers: x, y, z");
        assertThat(refusal(SITE + "sweep: {parameter: world.origin.height, values: [200 m, 210 m]}\n"))
                .contains("site.yaml:21:20: sweep.parameter: 'world.origin.height' cannot be swept");
        assertThat(refusal(SITE + "sweep: {parameter: world.rain, values: [0, 10]}\n"))
                .isEmpty();
        Files.writeString(directory.resolve("ground.asc"), "ncols 41\n");
        assertThat(refusal(SITE).lines())
                .singleElement()
                .asString()
                .startsWith("DIR/site.yaml:3:12: world.terrain: ground.asc");
        assertThatThrownBy(
                        () -> runner(SITE).set("world.terrain.accuracy", "-1").settings())
                .isInstanceOf(InputException.class);
    }

    /** Names of a map next to the scene file, with its name or another. */
    @Test
    void placesHaveNamesOnAMap() throws IOException {
        String map =
                "{\"type\": \"FeatureCollection\", \"features\": [{\"type\": \"Feature\", \"properties\": {\"name\": \"gate\"},"
                        + " \"geometry\": {\"type\": \"Point\", \"coordinates\": [15.0, 50.0005]}}]}";
        Files.writeString(directory.resolve("other.geojson"), map);
        String named = SITE.replace(
                        "{east: 50.02, north: 10, above: 2 m}", "{feature: gate, file: other.geojson, above: 2 m}")
                .replace(
                        "{latitude: 50.0005 deg, longitude: 15.0 deg}, [0, 0]",
                        "{feature: gate, file: other.geojson}, [0, 0]");
        SceneFile scene = new SceneFile(Files.writeString(directory.resolve("site.yaml"), named));
        SceneRunner runner = new SceneRunner(scene);
        SceneSettings settings = runner.settings();
        assertNear(settings.sensors().get("eye").position(), 0, 55.6146, 2);
        TerrainFollowing two = (TerrainFollowing) settings.drones().get("two").flight();
        assertNear(new Position(two.points().get(0).x(), two.points().get(0).y(), 0), 0, 55.6146, 0);
        assertThat(runner.inputs().scene())
                .extracting(file -> file.file())
                .containsExactly("site.yaml", "other.geojson");
        assertNear(
                runner.place("--at", "{feature: gate, file: other.geojson, height: 210 m}", settings), 0, 55.6146, 10);

        String own = named.replace(", file: other.geojson", "");
        assertThat(refusal(own))
                .contains("site.yaml:18:15: sensors.eye.position: neither site.geojson nor site.kml is next to"
                        + " the scene file: give 'file'");
        Files.writeString(directory.resolve("site.geojson"), map);
        assertThat(refusal(own)).isEmpty();
        assertThat(refusal(own.replace("feature: gate, above", "feature: gaet, above")))
                .contains("sensors.eye.position: feature 'gaet': there is none in site.geojson; closest match: gate");
        assertThat(refusal(named.replace("other.geojson, above", "../other.geojson, above")))
                .contains("must be a relative path to a file in the directory of this file");
        Files.writeString(directory.resolve("site.geojson"), "{");
        assertThat(refusal(own)).contains("site.geojson:1: not valid JSON");
    }
}
