package org.dronewatch.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.kdtree.StackTraversal;
import org.jogamp.vecmath.Vector3d;
import org.junit.jupiter.api.Test;

/** The rays that models are measured with, above ground that the bench makes. */
class RayGeneratorTest {
    private static final KDTree GROUND = KDTree.of(RollingTerrain.of(20_000));
    private static final RayGenerator RAYS = new RayGenerator(GROUND, 1, new Vector3d(0, 0, 1));

    @Test
    void aPictureIsNinetyDegreesWideAndLooksAtTheMiddle() {
        RaySet picture = RAYS.camera(801, 401);
        assertThat(picture.count()).isEqualTo(801 * 401);
        // Half a pixel is missing on either side.
        Vector3d left = direction(picture, 200 * 801);
        Vector3d right = direction(picture, 200 * 801 + 800);
        assertThat(left.angle(right)).isCloseTo(2.0 * Math.atan(800.0 / 801.0), within(1e-6));
        Vector3d toMiddle = new Vector3d(GROUND.bounds().center());
        toMiddle.sub(origin(picture, 0));
        assertThat(direction(picture, 200 * 801 + 400).angle(toMiddle)).isLessThan(1e-6);
        assertThat(direction(picture, 0).z).as("top").isGreaterThan(direction(picture, 400 * 801).z + 0.5);
        RaySet asWritten = new RayGenerator(GROUND, 1).camera(801, 401);
        assertThat(direction(asWritten, 0).y).as("y is up").isGreaterThan(direction(asWritten, 400 * 801).y + 0.5);
    }

    /** Lambert's law: the mean cosine to the normal is 2/3, half of the rays are within 45 degrees. */
    @Test
    void diffuseRaysLeaveWhatTheCameraSees() {
        RaySet diffuse = RAYS.diffuse(RAYS.camera(200, 100));
        assertThat(diffuse.count()).isEqualTo(1_000_000);
        RayTracer traversal = new StackTraversal(GROUND);
        double cosines = 0.0;
        int within45 = 0;
        int rays = 2000;
        for (int i = 0; i < rays; i++) {
            // One from each part of the set.
            int ray = i * (diffuse.count() / rays);
            Vector3d from = origin(diffuse, ray);
            assertThat(traversal.closestHit(from.x, from.y, from.z, 0, 0, -1, 0.0, 1.0))
                    .as("just above the ground, ray %d", ray)
                    .isTrue();
            Vector3d normal = GROUND.mesh().triangle(traversal.triangle()).areaNormal();
            double cosine = Math.cos(normal.angle(direction(diffuse, ray)));
            assertThat(cosine).isGreaterThan(0.0);
            cosines += cosine / rays;
            within45 += cosine > Math.sqrt(0.5) ? 1 : 0;
        }
        // Standard deviations: sqrt(1/2 - 4/9) = 0.236 of a cosine, 0.5 of a half; four of a mean.
        assertThat(cosines).isCloseTo(2.0 / 3.0, within(4.0 * 0.236 / Math.sqrt(rays)));
        assertThat(within45 / (double) rays).isCloseTo(0.5, within(4.0 * 0.5 / Math.sqrt(rays)));
    }

    @Test
    void theSameSeedGivesTheSameRays() {
        RaySet picture = RAYS.camera(20, 10);
        float[] rays = RAYS.diffuse(picture, 10_000).rays();
        assertThat(rays).hasSize(10_000 * RaySet.FLOATS);
        assertThat(new RayGenerator(GROUND, 1).diffuse(picture, 10_000).rays()).isEqualTo(rays);
        assertThat(new RayGenerator(GROUND, 2).diffuse(picture, 10_000).rays()).isNotEqualTo(rays);
    }

    private static Vector3d origin(RaySet set, int ray) {
        return vector(set, RaySet.FLOATS * ray);
    }

    private static Vector3d direction(RaySet set, int ray) {
        return vector(set, RaySet.FLOATS * ray + 3);
    }

    private static Vector3d vector(RaySet set, int at) {
        return new Vector3d(set.rays()[at], set.rays()[at + 1], set.rays()[at + 2]);
    }
}
