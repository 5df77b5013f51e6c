package org.dronewatch.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.dronewatch.geometry.TriangleMesh;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** What is traced, by each traversal, without a warm-up: not how fast. */
class KernelBenchTest {
    private static final TriangleMesh TRIANGLE =
            TriangleMesh.of(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, new int[] {0, 1, 2});

    /** Of three segments towards a triangle, one ends behind it, one in front of it, and one passes it. */
    @ParameterizedTest
    @EnumSource
    void hiddenSegmentsAreCounted(TraversalKind kind) {
        float[] segments = {0.2f, 0.2f, -2, 0, 0, 3, 0.2f, 0.2f, -2, 0, 0, 1.5f, 0.2f, 0.2f, -2, 5, 0, 3};
        KernelBench bench = new KernelBench(TRIANGLE, kind, 1, Duration.ZERO);

        TracingSpeed measured = bench.measure(new RaySet("file", segments, 0, RaySet.Query.OCCLUDED), 1, any -> {});

        assertThat(measured.rays()).isEqualTo(3);
        assertThat(measured.hits()).isEqualTo(1);
    }

    /** One ray towards the triangle and one away from it. */
    @ParameterizedTest
    @EnumSource
    void nearestHitsAreKept(TraversalKind kind) {
        float[] rays = {0.2f, 0.2f, -2, 0, 0, 1, 0.2f, 0.2f, -2, 0, 0, -1};
        KernelBench bench = new KernelBench(TRIANGLE, kind, 2, Duration.ZERO);

        assertThat(bench.measure(new RaySet("file", rays, 0), 1, any -> {}).hits())
                .isEqualTo(1);
        assertThat(bench.distances()).containsExactly(2.0f, Float.POSITIVE_INFINITY);
        assertThat(bench.sourceTriangles()).containsExactly(0, -1);
    }
}
