package org.dronewatch.kdtree;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.IntStream;
import org.dronewatch.geometry.TriangleMesh;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** No ray gets out of a closed mesh. */
class WatertightTest {
    private static final int PARTS = 10;
    private static final int RAYS_PER_PART = 100_000;

    @ParameterizedTest
    @EnumSource
    void aMillionRaysFromInsideABallAllHitIt(Way way) {
        assertThat(leaks(Meshes.icosphere(4), way)).as("leaks of seeds 0 to 9").isZero();
    }

    @ParameterizedTest
    @EnumSource
    void aMillionRaysFromInsideARoomAllHitIt(Way way) {
        assertThat(leaks(Meshes.room(), way)).as("leaks of seeds 0 to 9").isZero();
    }

    private static long leaks(TriangleMesh mesh, Way way) {
        KDTree tree = KDTree.of(mesh);
        return IntStream.range(0, PARTS)
                .parallel()
                .mapToLong(seed -> {
                    RayTracer traversal = way.on(tree);
                    Rays rays = new Rays(mesh, seed);
                    return IntStream.range(0, RAYS_PER_PART)
                            .filter(i -> !Rays.closestHit(traversal, Rays.ray(rays.inBox(0.5), rays.onSphere())))
                            .count();
                })
                .sum();
    }
}
