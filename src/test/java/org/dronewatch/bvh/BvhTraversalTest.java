package org.dronewatch.bvh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.util.Random;
import org.dronewatch.Thorough;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.LeafOrderTriangles;
import org.dronewatch.kdtree.Meshes;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.kdtree.StackTraversal;
import org.dronewatch.parallel.VectorInstructions;
import org.dronewatch.parallel.Workers;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The tree for scattered rays; what any traversal must find is tested with the others in {@code TraversalTest}. */
class BvhTraversalTest {
    private static final double END = Double.POSITIVE_INFINITY;

    @BeforeEach
    void needVectors() {
        assumeTrue(VectorInstructions.areAvailable(), "no vectors of 256 bits, or the module of vectors is not named");
    }

    @Thorough
    @ParameterizedTest
    @ValueSource(strings = {"hill.obj", "house.obj", "cathedral.obj", "quadrotor.obj"})
    void scatteredRaysHitWhatTheyHitInTheKdTree(String model) {
        TriangleMesh mesh = Meshes.model(model);
        KDTree tree = KDTree.of(mesh);
        TracingIndex index = new TracingIndex(tree);
        assertThat(index.hasBvh()).isTrue();
        RayTracer wide = index.newIncoherentRayTracer();
        RayTracer narrow = new StackTraversal(tree);
        assertThat(wide).isInstanceOf(BvhTraversal.class);
        long seed = 20261121;
        Random random = new Random(seed);
        var box = mesh.bounds();
        int hits = 0;
        int ties = 0;
        for (int i = 0; i < 200_000; i++) {
            double[] o = {
                box.minX() + random.nextDouble() * (box.maxX() - box.minX()),
                box.minY() + random.nextDouble() * (box.maxY() - box.minY()),
                box.minZ() + random.nextDouble() * (box.maxZ() - box.minZ())
            };
            double[] d = {random.nextGaussian(), random.nextGaussian(), random.nextGaussian()};
            boolean found = narrow.closestHit(o[0], o[1], o[2], d[0], d[1], d[2], 0.0, END);
            assertThat(wide.closestHit(o[0], o[1], o[2], d[0], d[1], d[2], 0.0, END))
                    .as("seed %d, ray %d", seed, i)
                    .isEqualTo(found);
            if (found) {
                hits++;
                if (wide.triangle() == narrow.triangle()) {
                    assertThat(wide.distance()).as("seed %d, ray %d", seed, i).isEqualTo(narrow.distance());
                    assertThat(wide.u()).isEqualTo(narrow.u());
                    assertThat(wide.v()).isEqualTo(narrow.v());
                } else {
                    // Faces that lie in one another, as where two solids touch: the wide tree gives the nearest by the
                    // last bit, then the first; the kd-tree ends in the first cell with a hit.
                    ties++;
                    assertThat(wide.distance())
                            .as("seed %d, ray %d", seed, i)
                            .isCloseTo(narrow.distance(), within(1e-14 * narrow.distance()))
                            .isLessThanOrEqualTo(narrow.distance());
                }
            }
        }
        assertThat(ties).as("seed %d", seed).isLessThan(hits / 300);
        assertThat(hits).isGreaterThan(20_000);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 4, 5, 12, 15, 16, 17, 18, 40})
    void fewTrianglesAreHitWithAndWithoutATree(int triangles) {
        long seed = 20261125 + triangles;
        Random random = new Random(seed);
        float[] corners = new float[9 * triangles];
        int[] numbers = new int[3 * triangles];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = 10 * random.nextFloat();
        }
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = i;
        }
        KDTree tree = KDTree.of(TriangleMesh.of(corners, numbers));
        RayTracer wide = new BvhTraversal(tree, new BvhBuilder(tree.triangles()).build());
        RayTracer chosen = new TracingIndex(tree).newIncoherentRayTracer();
        assertThat(chosen instanceof FewTrianglesTraversal).isEqualTo(triangles <= 16);
        checkAgainstTheKdTree(tree, wide, seed);
        checkAgainstTheKdTree(tree, chosen, seed);
    }

    private static void checkAgainstTheKdTree(KDTree tree, RayTracer wide, long seed) {
        Random random = new Random(seed);
        RayTracer narrow = new StackTraversal(tree);
        int hits = 0;
        for (int i = 0; i < 10_000; i++) {
            double[] o = {20 * random.nextDouble() - 5, 20 * random.nextDouble() - 5, 20 * random.nextDouble() - 5};
            double[] d = {random.nextGaussian(), random.nextGaussian(), random.nextGaussian()};
            double first = i % 2 == 0 ? 0.0 : 3.0 * random.nextDouble();
            double last = i % 3 == 0 ? END : first + 10.0 * random.nextDouble();
            boolean found = narrow.closestHit(o[0], o[1], o[2], d[0], d[1], d[2], first, last);
            assertThat(wide.closestHit(o[0], o[1], o[2], d[0], d[1], d[2], first, last))
                    .as("seed %d, ray %d", seed, i)
                    .isEqualTo(found);
            if (found) {
                hits++;
                assertThat(wide.triangle()).as("seed %d, ray %d", seed, i).isEqualTo(narrow.triangle());
                assertThat(wide.distance()).as("seed %d, ray %d", seed, i).isEqualTo(narrow.distance());
                assertThat(wide.u()).as("seed %d, ray %d", seed, i).isEqualTo(narrow.u());
                assertThat(wide.v()).as("seed %d, ray %d", seed, i).isEqualTo(narrow.v());
            }
            assertThat(wide.isOccluded(o[0], o[1], o[2], d[0], d[1], d[2], first, last))
                    .as("seed %d, ray %d", seed, i)
                    .isEqualTo(narrow.isOccluded(o[0], o[1], o[2], d[0], d[1], d[2], first, last));
        }
        assertThat(hits).as("seed %d", seed).isGreaterThan(10);
    }

    @Test
    void theTreeIsTheSameForAnyNumberOfThreads() {
        LeafOrderTriangles triangles = KDTree.of(Meshes.model("cathedral.obj")).triangles();
        int[][] pools = new int[3][];
        for (int threads = 1; threads <= 3; threads++) {
            try (Workers workers = new Workers(threads)) {
                pools[threads - 1] =
                        workers.call(() -> new BvhBuilder(triangles).build().pool());
            }
        }
        assertThat(pools[1]).isEqualTo(pools[0]);
        assertThat(pools[2]).isEqualTo(pools[0]);
    }

    @Test
    void everyTriangleIsInOneLeafAndInsideAllBoxesAboveIt() {
        TriangleMesh mesh = Meshes.model("house.obj");
        KDTree tree = KDTree.of(mesh);
        Bvh wide = new BvhBuilder(tree.triangles()).build();
        int[] seen = new int[mesh.triangleCount()];
        float[] all = {
            Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY,
            Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY
        };
        int depth = check(wide.pool(), BvhNode.ROOT, all, seen);

        assertThat(seen).containsOnly(1);
        assertThat(depth).isEqualTo(wide.depth());
    }

    private static int check(int[] pool, int node, float[] box, int[] seen) {
        int depth = 0;
        for (int child = 0; child < BvhNode.WIDTH; child++) {
            float[] own = new float[6];
            for (int k = 0; k < 6; k++) {
                own[k] = BvhNode.bound(pool, node, k, child);
            }
            if (own[0] > own[3]) {
                continue;
            }
            for (int axis = 0; axis < 3; axis++) {
                assertThat(own[axis]).isGreaterThanOrEqualTo(box[axis]);
                assertThat(own[axis + 3]).isLessThanOrEqualTo(box[axis + 3]);
            }
            int reference = BvhNode.reference(pool, node, child);
            if (BvhNode.isLeaf(reference)) {
                checkBlocks(pool, reference, own, seen);
            } else {
                depth = Math.max(depth, check(pool, reference, own, seen));
            }
        }
        return depth + 1;
    }

    private static void checkBlocks(int[] pool, int leaf, float[] box, int[] seen) {
        for (int block = BvhNode.firstBlock(leaf); block <= BvhNode.lastBlock(leaf); block += BvhNode.BLOCK) {
            for (int lane = 0; lane < BvhNode.TRIANGLES; lane++) {
                boolean extent = false;
                for (int k = 0; k < 9; k++) {
                    extent |= BvhNode.coordinate(pool, block, k, lane) != BvhNode.coordinate(pool, block, k % 3, lane);
                }
                if (!extent) {
                    continue;
                }
                seen[BvhNode.number(pool, block, lane)]++;
                for (int k = 0; k < 9; k++) {
                    float x = BvhNode.coordinate(pool, block, k, lane);
                    assertThat(x).isBetween(box[k % 3], box[k % 3 + 3]);
                }
            }
        }
    }

    @Test
    void numbersThatSinglePrecisionCannotBoundAreLeftToTheKdTree() {
        TriangleMesh mesh = Meshes.model("house.obj");
        KDTree tree = KDTree.of(mesh);
        RayTracer wide = new TracingIndex(tree).newIncoherentRayTracer();
        RayTracer narrow = new StackTraversal(tree);
        double[][] rays = {
            {1e14, 0.3, 5, -1, 0, 0},
            {30, 0.3, 5, -1e-12, 1e-14, 0},
            {30, 0.3, 5, -1e12, 0, 1e10},
            {30, 0.3, 5, -1e300, 0, 0},
        };
        for (double[] r : rays) {
            boolean found = narrow.closestHit(r[0], r[1], r[2], r[3], r[4], r[5], 0.0, END);
            assertThat(found).isTrue();
            assertThat(wide.closestHit(r[0], r[1], r[2], r[3], r[4], r[5], 0.0, END))
                    .isTrue();
            assertThat(wide.distance()).isEqualTo(narrow.distance());
        }
        // A mesh of astronomic size has no second tree at all.
        float[] far = {1e20f, 0, 0, 1e20f, 1, 0, 1e20f, 0, 1};
        KDTree astronomic = KDTree.of(TriangleMesh.of(far, new int[] {0, 1, 2}));
        TracingIndex farAway = new TracingIndex(astronomic);
        assertThat(farAway.hasBvh()).isFalse();
        assertThat(farAway.newIncoherentRayTracer()).isNotInstanceOf(BvhTraversal.class);
    }
}
