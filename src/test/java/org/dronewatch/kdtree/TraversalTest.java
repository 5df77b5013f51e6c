package org.dronewatch.kdtree;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.dronewatch.geometry.Hit;
import org.dronewatch.geometry.IntersectionHandler;
import org.dronewatch.geometry.Ray;
import org.dronewatch.geometry.TriangleMesh;
import org.jogamp.vecmath.Point3d;
import org.jogamp.vecmath.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** What any way through a tree must find, and how it tells it. */
class TraversalTest {
    private static final double END = Double.POSITIVE_INFINITY;

    @ParameterizedTest
    @EnumSource
    void noTriangleOnTheWayIsLeftOut(Way way) {
        for (int seed = 20; seed < 60; seed++) {
            TriangleMesh mesh = Meshes.soup(10 * (seed - 19), 0.02 * (seed - 15), seed);
            double[][] rays = new Rays(mesh, seed).any(400);
            way.assertSameAsExhaustive(KDTree.of(mesh), "soup and rays of seed " + seed, rays);
        }
    }

    /**
     * Segments from one point to places along a line, of two lengths in turn, with nearest hits between them: what
     * hid the last one may be beside, beyond or behind the next.
     */
    @ParameterizedTest
    @EnumSource
    void aSegmentIsHiddenWhateverTheLastOneMet(Way way) {
        long seed = 20261126;
        SplittableRandom random = new SplittableRandom(seed);
        int hidden = 0;
        int count = 0;
        for (int triangles : new int[] {1, 3, 40, 400}) {
            TriangleMesh mesh = Meshes.soup(triangles, 0.4, triangles);
            Supplier<RayTracer> tracers = way.newOn(KDTree.of(mesh));
            RayTracer used = tracers.get();
            Rays rays = new Rays(mesh, seed + triangles);
            for (int line = 0; line < 40; line++) {
                double[] eye = rays.inBox(2.0);
                double[] from = rays.inBox(1.5);
                double[] to = rays.inBox(1.5);
                double near = random.nextDouble();
                for (int i = 0; i < 50; i++) {
                    double[] d = new double[3];
                    for (int axis = 0; axis < 3; axis++) {
                        d[axis] = from[axis] + i / 50.0 * (to[axis] - from[axis]) - eye[axis];
                    }
                    double end = i % 2 == 0 ? 1.0 : near;
                    double start = i % 5 == 0 ? 0.5 * end : 0.0;
                    boolean isHidden = tracers.get().isOccluded(eye[0], eye[1], eye[2], d[0], d[1], d[2], start, end);
                    assertThat(used.isOccluded(eye[0], eye[1], eye[2], d[0], d[1], d[2], start, end))
                            .as("%d triangles, line %d, segment %d, seed %d", triangles, line, i, seed)
                            .isEqualTo(isHidden);
                    if (i % 7 == 0) {
                        used.closestHit(eye[0], eye[1], eye[2], -d[0], -d[1], -d[2], 0.0, END);
                    }
                    hidden += isHidden ? 1 : 0;
                    count++;
                }
            }
        }
        assertThat(hidden / (double) count).as("share hidden, seed %d", seed).isBetween(0.1, 0.9);
    }

    @ParameterizedTest
    @EnumSource
    void zerosOfEitherSignMeanTheSame(Way way) {
        TriangleMesh mesh = Meshes.room();
        RayTracer traversal = way.on(KDTree.of(mesh));
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
        RayTracer traversal = way.on(KDTree.of(TriangleMesh.of(vertices, new int[] {0, 1, 2, 3, 4, 5})));

        assertThat(traversal.closestHit(-1, 0.5, 0.1f, 1, 0, 0, 0.0, END)).isTrue();
        assertThat(traversal.triangle()).isEqualTo(1);
        assertThat(traversal.distance()).isEqualTo(4.0);
        assertThat(traversal.closestHit(-1, 0.5, 0.1f, 0, 1, -0.0, 0.0, END)).isFalse();
    }

    @ParameterizedTest
    @EnumSource
    void raysFromInsideAtCornersAndEdgesNeverSlipThrough(Way way) {
        for (TriangleMesh mesh : List.of(Meshes.icosphere(3), Meshes.room())) {
            RayTracer traversal = way.on(KDTree.of(mesh));
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

                Supplier<String> what = () -> Arrays.toString(ray) + " of seeds 65 and 66";
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
        RayTracer traversal = way.on(KDTree.of(mesh));
        BruteForce bruteForce = new BruteForce(mesh);
        Rays rays = new Rays(mesh, 67);
        int hits = 0;
        for (int i = 0; i < 10_000; i++) {
            double[] ray = Rays.towards(rays.outside(1e6), rays.inBox(1.0));
            BruteForce.Answer expected = bruteForce.closest(ray);

            Supplier<String> what = () -> Arrays.toString(ray) + " of seed 67, " + expected;
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
        RayTracer traversal = way.on(KDTree.of(mesh));
        for (double[] ray : new Rays(mesh, 69).any(4000)) {
            boolean found = Rays.closestHit(traversal, ray);
            double distance = traversal.distance();
            for (double factor : new double[] {0x1p-70, 1e-3, 7.3, 0x1p70}) {
                double[] longer = ray.clone();
                for (int k = 3; k < 6; k++) {
                    longer[k] = factor * ray[k];
                }

                Supplier<String> what = () -> Arrays.toString(longer) + " of seeds 68 and 69";
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
        RayTracer traversal = way.on(tree);
        Exhaustive exhaustive = new Exhaustive(tree);
        int hits = 0;
        for (double[] ray : new Rays(mesh, 71).any(4000)) {
            if (!Rays.closestHit(traversal, ray)) {
                continue;
            }
            hits++;
            double t = traversal.distance();
            double next = exhaustive.closest(ray, Math.nextUp(t), END);
            Supplier<String> what = () -> Arrays.toString(ray) + " of seeds 70 and 71";

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
        RayTracer traversal = way.on(KDTree.of(mesh));
        int hits = 0;
        for (double[] r : new Rays(mesh, 73).any(4000)) {
            Ray ray = new Ray(new Point3d(r[0], r[1], r[2]), new Vector3d(r[3], r[4], r[5]));
            Optional<Hit> hit = traversal.closestHit(ray);
            if (hit.isEmpty()) {
                continue;
            }
            hits++;
            Supplier<String> what = () -> ray + " of seeds 72 and 73";
            Optional<Hit> reference =
                    IntersectionHandler.rayTriangle(ray, mesh.triangle(hit.get().triangle()));
            assertThat(reference).as(what).isPresent();
            assertThat(hit.get().distance()).as(what).isCloseTo(reference.get().distance(), withinPercentage(1e-8));
            assertThat(hit.get().u()).as(what).isCloseTo(reference.get().u(), within(1e-9));
            assertThat(hit.get().v()).as(what).isCloseTo(reference.get().v(), within(1e-9));
        }
        assertThat(hits).isGreaterThan(1000);
    }

    /**
     * Copies of each triangle are scattered over the mesh's numbers, and over leaves, which come to them in their own
     * order.
     */
    @ParameterizedTest
    @EnumSource
    void ofTrianglesWithTheSameCornersTheLeastNumberIsNamed(Way way) {
        TriangleMesh single = Meshes.soup(300, 0.3, 71);
        int copies = 4;
        int[] order = new int[copies * single.triangleCount()];
        SplittableRandom random = new SplittableRandom(72);
        for (int i = 0; i < order.length; i++) {
            int other = random.nextInt(i + 1);
            order[i] = order[other];
            order[other] = i % single.triangleCount();
        }
        float[] corners = new float[9 * order.length];
        int[] least = new int[single.triangleCount()];
        for (int i = order.length - 1; i >= 0; i--) {
            least[order[i]] = i;
            for (int k = 0; k < 9; k++) {
                corners[9 * i + k] = single.coordinate(order[i], k / 3, k % 3);
            }
        }
        TriangleMesh mesh =
                TriangleMesh.of(corners, IntStream.range(0, 3 * order.length).toArray());
        RayTracer traversal = way.on(KDTree.of(mesh));
        int hits = 0;
        for (double[] ray : new Rays(mesh, 73).any(5000)) {
            if (Rays.closestHit(traversal, ray)) {
                assertThat(traversal.triangle())
                        .as("%s of seed 73", Arrays.toString(ray))
                        .isEqualTo(least[order[traversal.triangle()]]);
                hits++;
            }
        }
        assertThat(hits).isGreaterThan(1000);
    }

    @ParameterizedTest
    @EnumSource
    void ofTrianglesInTheSamePlaceTheFirstIsHit(Way way) {
        RayTracer traversal = way.on(KDTree.of(Meshes.degenerate().get("identical")));

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

    private static double[] trace(RayTracer traversal, double[][] rays) {
        return Arrays.stream(rays)
                .mapToDouble(ray -> Rays.closestHit(traversal, ray)
                        ? traversal.distance() + traversal.triangle() + traversal.u() + traversal.v()
                        : -1.0)
                .toArray();
    }
}
