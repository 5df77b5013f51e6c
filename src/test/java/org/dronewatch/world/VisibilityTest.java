package org.dronewatch.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.mesh.io.ModelSettings;
import org.junit.jupiter.api.Test;

class VisibilityTest {
    /** A square wall across the way to the north, 20 m wide and high, of two triangles. */
    private static TriangleMesh wall(float north, String material) {
        return new TriangleMesh(
                new float[] {-10, north, -10, 10, north, -10, 10, north, 10, -10, north, 10},
                new int[] {0, 1, 2, 0, 2, 3},
                new int[] {0, 0},
                new int[] {0, 1},
                List.of(material));
    }

    private static World world() {
        TriangleMesh mesh = World.merge(List.of(wall(30, "leaves"), wall(20, "brick"), wall(40, "rock")));
        return World.of(mesh)
                .withModels(new TreeMap<>(Map.of(
                        0, new SiteModel("trees.obj", ModelRole.VEGETATION),
                        2, new SiteModel("house.obj", ModelRole.BUILDING),
                        4, SiteModel.of(ModelSettings.packaged("hill.obj")))));
    }

    @Test
    void theObstacleIsTheFirstThatTheLineMeetsSeenFromItsBeginning() {
        Visibility visibility = new Visibility(world());
        Position south = new Position(1, 0, 2);
        Position north = new Position(1, 50, 2);

        assertThat(visibility.obstacle(south, north))
                .contains(new Obstacle(new SiteModel("house.obj", ModelRole.BUILDING), "brick"));
        assertThat(visibility.obstacle(north, south))
                .contains(new Obstacle(new SiteModel("hill.obj", ModelRole.TERRAIN), "rock"));
        assertThat(visibility.obstacle(new Position(1, 25, 2), new Position(1, 35, 2)))
                .contains(new Obstacle(new SiteModel("trees.obj", ModelRole.VEGETATION), "leaves"));
    }

    @Test
    void nothingStandsBesideTheWallsOrBetweenThem() {
        Visibility visibility = new Visibility(world());

        assertThat(visibility.obstacle(new Position(11, 0, 0), new Position(11, 50, 0)))
                .isEmpty();
        assertThat(visibility.isFree(new Position(11, 0, 0), new Position(11, 50, 0)))
                .isTrue();
        assertThat(visibility.isFree(new Position(0, 21, 0), new Position(0, 29, 0)))
                .isTrue();
        assertThat(visibility.isFree(new Position(0, 19, 0), new Position(0, 21, 0)))
                .isFalse();
    }

    @Test
    void thePackagedHillIsTerrainAndAllElseABuildingUnlessItSaysOtherwise() {
        assertThat(ModelSettings.packaged("hill.obj").role()).isEqualTo(ModelRole.TERRAIN);
        assertThat(ModelSettings.packaged("house.obj").role()).isEqualTo(ModelRole.BUILDING);
        assertThat(ModelSettings.of("hill.obj").role()).isEqualTo(ModelRole.BUILDING);
        assertThat(ModelSettings.of("oak.obj").withRole(ModelRole.VEGETATION).role())
                .isEqualTo(ModelRole.VEGETATION);
    }

    @Test
    void aWorldThatKnowsNoModelsTakesAllForOneBuildingWithoutAFile() {
        World bare = World.of(wall(20, "brick"));

        assertThat(bare.obstacle(1)).isEqualTo(new Obstacle(new SiteModel("", ModelRole.BUILDING), "brick"));
        assertThatThrownBy(() -> bare.withModels(new TreeMap<>(Map.of(1, SiteModel.UNNAMED))))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("triangle 0");
    }
}
