package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.buildings.BuildingSettings;
import org.dronewatch.buildings.OsmHouse;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.render.Fineness;
import org.dronewatch.render.Orbit;
import org.dronewatch.render.RayFilter;
import org.dronewatch.render.SitePicture;
import org.dronewatch.render.SiteState;
import org.dronewatch.render.SiteStyle;
import org.dronewatch.run.Stage;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.world.Obstacle;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Scenes whose buildings come from a map, as a user writes and runs them. */
class BuildingSceneTest {
    private static final String SITE =
            """
            world:
              origin: {latitude: 50.0 deg, longitude: 15.0 deg, height: 200 m}
              terrain: {file: ground.asc, crs: EPSG:32633, accuracy: 0}
              buildings: {file: map.osm}
            """;

    @TempDir
    private Path directory;

    /**
     * Level ground at 200 m, and two houses of some 14 m x 11 m: one 40 m to the north, one without a height beyond it.
     */
    @BeforeEach
    void writeSite() throws IOException {
        StringBuilder text =
                new StringBuilder("ncols 3\nnrows 3\nxllcenter 499800\nyllcenter 5538430.74\ncellsize 200\n");
        text.append("200 200 200\n".repeat(3));
        Files.writeString(directory.resolve("ground.asc"), text);
        Files.writeString(
                directory.resolve("map.osm"),
                "<osm>"
                        + OsmHouse.text(
                                10, 50.0004, "<tag k='height' v='12'/><tag k='building:material' v='concrete'/>")
                        + OsmHouse.text(20, 50.0008, "") + "</osm>");
    }

    private Path scene(String text) throws IOException {
        return Files.writeString(directory.resolve("site.yaml"), text);
    }

    @Test
    void eachHouseHidesAsWhatItIs() throws IOException {
        List<String> notes = new ArrayList<>();
        SceneRunner runner = new SceneRunner(new SceneFile(scene(SITE))).notes(notes::add);
        World world = runner.stage(runner.settings()).world();
        Visibility visibility = new Visibility(world);

        Obstacle near = visibility
                .obstacle(new Position(0, 0, 5), new Position(0, 70, 5))
                .orElseThrow();
        assertThat(near.model().role()).isEqualTo(ModelRole.BUILDING);
        assertThat(near.model().file()).isEqualTo("map.osm");
        assertThat(near.material()).isEqualTo("concrete_smooth");
        Obstacle far = visibility
                .obstacle(new Position(0, 70, 5), new Position(0, 120, 5))
                .orElseThrow();
        assertThat(far.material()).isEqualTo("brick_rendered:assumed-height");
        Obstacle ground = visibility
                .obstacle(new Position(0, 0, 5), new Position(0, 30, -5))
                .orElseThrow();
        assertThat(ground.model().role()).isEqualTo(ModelRole.TERRAIN);
        assertThat(visibility.isFree(0, 0, 12.1, 0, 150, 12.1)).isTrue();
        assertThat(visibility.isFree(0, 0, 11.9, 0, 150, 11.9)).isFalse();
        assertThat(world.surfaces())
                .extracting(surface -> surface.name())
                .containsExactly("pasture_uncompacted", "concrete_smooth", "brick_rendered");
        assertThat(notes)
                .contains("buildings: 24 triangles; heights: 1 stated, 0 from levels of 3 m, 1 assumed to be 9 m")
                .noneMatch(line -> line.startsWith("warning"));
    }

    /** The drone hovers behind the nearer house, and the report says so by the name that the house has on the map. */
    @Test
    void theReportNamesTheBuildingThatHidesADrone() throws IOException {
        Files.writeString(
                directory.resolve("map.osm"),
                "<osm>" + OsmHouse.text(10, 50.0004, "<tag k='height' v='12'/><tag k='name' v='Town hall'/>")
                        + OsmHouse.text(20, 50.0008, "") + "</osm>");
        Path file = scene(SITE
                + "drones: {one: {model: packaged:quadrotor.obj, flight: {kind: hover, position: [0, 70, 5]}}}\n"
                + "sensors: {radar: {kind: radar, position: [0, 0, 5], minSpeed: 0, budget: {range: 500, crossSection: 0.01}}}\n"
                + "run: {duration: 2 s}\n");

        Outcome outcome = Program.run(
                "run", file.toString(), "--out", directory.resolve("out").toString());

        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(directory.resolve("out").resolve("report.html"))
                .content()
                .contains("hidden by map.osm ('Town hall'; brick_rendered)");
    }

    /** In each picture of the site, in the lower right corner; GeoJSON states no licence. */
    @Test
    void picturesShowTheCreditsOfTheirData() throws IOException {
        assertThat(picture(SITE).credits()).containsExactly("© OpenStreetMap contributors");
        String stated = SITE.replace("accuracy: 0", "accuracy: 0, attribution: heights of the survey");
        Pictured both = picture(stated);
        assertThat(both.credits()).containsExactly("© OpenStreetMap contributors", "heights of the survey");
        Files.writeString(
                directory.resolve("map.geojson"),
                "{\"type\":\"Polygon\",\"coordinates\":[[[15,50.0004],[15.0002,50.0004],[15.0002,50.0005],[15,50.0004]]]}");
        Pictured none = picture(SITE.replace("map.osm", "map.geojson"));
        assertThat(none.credits()).isEmpty();
        assertThat(inkInCorner(none.image())).isZero();
        assertThat(inkInCorner(both.image()))
                .isGreaterThan(inkInCorner(picture(SITE).image()));
        assertThat(inkInCorner(picture(SITE).image())).isGreaterThan(100);
        assertThat(picture(SITE.replace("ground.asc", "Copernicus_DSM.asc")).credits())
                .hasSize(2)
                .anyMatch(credit -> credit.startsWith("produced using Copernicus WorldDEM-30"));
    }

    private record Pictured(List<String> credits, BufferedImage image) {}

    private Pictured picture(String text) throws IOException {
        Files.copy(
                directory.resolve("ground.asc"),
                directory.resolve("Copernicus_DSM.asc"),
                StandardCopyOption.REPLACE_EXISTING);
        SceneRunner runner = new SceneRunner(new SceneFile(scene(text))).notes(note -> {});
        Stage stage = runner.stage(runner.settings());
        SitePicture picture = new SitePicture(runner.settings(), stage);
        Orbit above = new Orbit(new Position(0, 0, 0), 0.0, 1.5, 300, 0.6);
        SiteState state = new SiteState("site", 0.0, List.of(), List.of(), Optional.empty(), Optional.empty());
        return new Pictured(
                stage.credits(),
                picture.draw(
                        picture.backdrop(above, 600, 400, Optional.empty(), Fineness.COARSE, () -> false),
                        state,
                        new SiteStyle(1.0, false, false, false, RayFilter.ALL)));
    }

    /** Pixels as dark as text. */
    private static int inkInCorner(BufferedImage image) {
        int ink = 0;
        for (int x = 380; x < 590; x++) {
            for (int y = 320; y < 390; y++) {
                Color colour = new Color(image.getRGB(x, y));
                ink += Math.max(colour.getRed(), Math.max(colour.getGreen(), colour.getBlue())) < 0x60 ? 1 : 0;
            }
        }
        return ink;
    }

    @Test
    void aWoodHidesAsVegetation() throws IOException {
        Files.writeString(
                directory.resolve("map.osm"),
                "<osm>" + OsmHouse.text(10, 50.0004, "").replace("building' v='yes", "natural' v='wood") + "</osm>");
        SceneRunner runner =
                new SceneRunner(new SceneFile(scene(SITE.replace("map.osm", "map.osm, woodHeight: 20 m"))));
        World world = runner.stage(runner.settings()).world();
        Obstacle wood = new Visibility(world)
                .obstacle(new Position(0, 0, 15), new Position(0, 70, 15))
                .orElseThrow();
        assertThat(wood.model().role()).isEqualTo(ModelRole.VEGETATION);
        assertThat(wood.material()).isEqualTo("foliage_edge");
    }

    /** The report names the map, its hash is in the result, and a saved scene finds it again. */
    @Test
    void aRunRecordsTheMap() throws IOException {
        Path scene = scene(
                SITE
                        + """
                drones:
                  visitor: {model: packaged:quadrotor.obj, flight: {kind: hover, position: [0, 75, 4]}}
                sensors:
                  eye: {kind: camera, position: [0, 20, 4], width: 320, height: 200}
                run: {duration: 1 s}
                """);
        Outcome run = Program.run(
                "run", scene.toString(), "--out", directory.resolve("out").toString());
        assertThat(run.code()).as(run.err()).isZero();
        assertThat(Files.readString(directory.resolve("out/provenance.json"))).contains("map.osm");
        assertThat(Files.readString(directory.resolve("out/report.html")))
                .contains("read map.osm: OpenStreetMap XML, 2 buildings")
                .contains("1 stated, 0 from levels of 3 m, 1 assumed to be 9 m")
                .contains("(c) OpenStreetMap contributors, Open Database License");
        Outcome saved = Program.run(
                "save",
                scene.toString(),
                "--out",
                directory.resolve("saved.yaml").toString());
        assertThat(saved.code()).as(saved.err()).isZero();
        assertThat(new SceneRunner(new SceneFile(directory.resolve("saved.yaml")))
                        .settings()
                        .world()
                        .buildings())
                .contains(BuildingSettings.of("map.osm"));
    }

    @Test
    void aSceneInJavaHasBuildingsToo() throws IOException {
        BuildingSettings houses =
                BuildingSettings.of(directory.resolve("map.osm").toString());
        Scene scene = new Scene() {
            @Override
            protected void build() {
                loadBuildings(houses);
                setOrigin(Origin.at(Math.toRadians(50.0), Math.toRadians(15.0)));
            }
        };
        SceneRunner runner = new SceneRunner(scene);
        World world = runner.stage(runner.settings()).world();
        assertThat(world.mesh().triangleCount()).isEqualTo(24);
        assertThat(world.surfaceHeight(0.0, 50.0).orElseThrow()).isBetween(11.99, 12.0);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "origin=null | world.buildings needs a world.origin",
                "buildings={} | world.buildings needs a 'file', a map with buildings",
                "buildings={file: none.osm} | site.yaml:4:21: world.buildings.file: file 'none.osm' does not exist",
                "buildings={file: ground.asc} | ground.asc: is an ESRI ASCII grid, which belongs under world.terrain, not under world.buildings",
                "buildings={file: ../map.osm} | file '../map.osm' must be a relative path to a file in",
                "buildings={file: map.osm, height: 0} | height",
                "buildings={file: map.osm, crs: EPSG:1} | EPSG",
                "buildings={file: map.osm, radius: 10 m} | map.osm: has no building within 10 m of the origin",
            })
    void whatIsWrongIsOneLine(String change, String message) throws IOException {
        String[] pair = change.split("=", 2);
        String text = SITE.replaceFirst(
                "(?m)^  " + pair[0] + ": .*\n", pair[1].equals("null") ? "" : "  " + pair[0] + ": " + pair[1] + "\n");
        if (pair[0].equals("origin")) {
            text = text.replaceFirst("(?m)^  terrain: .*\n", "");
        }
        Outcome outcome = Program.run("check", scene(text).toString());
        assertThat(outcome.code()).as(outcome.err()).isEqualTo(2);
        assertThat(outcome.err().lines().filter(line -> !line.startsWith("read ") && !line.startsWith("terrain:")))
                .singleElement()
                .asString()
                .contains(message);
    }
}
