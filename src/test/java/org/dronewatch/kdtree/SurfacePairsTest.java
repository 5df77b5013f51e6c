package org.dronewatch.kdtree;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.world.World;
import org.jogamp.vecmath.Point3d;
import org.junit.jupiter.api.Test;

class SurfacePairsTest {

    @Test
    void pointsOnTheSurfaceOfAHollowBallSeeEachOther() {
        TriangleMesh ball = Meshes.icosphere(3);
        World world = World.of(ball);
        Rays rays = new Rays(ball, 1);
        int occluded = 0;
        for (int i = 0; i < 10_000; i++) {
            occluded += world.isOccluded(new Point3d(rays.onMesh()), new Point3d(rays.onMesh())) ? 1 : 0;
        }

        assertThat(occluded).as("of 10,000 pairs of seed 1").isLessThan(20);
    }
}
