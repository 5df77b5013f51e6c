package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.acoustic.imagesource.ImageSourceCandidates;
import org.dronewatch.sensor.acoustic.imagesource.ImageSources;
import org.dronewatch.sensor.acoustic.imagesource.SpecularLeg;
import org.dronewatch.sensor.acoustic.imagesource.WallPlanes;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

class ImageSourcesTest {
    /** (), (4), (4 7), (4 7 4), (9). */
    private static final ImageSources IMAGES = new ImageSources(new int[] {0, 0, 1, 2, 0}, new int[] {0, 4, 7, 4, 9});

    private static SpecularLeg leg(int... walls) {
        SpecularLeg leg = new SpecularLeg();
        leg.begin(new AcousticRay());
        for (int wall : walls) {
            leg.reflect(wall);
        }
        return leg;
    }

    @Test
    void aLegIsKnownFromBothEnds() {
        assertThat(IMAGES.walls(3)).containsExactly(4, 7, 4);
        assertThat(leg(4, 7).matchesFromStart(IMAGES)).isTrue();
        assertThat(leg(7, 4).matchesFromStart(IMAGES)).isFalse();
        assertThat(leg(7, 4).matchesFromEnd(IMAGES)).isTrue();
        assertThat(leg(9).matchesFromEnd(IMAGES)).isTrue();
        assertThat(leg(9, 4).matchesFromStart(IMAGES)).isFalse();
        assertThat(IMAGES.contains(IMAGES.order(3), IMAGES.keyOfReverse(3))).isTrue();
        assertThat(IMAGES.contains(IMAGES.order(2), IMAGES.keyOfReverse(2))).isFalse();
    }

    @Test
    void withoutReflectionsOrThroughWallsALegMatchesNoImage() {
        assertThat(leg().matchesFromStart(IMAGES)).isFalse();
        SpecularLeg through = leg(4, 7);
        through.passThrough();
        assertThat(through.matchesFromStart(IMAGES)).isFalse();
    }

    @Test
    void theParentsOfAnImageAreKept() {
        ImageSources kept = IMAGES.kept(new boolean[] {false, false, true, false, false});
        assertThat(kept.count()).isEqualTo(3);
        assertThat(kept.walls(2)).containsExactly(4, 7);
        assertThat(ImageSources.of(4, 7).walls(2)).containsExactly(4, 7);
    }

    @Test
    void theBestImagesAreKeptWithTheirParents() {
        ImageSourceCandidates tree = new ImageSourceCandidates();
        tree.add(new int[] {1, 2}, 0.5);
        tree.add(new int[] {1, 3}, 0.2);
        tree.add(new int[] {5}, 0.1);
        tree.add(new int[] {5}, 0.3);
        assertThat(tree.worth(new int[] {1})).isCloseTo(0.7, within(1e-12));
        assertThat(tree.worth(new int[] {8})).isZero();
        assertThat(tree.firstWalls(1)).containsExactly(1);
        assertThat(tree.firstWalls(9)).containsExactly(1, 5);
        ImageSources best = tree.best(4, 0.35);
        assertThat(best.count()).isEqualTo(4);
        assertThat(best.contains(2, ImageSources.appended(ImageSources.appended(0, 1), 3)))
                .isFalse();
    }

    /** All ways to connect a path count once together. */
    @Test
    void theWeightsOfAllConnectionsAreOne() {
        double[] legs = {
            Connections.fromPoint(0.5, 3), Connections.betweenSurfaces(0.2, 0.9, 7), Connections.fromPoint(1, 0.1)
        };
        double all = legs[0] + legs[1] + legs[2];
        double sum = 0;
        for (double leg : legs) {
            sum += Connections.weight(leg, all - leg);
        }
        assertThat(sum).isCloseTo(1, within(1e-12));
    }

    /** Triangles of one plane are one wall, whatever their winding and material; those of another are not. */
    @Test
    void coplanarTrianglesAreOneWall() {
        World room = Sites.world(
                World.merge(List.of(
                        Sites.room(10, 8, 4), Sites.wall(2, 0, 20, 30, 0, 8), Sites.wall(2, 0.01, 40, 50, 0, 8))),
                SurfaceMaterial.uniform("wall", 0.1, 0));
        WallPlanes planes = new WallPlanes(room.mesh(), new BandSurfaces(room.surfaces()));
        assertThat(planes.count()).isEqualTo(7);
        int floor = planes.wallOf(12);
        assertThat(planes.wallOf(13)).isEqualTo(floor);
        assertThat(Math.abs(planes.height(floor, 3, 3, 2.5))).isCloseTo(2.5, within(1e-9));
        assertThat(planes.wallOf(14)).isNotEqualTo(floor);
        Position image = image(planes, floor, new Position(1, 2, 3));
        assertThat(image.z()).isCloseTo(-3, within(1e-9));
    }

    /** What reflects nothing specularly is no wall. */
    @Test
    void whatOnlyScattersIsNoWall() {
        World room = Sites.world(Sites.room(10, 8, 4), SurfaceMaterial.uniform("wall", 0.1, 1));
        WallPlanes planes = new WallPlanes(room.mesh(), new BandSurfaces(room.surfaces()));
        assertThat(planes.count()).isZero();
        assertThat(planes.wallOf(0)).isEqualTo(WallPlanes.NONE);
    }

    private static Position image(WallPlanes planes, int wall, Position of) {
        double[] images = new double[3];
        planes.mirror(wall, new double[] {of.x(), of.y(), of.z()}, 0, images, 0);
        return new Position(images[0], images[1], images[2]);
    }
}
