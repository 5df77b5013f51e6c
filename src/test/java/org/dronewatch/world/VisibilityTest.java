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
    void whatCountsAtTheEndsIsALengthAndNotAPartOfTheRange() {
        Visibility visibility = new Visibility(world());
        for (double range = 1e-3; range < 5.0; range *= 2.0) {
            for (int side = -1; side <= 1; side += 2) {
                Position far = new Position(1, 20 + side * range, 2);
                Position on = new Position(1, 20 - side * 0.5 * Visibility.MARGIN, 2);
                Position behind = new Position(1, 20 - side * 2.0 * Visibility.MARGIN, 2);

                assertThat(visibility.isFree(on, far))
                        .as("on the wall, %s m", range)
                        .isTrue();
                assertThat(visibility.isFree(far, on))
                        .as("on the wall, %s m", range)
                        .isTrue();
                assertThat(visibility.isFree(behind, far))
                        .as("behind it, %s m", range)
                        .isFalse();
                assertThat(visibility.isFree(far, behind))
                        .as("behind it, %s m", range)
                        .isFalse();
            }
        }
    }

    /** 12.3 m is 12.3000002 m in single precision: a sensor that is put there lies behind the wall. */
    @Test
    void aSensorOnAWallSeesAtAnyRange() {
        Visibility visibility = new Visibility(World.of(wall(12.3f, "brick")));
        Position sensor = new Position(1, 12.3, 2);
        for (double range = 0.1; range < 1e5; range *= 1.7) {
            assertThat(visibility.isFree(sensor, new Position(1, 12.3 + range, 2)))
                    .as("range %s m", range)
                    .isTrue();
        }
    }

    @Test
    void anOffsetFromASurfaceIsEnoughToBeHiddenByIt() {
        World world = World.of(wall(12.3f, "brick"));
        Position microphone = new Clearance(world).of(new Position(1, 12.3, 2));

        assertThat(new Visibility(world).isFree(microphone, new Position(1, 0, 2)))
                .isNotEqualTo(new Visibility(world).isFree(microphone, new Position(1, 50, 2)));
    }

    @Test
    void surfacesAreFoundOneAfterTheOther() {
        Visibility visibility = new Visibility(world());

        assertThat(visibility.findFirstAlong(1, 0, 2, 0, 50, 0, 1.0)).isTrue();
        assertThat(visibility.triangle()).isIn(2, 3);
        assertThat(visibility.findNext()).isTrue();
        assertThat(visibility.triangle()).isIn(0, 1);
        assertThat(visibility.findNext()).isTrue();
        assertThat(visibility.triangle()).isIn(4, 5);
        assertThat(visibility.findNext()).isFalse();
        assertThat(visibility.findFirstAlong(1, 0, 2, 0, 50, 0, 0.3)).isFalse();
        assertThat(visibility.findFirstAlong(1, 0, 2, 0, 1, 0, Double.POSITIVE_INFINITY))
                .isTrue();
        assertThat(visibility.isFreeAlong(1, 41, 2, 0, 1, 0, Double.POSITIVE_INFINITY))
                .isTrue();
        assertThat(visibility.isFreeAlong(1, 39, 2, 0, 1, 0, Double.POSITIVE_INFINITY))
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
