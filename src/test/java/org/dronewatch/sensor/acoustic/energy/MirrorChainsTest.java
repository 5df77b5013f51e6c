package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.acoustic.mirror.ChainTree;
import org.dronewatch.sensor.acoustic.mirror.MirrorChains;
import org.dronewatch.sensor.acoustic.mirror.MirrorRun;
import org.dronewatch.sensor.acoustic.mirror.WallPlanes;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sound.SurfaceMaterial;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

class MirrorChainsTest {
    /** (), (4), (4 7), (4 7 4), (9). */
    private static final MirrorChains CHAINS = new MirrorChains(new int[] {0, 0, 1, 2, 0}, new int[] {0, 4, 7, 4, 9});

    private static MirrorRun run(int... walls) {
        MirrorRun run = new MirrorRun();
        run.begin(new AcousticRay());
        for (int wall : walls) {
            run.reflect(wall);
        }
        return run;
    }

    @Test
    void aRunIsKnownFromBothEnds() {
        assertThat(CHAINS.walls(3)).containsExactly(4, 7, 4);
        assertThat(run(4, 7).isChainFrom(CHAINS)).isTrue();
        assertThat(run(7, 4).isChainFrom(CHAINS)).isFalse();
        assertThat(run(7, 4).isChainTo(CHAINS)).isTrue();
        assertThat(run(9).isChainTo(CHAINS)).isTrue();
        assertThat(run(9, 4).isChainFrom(CHAINS)).isFalse();
        assertThat(CHAINS.contains(CHAINS.order(3), CHAINS.keyOfReverse(3))).isTrue();
        assertThat(CHAINS.contains(CHAINS.order(2), CHAINS.keyOfReverse(2))).isFalse();
    }

    @Test
    void withoutReflectionsOrThroughWallsARunIsNoChain() {
        assertThat(run().isChainFrom(CHAINS)).isFalse();
        MirrorRun through = run(4, 7);
        through.passThrough();
        assertThat(through.isChainFrom(CHAINS)).isFalse();
    }

    @Test
    void whatAChainBeginsWithIsKept() {
        MirrorChains kept = CHAINS.kept(new boolean[] {false, false, true, false, false});
        assertThat(kept.count()).isEqualTo(3);
        assertThat(kept.walls(2)).containsExactly(4, 7);
        assertThat(MirrorChains.of(4, 7).walls(2)).containsExactly(4, 7);
    }

    @Test
    void theBestChainsAreKeptWithWhatTheyBeginWith() {
        ChainTree tree = new ChainTree();
        tree.add(new int[] {1, 2}, 0.5);
        tree.add(new int[] {1, 3}, 0.2);
        tree.add(new int[] {5}, 0.1);
        tree.add(new int[] {5}, 0.3);
        assertThat(tree.worth(new int[] {1})).isCloseTo(0.7, within(1e-12));
        assertThat(tree.worth(new int[] {8})).isZero();
        assertThat(tree.firstWalls(1)).containsExactly(1);
        assertThat(tree.firstWalls(9)).containsExactly(1, 5);
        MirrorChains best = tree.best(4, 0.35);
        assertThat(best.count()).isEqualTo(4);
        assertThat(best.contains(2, MirrorChains.appended(MirrorChains.appended(0, 1), 3)))
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
