package org.dronewatch.bvh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.util.Random;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.kdtree.StackTraversal;
import org.dronewatch.parallel.VectorInstructions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What any traversal must find is tested with the others; here, hits that need a choice. */
class FewTrianglesTraversalTest {
    private static final double END = Double.POSITIVE_INFINITY;

    /** A room of 10 x 8 x 4 m. */
    private static final float[] CORNERS = {0, 0, 0, 10, 0, 0, 10, 8, 0, 0, 8, 0, 0, 0, 4, 10, 0, 4, 10, 8, 4, 0, 8, 4};

    private static final int[] WALLS = {
        0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7
    };

    @BeforeEach
    void needVectors() {
        assumeTrue(VectorInstructions.areAvailable(), "no vectors of 256 bits, or the module of vectors is not named");
    }

    private static RayTracer tracer(KDTree tree) {
        RayTracer tracer = new TracingIndex(tree).newIncoherentRayTracer();
        assertThat(tracer).isInstanceOf(FewTrianglesTraversal.class);
        return tracer;
    }

    /** From a lattice of points to one of points on the walls, many on edges, diagonals and corners. */
    @Test
    void raysHitEdgesAndCornersWhereTheyDoInTheKdTree() {
        KDTree tree = KDTree.of(TriangleMesh.of(CORNERS, WALLS));
        RayTracer few = tracer(tree);
        RayTracer narrow = new StackTraversal(tree);
        int inEdges = 0;
        for (int i = 0; i < 9 * 7 * 3 * 11 * 9 * 5; i++) {
            double[] o = {1 + i % 9, 1 + i / 9 % 7, 1 + i / 63 % 3};
            int j = i / 189;
            double[] d = {j % 11 - o[0], j / 11 % 9 - o[1], j / 99 - o[2]};
            boolean found = narrow.closestHit(o[0], o[1], o[2], d[0], d[1], d[2], 0.0, END);
            boolean still = d[0] == 0.0 && d[1] == 0.0 && d[2] == 0.0;
            if (still) {
                continue;
            }
            assertThat(found).isTrue();
            assertThat(few.closestHit(o[0], o[1], o[2], d[0], d[1], d[2], 0.0, END))
                    .as("ray %d", i)
                    .isTrue();
            assertThat(few.distance()).as("ray %d", i).isEqualTo(narrow.distance());
            inEdges += few.u() == 0.0 || few.v() == 0.0 ? 1 : 0;
        }
        assertThat(inEdges).isGreaterThan(10_000);
    }

    /** Three times the same wall, its corners in any order, in one block and in different ones. */
    @Test
    void ofCoincidingTrianglesTheFirstIsHit() {
        int[] triangles = new int[3 * 16];
        for (int i = 0; i < 16; i++) {
            int[] corners = i % 5 == 2 ? new int[] {0, 1, 2} : new int[] {4, 5, 6};
            for (int k = 0; k < 3; k++) {
                triangles[3 * i + k] = corners[(k + i) % 3];
            }
        }
        RayTracer few = tracer(KDTree.of(TriangleMesh.of(CORNERS, triangles)));
        long seed = 20261126;
        Random random = new Random(seed);
        for (int i = 0; i < 1000; i++) {
            double x = 6.0 + 3.0 * random.nextDouble();
            double y = 3.0 * random.nextDouble();
            assertThat(few.closestHit(x, y, 2.0, 0.01, 0.02, -1.0, 0.0, END))
                    .as("seed %d, ray %d", seed, i)
                    .isTrue();
            assertThat(few.triangle()).isEqualTo(2);
            assertThat(few.closestHit(x, y, 2.0, 0.01, 0.02, 1.0, 0.0, END)).isTrue();
            assertThat(few.triangle()).isZero();
        }
    }

    @Test
    void hitsBeforeAndBehindASegmentDoNotCount() {
        RayTracer few = tracer(KDTree.of(TriangleMesh.of(CORNERS, WALLS)));
        // From below the floor, at 1 m, to the ceiling, at 5 m.
        double[] r = {3, 5, -1, 0, 0, 1};
        assertThat(few.closestHit(r[0], r[1], r[2], r[3], r[4], r[5], 0.0, END)).isTrue();
        assertThat(few.distance()).isEqualTo(1.0);
        assertThat(few.closestHit(r[0], r[1], r[2], r[3], r[4], r[5], 1.0, 1.0)).isTrue();
        assertThat(few.closestHit(r[0], r[1], r[2], r[3], r[4], r[5], Math.nextUp(1.0), END))
                .isTrue();
        assertThat(few.distance()).isEqualTo(5.0);
        assertThat(few.closestHit(r[0], r[1], r[2], r[3], r[4], r[5], 1.5, 4.5)).isFalse();
        assertThat(few.isOccluded(r[0], r[1], r[2], r[3], r[4], r[5], 1.0, 5.0)).isFalse();
        assertThat(few.isOccluded(r[0], r[1], r[2], r[3], r[4], r[5], 0.5, 5.0)).isTrue();
        assertThat(few.isOccluded(r[0], r[1], r[2], r[3], r[4], r[5], 4.0, 5.5)).isTrue();
    }
}
