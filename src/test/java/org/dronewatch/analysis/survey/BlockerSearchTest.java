package org.dronewatch.analysis.survey;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.dronewatch.buildings.BuildingOutline;
import org.dronewatch.buildings.OsmHouse;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.Stage;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.world.Obstacle;
import org.dronewatch.world.Visibility;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Which building of a map hides a drone: two houses of some 11 x 14 m, 44 and 89 m north of the origin. */
class BlockerSearchTest {
    @TempDir
    private static Path directory;

    private static Stage stage;

    @BeforeAll
    static void build() throws IOException {
        Files.writeString(
                directory.resolve("ground.asc"),
                "ncols 3\nnrows 3\nxllcenter 499800\nyllcenter 5538430.74\ncellsize 200\n" + "200 200 200\n".repeat(3));
        Files.writeString(
                directory.resolve("map.osm"),
                "<osm>" + OsmHouse.text(10, 50.0004, "<tag k='name' v='Depot'/><tag k='height' v='12'/>")
                        + OsmHouse.text(20, 50.0008, "<tag k='height' v='20'/>") + "</osm>");
        Path file = Files.writeString(
                directory.resolve("site.yaml"),
                """
                world:
                  origin: {latitude: 50.0 deg, longitude: 15.0 deg, height: 200 m}
                  terrain: {file: ground.asc, crs: EPSG:32633, accuracy: 0}
                  buildings: {file: map.osm}
                drones:
                  one: {model: packaged:quadrotor.obj, flight: {kind: hover, position: [10, 10, 12]}}
                sensors:
                  radio: {kind: rf, position: [0, 0, 10]}
                """);
        SceneRunner runner = new SceneRunner(new SceneFile(file));
        stage = runner.stage(runner.settings());
    }

    private static Optional<BuildingOutline> between(Position sensor, Position drone) {
        Obstacle named = new Visibility(stage.world()).obstacle(sensor, drone).orElseThrow();
        Blocker blocker = new BlockerSearch(stage).between(sensor, drone, named);
        assertThat(blocker.obstacle()).isEqualTo(named);
        return blocker.building();
    }

    @Test
    void theFirstBuildingOnTheLineIsNamed() {
        Position south = new Position(0, -20, 3);
        Position between = new Position(0, 70, 3);
        Position north = new Position(0, 150, 3);
        assertThat(between(south, north).flatMap(BuildingOutline::name)).hasValue("Depot");
        assertThat(between(between, south).flatMap(BuildingOutline::name)).hasValue("Depot");
        assertThat(between(between, north)).hasValueSatisfying(house -> {
            assertThat(house.name()).isEmpty();
            assertThat(house.id()).contains("20");
        });
        assertThat(between(new Position(0, -20, 16), new Position(0, 150, 10)))
                .as("over the lower house")
                .hasValueSatisfying(house -> assertThat(house.id()).contains("20"));
    }

    /** Straight down onto a roof, there is nothing behind it in plan view. */
    @Test
    void aRoofIsNamedFromAbove() {
        assertThat(between(new Position(0, 50, 40), new Position(0, 50, 1)).flatMap(BuildingOutline::name))
                .hasValue("Depot");
    }

    /** The ground is not a building; and an assessment may name what is not on the line to the drone's origin. */
    @Test
    void whatIsNoBuildingHasNoName() {
        assertThat(between(new Position(60, 0, 3), new Position(60, 10, -3))).isEmpty();
        Position west = new Position(-60, 50, 3);
        Obstacle depot = new Visibility(stage.world())
                .obstacle(west, new Position(60, 50, 3))
                .orElseThrow();
        Blocker beside = new BlockerSearch(stage).between(west, new Position(-60, 80, 3), depot);
        assertThat(beside).isEqualTo(new Blocker(depot, Optional.empty()));
    }
}
