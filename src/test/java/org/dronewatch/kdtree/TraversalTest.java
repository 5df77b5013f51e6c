package org.dronewatch.kdtree;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.Function;
import org.dronewatch.geometry.Hit;
import org.dronewatch.geometry.IntersectionHandler;
import org.dronewatch.geometry.Ray;
import org.dronewatch.geometry.TriangleMesh;
import org.jogamp.vecmath.Point3d;
import org.jogamp.vecmath.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** What either way through a tree must find, above all for rays that touch the tree's and the triangles' borders. */
class TraversalTest {
    private static final double END = Double.POSITIVE_INFINITY;

    /** The ways through a tree. */
    enum Way {
        STACK(StackTraversal::new),
        SEQUENTIAL(SequentialTraversal::new),
        /** By vectors where the machine has them, as in the build's own tests. */
        SCATTERED(KDTree::newScatteredTraversal);

        private final Function<KDTree, KDTraversal> maker;

        Way(Function<KDTree, KDTraversal> maker) {
            this.maker = maker;
        }

        KDTraversal on(KDTree tree) {
            return maker.apply(tree);
        }
    }

    private static void assertSameAsExhaustive(KDTree tree, Way way, double[] ray, String seed) {
        Exhaustive exhaustive = new Exhaustive(tree);
        KDTraversal traversal = way.on(tree);
        double expected = exhaustive.closest(ray, 0.0, END);
        String what = Arrays.toString(ray) + " of " + seed;

        assertThat(closest(traversal, ray)).as(what).isEqualTo(expected);
        assertThat(Rays.isOccluded(traversal, ray, 0.0, END)).as(what).isEqualTo(expected < END);
    }

    private static double closest(KDTraversal traversal, double[] ray) {
        return Rays.closestHit(traversal, ray) ? traversal.distance() : END;
    }

    @ParameterizedTest
    @EnumSource
    void noTriangleOnTheWayIsLeftOut(Way way) {
        for (int seed = 20; seed < 60; seed++) {
            TriangleMesh mesh = Meshes.soup(10 * (seed - 19), 0.02 * (seed - 15), seed);
            KDTree tree = KDTree.of(mesh);
            for (double[] ray : new Rays(mesh, seed).any(400)) {
                assertSameAsExhaustive(tree, way, ray, "soup and rays of seed " + seed);
            }
        }
    }

    /** Only where the ray's line comes within a rounding of the hit triangle's edge may another triangle be hit. */
    @ParameterizedTest
    @EnumSource
    void raysFromAndAlongTheBordersOfCells(Way way) {
        for (TriangleMesh mesh : List.of(Meshes.room(), Meshes.soup(200, 0.3, 61), Meshes.icosphere(2))) {
            KDTree tree = KDTree.of(mesh);
            KDTraversal traversal = way.on(tree);
            BruteForce bruteForce = new BruteForce(mesh);
            List<double[]> cells = cells(tree, 0, box(tree));
            Rays rays = new Rays(mesh, 62);
            SplittableRandom random = new SplittableRandom(63);
            for (int i = 0; i < 6000; i++) {
                double[] origin = onBorder(cells.get(random.nextInt(cells.size())), random);
                double[] target = onBorder(cells.get(random.nextInt(cells.size())), random);
                double[] ray =
                        switch (i % 3) {
                            case 0 -> Rays.ray(origin, rays.axisParallel());
                            case 1 -> Rays.ray(origin, rays.withOneZero());
                            default -> Rays.towards(origin, target);
                        };

                BruteForce.Answer expected = bruteForce.closest(ray);
                double found = closest(traversal, ray);
                boolean startsOnSurface = Math.min(found, expected.distance()) < 1e-12;
                boolean same = found == expected.distance()
                        || Math.abs(found - expected.distance()) <= 1e-9 * expected.distance() + 1e-14;
                if (!same && !startsOnSurface) {
                    int first = found < expected.distance() ? traversal.triangle() : expected.triangle();
                    assertThat(bruteForce.edgeDistance(ray, first))
                            .as("%s of seeds 62 and 63 hits at %s, not %s", Arrays.toString(ray), found, expected)
                            .isLessThanOrEqualTo(1e-12);
                }
            }
        }
    }

    @ParameterizedTest
    @EnumSource
    void aRayInsideTwoSplitPlanesHitsTheNearestTriangle(Way way) {
        KDTree tree = KDTree.of(Meshes.room());
        double[] ray = {3.1375741958618164, 5.58209228515625, 0.23422181606292725, 0.0, -1.0, 0.0};

        assertThat(closest(way.on(tree), ray)).isEqualTo(0.08209228515625);
    }

    /**
     * Triangles that touch the plane x = 0 from its two sides, and a ray inside that plane: the cells on both sides span the
     * same range, and a hit on one side says nothing about the other.
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
        assertSameAsExhaustive(tree, way, new double[] {0, 0, 0.25, 0, 1, 0}, "from the south");
        assertSameAsExhaustive(tree, way, new double[] {0, 20, 0.25, 0, -1, 0}, "from the north");
    }

    /**
     * Rays inside the planes of flat faces, where planes of the tree lie too, towards corners and edges in that plane: what
     * stands on its one side is met by a ray that any rounding would put on the other.
     */
    @ParameterizedTest
    @EnumSource
    void raysInsidePlanesMeetWhatTouchesThem(Way way) {
        for (TriangleMesh mesh : List.of(Meshes.room(), Meshes.icosphere(2), Meshes.model("house.obj"))) {
            KDTree tree = KDTree.of(mesh);
            Exhaustive exhaustive = new Exhaustive(tree);
            KDTraversal traversal = way.on(tree);
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
                assertThat(closest(traversal, ray))
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
        List<double[]> cells = new ArrayList<>(cells(tree, index + 1, left));
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

    @ParameterizedTest
    @EnumSource
    void zerosOfEitherSignMeanTheSame(Way way) {
        TriangleMesh mesh = Meshes.room();
        KDTraversal traversal = way.on(KDTree.of(mesh));
        Rays rays = new Rays(mesh, 64);
        for (int i = 0; i < 5000; i++) {
            double[] ray = Rays.ray(rays.inBox(1.2), i % 2 == 0 ? rays.axisParallel() : rays.withOneZero());
            double[] other = ray.clone();
            for (int k = 3; k < 6; k++) {
                other[k] = ray[k] == 0.0 ? -ray[k] : ray[k];
            }

            double first = Rays.closestHit(traversal, ray) ? traversal.distance() : END;
            double second = Rays.closestHit(traversal, other) ? traversal.distance() : END;
            assertThat(second).as("ray %s of seed 64", Arrays.toString(ray)).isEqualTo(first);
        }
    }

    @ParameterizedTest
    @EnumSource
    void raysInThePlaneOfATriangleMissItAndHitWhatStandsAcross(Way way) {
        float[] vertices = {0, 0, 0.1f, 4, 0, 0.1f, 0, 4, 0.1f, 3, -1, -1, 3, 5, -1, 3, 2, 5};
        KDTraversal traversal = way.on(KDTree.of(TriangleMesh.of(vertices, new int[] {0, 1, 2, 3, 4, 5})));

        assertThat(traversal.closestHit(-1, 0.5, 0.1f, 1, 0, 0, 0.0, END)).isTrue();
        assertThat(traversal.triangle()).isEqualTo(1);
        assertThat(traversal.distance()).isEqualTo(4.0);
        assertThat(traversal.closestHit(-1, 0.5, 0.1f, 0, 1, -0.0, 0.0, END)).isFalse();
    }

    @ParameterizedTest
    @EnumSource
    void raysFromInsideAtCornersAndEdgesNeverSlipThrough(Way way) {
        for (TriangleMesh mesh : List.of(Meshes.icosphere(3), Meshes.room())) {
            KDTraversal traversal = way.on(KDTree.of(mesh));
            boolean convex = mesh.triangleCount() > 1000;
            Rays rays = new Rays(mesh, 65);
            SplittableRandom random = new SplittableRandom(66);
            for (int i = 0; i < 60_000; i++) {
                int triangle = random.nextInt(mesh.triangleCount());
                double share = i % 2 == 0 ? 0.0 : random.nextDouble();
                double[] target = new double[3];
                for (int axis = 0; axis < 3; axis++) {
                    double from = mesh.coordinate(triangle, 0, axis);
                    target[axis] = from + share * (mesh.coordinate(triangle, 1, axis) - from);
                }
                double[] ray = Rays.towards(rays.inBox(0.5), target);

                String what = Arrays.toString(ray) + " of seeds 65 and 66";
                assertThat(Rays.closestHit(traversal, ray)).as(what).isTrue();
                if (convex) {
                    assertThat(traversal.distance()).as(what).isCloseTo(1.0, within(1e-9));
                }
            }
        }
    }

    @ParameterizedTest
    @EnumSource
    void raysFromAMillionTimesTheSizeAway(Way way) {
        TriangleMesh mesh = Meshes.icosphere(2);
        KDTraversal traversal = way.on(KDTree.of(mesh));
        BruteForce bruteForce = new BruteForce(mesh);
        Rays rays = new Rays(mesh, 67);
        int hits = 0;
        for (int i = 0; i < 10_000; i++) {
            double[] ray = Rays.towards(rays.outside(1e6), rays.inBox(1.0));
            BruteForce.Answer expected = bruteForce.closest(ray);

            String what = Arrays.toString(ray) + " of seed 67, " + expected;
            assertThat(Rays.closestHit(traversal, ray)).as(what).isEqualTo(expected.found());
            if (expected.found()) {
                assertThat(traversal.distance()).as(what).isCloseTo(expected.distance(), withinPercentage(1e-12));
                hits++;
            }
        }
        assertThat(hits).isBetween(4000, 9999);
    }

    @ParameterizedTest
    @EnumSource
    void distancesAreInUnitsOfTheDirection(Way way) {
        TriangleMesh mesh = Meshes.soup(300, 0.4, 68);
        KDTraversal traversal = way.on(KDTree.of(mesh));
        for (double[] ray : new Rays(mesh, 69).any(4000)) {
            boolean found = Rays.closestHit(traversal, ray);
            double distance = traversal.distance();
            for (double factor : new double[] {0x1p-70, 1e-3, 7.3, 0x1p70}) {
                double[] longer = ray.clone();
                for (int k = 3; k < 6; k++) {
                    longer[k] = factor * ray[k];
                }

                String what = Arrays.toString(longer) + " of seeds 68 and 69";
                assertThat(Rays.closestHit(traversal, longer)).as(what).isEqualTo(found);
                if (found) {
                    assertThat(traversal.distance()).as(what).isCloseTo(distance / factor, withinPercentage(1e-10));
                }
            }
        }
    }

    @ParameterizedTest
    @EnumSource
    void theRangeOfAHitIncludesItsEndsAndThatOfAnOcclusionDoesNot(Way way) {
        TriangleMesh mesh = Meshes.soup(300, 0.4, 70);
        KDTree tree = KDTree.of(mesh);
        KDTraversal traversal = way.on(tree);
        Exhaustive exhaustive = new Exhaustive(tree);
        int hits = 0;
        for (double[] ray : new Rays(mesh, 71).any(4000)) {
            if (!Rays.closestHit(traversal, ray)) {
                continue;
            }
            hits++;
            double t = traversal.distance();
            double next = exhaustive.closest(ray, Math.nextUp(t), END);
            String what = Arrays.toString(ray) + " of seeds 70 and 71";

            assertThat(Rays.closestHit(traversal, ray, 0.0, t)).as(what).isTrue();
            assertThat(Rays.closestHit(traversal, ray, 0.0, Math.nextDown(t)))
                    .as(what)
                    .isFalse();
            assertThat(Rays.closestHit(traversal, ray, t, END)).as(what).isTrue();
            assertThat(traversal.distance()).as(what).isEqualTo(t);
            assertThat(Rays.closestHit(traversal, ray, Math.nextUp(t), END))
                    .as(what)
                    .isEqualTo(next < END);
            assertThat(Rays.isOccluded(traversal, ray, 0.0, t)).as(what).isFalse();
            assertThat(Rays.isOccluded(traversal, ray, 0.0, Math.nextUp(t)))
                    .as(what)
                    .isTrue();
            assertThat(Rays.isOccluded(traversal, ray, Math.nextDown(t), END))
                    .as(what)
                    .isTrue();
            assertThat(Rays.isOccluded(traversal, ray, t, next)).as(what).isFalse();
            assertThat(Rays.isOccluded(traversal, ray, t, t)).as(what).isFalse();
        }
        assertThat(hits).isGreaterThan(1000);
    }

    @ParameterizedTest
    @EnumSource
    void weightsAndDistanceNameThePointThatTheReferenceFinds(Way way) {
        TriangleMesh mesh = Meshes.soup(300, 0.4, 72);
        KDTraversal traversal = way.on(KDTree.of(mesh));
        int hits = 0;
        for (double[] r : new Rays(mesh, 73).any(4000)) {
            Ray ray = new Ray(new Point3d(r[0], r[1], r[2]), new Vector3d(r[3], r[4], r[5]));
            Optional<Hit> hit = traversal.closestHit(ray);
            if (hit.isEmpty()) {
                continue;
            }
            hits++;
            String what = ray + " of seeds 72 and 73";
            Optional<Hit> reference =
                    IntersectionHandler.rayTriangle(ray, mesh.triangle(hit.get().triangle()));
            assertThat(reference).as(what).isPresent();
            assertThat(hit.get().distance()).as(what).isCloseTo(reference.get().distance(), withinPercentage(1e-8));
            assertThat(hit.get().u()).as(what).isCloseTo(reference.get().u(), within(1e-9));
            assertThat(hit.get().v()).as(what).isCloseTo(reference.get().v(), within(1e-9));
        }
        assertThat(hits).isGreaterThan(1000);
    }

    @ParameterizedTest
    @EnumSource
    void ofTrianglesInTheSamePlaceTheFirstIsHit(Way way) {
        KDTraversal traversal = way.on(KDTree.of(Meshes.degenerate().get("identical")));

        assertThat(traversal.closestHit(0.3, 0.3, 5, 0, 0, -1, 0.0, END)).isTrue();
        assertThat(traversal.triangle()).isZero();
    }

    @ParameterizedTest
    @EnumSource
    void severalThreadsShareATree(Way way) throws InterruptedException {
        TriangleMesh mesh = Meshes.soup(2000, 0.1, 74);
        KDTree tree = KDTree.of(mesh);
        double[][] rays = new Rays(mesh, 75).any(20_000);
        double[] alone = trace(way.on(tree), rays);

        double[][] together = new double[4][];
        List<Thread> threads = new ArrayList<>();
        for (int i = 0; i < together.length; i++) {
            int number = i;
            threads.add(new Thread(() -> together[number] = trace(way.on(tree), rays)));
        }
        threads.forEach(Thread::start);
        for (Thread thread : threads) {
            thread.join();
        }

        for (double[] one : together) {
            assertThat(one).as("rays of seed 75").isEqualTo(alone);
        }
    }

    private static double[] trace(KDTraversal traversal, double[][] rays) {
        return Arrays.stream(rays)
                .mapToDouble(ray -> Rays.closestHit(traversal, ray)
                        ? traversal.distance() + traversal.triangle() + traversal.u() + traversal.v()
                        : -1.0)
                .toArray();
    }
}
