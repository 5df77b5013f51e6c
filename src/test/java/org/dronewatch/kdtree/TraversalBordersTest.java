package org.dronewatch.kdtree;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.geometry.TriangleMesh;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** What any way through a tree must find of rays that start on borders of its cells or run inside their planes. */
class TraversalBordersTest {
    private static final double END = Double.POSITIVE_INFINITY;

    /** Only where the ray's line comes within a rounding of the hit triangle's edge may another triangle be hit. */
    @Thorough
    @Test
    void raysFromAndAlongTheBordersOfCells() {
        for (TriangleMesh mesh : List.of(Meshes.room(), Meshes.soup(200, 0.3, 61), Meshes.icosphere(2))) {
            KDTree tree = KDTree.of(mesh);
            Map<Way, RayTracer> ways = new EnumMap<>(Way.class);
            Arrays.stream(Way.values()).forEach(way -> ways.put(way, way.on(tree)));
            BruteForce bruteForce = new BruteForce(mesh);
            List<double[]> cells = cells(tree, 0, box(tree));
            Rays rays = new Rays(mesh, 62);
            SplittableRandom random = new SplittableRandom(63);
            for (int i = 0; i < LongForm.count(3000, 6000); i++) {
                double[] origin = onBorder(cells.get(random.nextInt(cells.size())), random);
                double[] target = onBorder(cells.get(random.nextInt(cells.size())), random);
                double[] ray =
                        switch (i % 3) {
                            case 0 -> Rays.ray(origin, rays.axisParallel());
                            case 1 -> Rays.ray(origin, rays.withOneZero());
                            default -> Rays.towards(origin, target);
                        };

                BruteForce.Answer expected = bruteForce.closest(ray);
                ways.forEach((way, traversal) -> assertSame(way, traversal, ray, expected, bruteForce));
            }
        }
    }

    private static void assertSame(
            Way way, RayTracer traversal, double[] ray, BruteForce.Answer expected, BruteForce bruteForce) {
        double found = Way.closest(traversal, ray);
        boolean startsOnSurface = Math.min(found, expected.distance()) < 1e-12;
        boolean same = found == expected.distance()
                || Math.abs(found - expected.distance()) <= 1e-9 * expected.distance() + 1e-14;
        if (!same && !startsOnSurface) {
            int first = found < expected.distance() ? traversal.triangle() : expected.triangle();
            assertThat(bruteForce.edgeDistance(ray, first))
                    .as("%s: %s of seeds 62 and 63 hits at %s, not %s", way, Arrays.toString(ray), found, expected)
                    .isLessThanOrEqualTo(1e-12);
        }
    }

    @ParameterizedTest
    @EnumSource
    void aRayInsideTwoSplitPlanesHitsTheNearestTriangle(Way way) {
        KDTree tree = KDTree.of(Meshes.room());
        double[] ray = {3.1375741958618164, 5.58209228515625, 0.23422181606292725, 0.0, -1.0, 0.0};

        assertThat(Way.closest(way.on(tree), ray)).isEqualTo(0.08209228515625);
    }

    /**
     * Triangles that touch the plane x = 0 from its two sides, and a ray inside that plane: the cells on both sides
     * span the same range, and a hit on one side says nothing about the other.
     */
    @ParameterizedTest
    @EnumSource
    void aRayInsideASplitPlaneSeesBothItsSides(Way way) {
        List<Float> vertices = new ArrayList<>();
        for (int i = 0; i < 40; i++) {
            // Nearest on the right, or on the left, by turns of the ray's sense.
            float x = i < 20 ? -1 : 1;
            float y = 3 + 0.5f * (i % 20) + (i < 20 ? 0.25f : 0);
            for (float value : new float[] {0, y, -1, 0, y, 1, x, y, 0}) {
                vertices.add(value);
            }
        }
        float[] flat = new float[vertices.size()];
        int[] corners = new int[flat.length / 3];
        for (int i = 0; i < flat.length; i++) {
            flat[i] = vertices.get(i);
            corners[i / 3] = i / 3;
        }
        KDTree tree = KDTree.of(TriangleMesh.of(flat, corners));
        way.assertSameAsExhaustive(tree, "from the south", new double[] {0, 0, 0.25, 0, 1, 0});
        way.assertSameAsExhaustive(tree, "from the north", new double[] {0, 20, 0.25, 0, -1, 0});
    }

    /**
     * Rays inside the planes of flat faces, where planes of the tree lie too, towards corners and edges in that plane:
     * what stands on its one side is met by a ray that any rounding would put on the other.
     */
    @ParameterizedTest
    @EnumSource
    void raysInsidePlanesMeetWhatTouchesThem(Way way) {
        for (TriangleMesh mesh : List.of(Meshes.room(), Meshes.icosphere(2), Meshes.model("house.obj"))) {
            KDTree tree = KDTree.of(mesh);
            Exhaustive exhaustive = new Exhaustive(tree);
            RayTracer traversal = way.on(tree);
            Rays rays = new Rays(mesh, 66);
            SplittableRandom random = new SplittableRandom(67);
            int hits = 0;
            for (int i = 0; i < 3000; i++) {
                int triangle = random.nextInt(mesh.triangleCount());
                int axis = random.nextInt(3);
                double share = i % 2 == 0 ? 0.0 : random.nextDouble();
                double[] origin = rays.inBox(1.0);
                double[] ray = new double[6];
                for (int k = 0; k < 3; k++) {
                    double a = mesh.coordinate(triangle, 0, k);
                    double b = mesh.coordinate(triangle, 1, k);
                    double from = k == axis ? a : origin[k];
                    ray[k] = from;
                    ray[3 + k] = k == axis ? 0.0 : a + share * (b - a) - from;
                }
                double expected = exhaustive.closest(ray, 0.0, END);
                hits += expected < END ? 1 : 0;
                // Triangles that meet in the point that is hit may differ by roundings, and a cell behind hold the
                // nearer.
                assertThat(Way.closest(traversal, ray))
                        .as("%s of seeds 66 and 67, ray %d", Arrays.toString(ray), i)
                        .isBetween(expected, expected + 1e-14 * expected);
            }
            assertThat(hits).as("hits of %d triangles", mesh.triangleCount()).isGreaterThan(1000);
        }
    }

    private static double[] box(KDTree tree) {
        double[] box = new double[6];
        Arrays.setAll(box, k -> tree.rootBox()[k]);
        return box;
    }

    private static List<double[]> cells(KDTree tree, int index, double[] box) {
        long node = tree.nodes()[index];
        int axis = KDNode.kind(node);
        if (axis == KDNode.LEAF) {
            return List.of(box);
        }
        double[] left = box.clone();
        left[axis + 3] = KDNode.split(node);
        double[] right = box.clone();
        right[axis] = KDNode.split(node);
        List<double[]> cells = new ArrayList<>(cells(tree, KDNode.leftChild(index), left));
        cells.addAll(cells(tree, KDNode.rightChild(node), right));
        return cells;
    }

    /** A corner of a box, or the middle of an edge or a face, or its centre. */
    private static double[] onBorder(double[] box, SplittableRandom random) {
        double[] point = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            double share = 0.5 * random.nextInt(3);
            point[axis] = (1 - share) * box[axis] + share * box[axis + 3];
        }
        return point;
    }
}
