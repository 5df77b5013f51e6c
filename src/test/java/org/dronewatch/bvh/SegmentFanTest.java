package org.dronewatch.bvh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.util.Random;
import org.dronewatch.LongForm;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.Meshes;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.kdtree.StackTraversal;
import org.dronewatch.parallel.VectorInstructions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Segments that are traced together have the answers of single ones. */
class SegmentFanTest {
    private static final int TARGETS = 3_000;

    @BeforeEach
    void needVectors() {
        assumeTrue(VectorInstructions.areAvailable(), "no vectors of 256 bits, or the module of vectors is not named");
    }

    @ParameterizedTest
    @CsvSource({"house.obj, 0", "house.obj, 1e-5", "quadrotor.obj, 1e-5", "hill.obj, 0", "cathedral.obj, 1e-5"})
    void targetsInTheAirAndOnSurfaces(String model, double skipped) {
        boolean isLarge = model.startsWith("hill") || model.startsWith("cathedral");
        assumeTrue(!isLarge || LongForm.IS_ON, "large models in the long form only");
        check(Meshes.model(model), skipped, 4, 20261126);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 5, 40, 300})
    void randomTriangles(int triangles) {
        Random random = new Random(triangles);
        float[] corners = new float[9 * triangles];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = 10.0f * random.nextFloat() - 5.0f;
        }
        check(mesh(corners), 0.0, 6, triangles);
        check(mesh(corners), 1e-5, 6, triangles);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 1e3, 1e6, 1e9, 1e11})
    void coordinatesOfAnySize(double scale) {
        Random random = new Random(7);
        float[] corners = new float[9 * 100];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = (float) (scale * (1.0 + 0.01 * random.nextInt(20)));
        }
        check(mesh(corners), 0.0, 6, 7);
    }

    /** Faces in the planes of the axes, seen edge-on from origins that lie in their planes, and targets there. */
    @Test
    void wallsSeenEdgeOn() {
        Random random = new Random(11);
        float[] corners = new float[9 * 200];
        for (int triangle = 0; triangle < 200; triangle++) {
            int axis = random.nextInt(3);
            float plane = random.nextInt(5);
            for (int i = 0; i < 9; i++) {
                corners[9 * triangle + i] = i % 3 == axis ? plane : random.nextInt(5);
            }
        }
        TriangleMesh mesh = mesh(corners);
        KDTree tree = KDTree.of(mesh);
        double[] vectors = new double[3 * TARGETS];
        for (int origin = 0; origin < 12; origin++) {
            double[] from = {random.nextInt(5), random.nextInt(5), 0.5 * random.nextInt(9)};
            for (int i = 0; i < vectors.length; i++) {
                vectors[i] = 0.25 * random.nextInt(21) - from[i % 3];
            }
            check(tree, from, vectors, 1e-5, "origin " + origin);
        }
    }

    @Test
    void segmentsWithoutLengthAndVeryLongOnes() {
        TriangleMesh mesh = Meshes.model("house.obj");
        AABB box = mesh.bounds();
        double[] from = {box.minX() - 1.0, 0.5 * (box.minY() + box.maxY()), 0.5 * (box.minZ() + box.maxZ())};
        double[] vectors = new double[3 * 700];
        Random random = new Random(3);
        double[] sizes = {0.0, 1e-300, 1e-20, 1e-9, 1e-6, 1.0, 1e3, 1e9, 1e12, 1e100};
        for (int i = 0; i < vectors.length; i++) {
            vectors[i] = sizes[i / 3 % sizes.length] * random.nextGaussian();
        }
        check(KDTree.of(mesh), from, vectors, 0.0, "sizes");
        check(KDTree.of(mesh), from, vectors, 1e-5, "sizes");
        check(KDTree.of(mesh), new double[] {1e15, 0.0, 0.0}, vectors, 0.0, "a far origin");
    }

    @Test
    void noSegmentsAndNoTriangles() {
        boolean[] hidden = {true};
        new TracingIndex(KDTree.of(Meshes.model("house.obj")))
                .newSegmentFan()
                .trace(0, 0, 0, new double[0], 0, 0, hidden);
        assertThat(hidden).containsExactly(true);
        new TracingIndex(KDTree.of(mesh(new float[0])))
                .newSegmentFan()
                .trace(0, 0, 0, new double[] {1, 2, 3}, 1, 0, hidden);
        assertThat(hidden).containsExactly(false);
    }

    private static TriangleMesh mesh(float[] corners) {
        int[] numbers = new int[corners.length / 3];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = i;
        }
        return TriangleMesh.of(corners, numbers);
    }

    private static void check(TriangleMesh mesh, double skipped, int origins, long seed) {
        KDTree tree = KDTree.of(mesh);
        Random random = new Random(seed);
        int some = 0;
        for (int origin = 0; origin < origins; origin++) {
            // If nothing is skipped, rounding decides whether the surface hides what lies behind an origin on it.
            double[] from = skipped == 0.0 || origin % 2 == 0 ? inside(mesh.bounds(), random) : onSurface(mesh, random);
            double[] vectors = new double[3 * TARGETS];
            for (int i = 0; i < TARGETS; i++) {
                double[] to = target(i, mesh, from, skipped == 0.0, random);
                for (int axis = 0; axis < 3; axis++) {
                    vectors[3 * i + axis] = to[axis] - from[axis];
                }
            }
            some += check(tree, from, vectors, skipped, "seed " + seed + ", origin " + origin);
        }
        assertThat(some).as("seed %d: hidden segments", seed).isPositive();
    }

    /**
     * In the air, on a surface, close to one, or all in one direction. On a surface only if some length is skipped:
     * otherwise rounding decides whether the target's own surface hides it, and single rays then differ from each
     * other.
     */
    private static double[] target(int number, TriangleMesh mesh, double[] from, boolean isExact, Random random) {
        boolean isInTheAir = number % 4 == 0 || isExact && number % 4 == 1;
        double[] at = isInTheAir ? inside(mesh.bounds(), random) : onSurface(mesh, random);
        if (number % 4 == 2) {
            for (int axis = 0; axis < 3; axis++) {
                at[axis] += 1e-5 * random.nextGaussian();
            }
        }
        if (number % 4 == 3) {
            for (int axis = 0; axis < 3; axis++) {
                at[axis] = from[axis] + random.nextDouble() * (mesh.coordinate(0, 0, axis) - from[axis]);
            }
        }
        return at;
    }

    private static double[] inside(AABB box, Random random) {
        return new double[] {
            box.minX() + random.nextDouble() * (box.maxX() - box.minX()),
            box.minY() + random.nextDouble() * (box.maxY() - box.minY()),
            box.minZ() + random.nextDouble() * (box.maxZ() - box.minZ())
        };
    }

    private static double[] onSurface(TriangleMesh mesh, Random random) {
        int triangle = random.nextInt(mesh.triangleCount());
        double u = random.nextDouble();
        double v = (1.0 - u) * random.nextDouble();
        double[] at = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            at[axis] = (1.0 - u - v) * mesh.coordinate(triangle, 0, axis)
                    + u * mesh.coordinate(triangle, 1, axis)
                    + v * mesh.coordinate(triangle, 2, axis);
        }
        return at;
    }

    /** Returns how many are hidden. */
    private static int check(KDTree tree, double[] from, double[] vectors, double skipped, String name) {
        int count = vectors.length / 3;
        boolean[] hidden = new boolean[count];
        new TracingIndex(tree).newSegmentFan().trace(from[0], from[1], from[2], vectors, count, skipped, hidden);
        RayTracer single = new StackTraversal(tree);
        int some = 0;
        for (int i = 0; i < count; i++) {
            double x = vectors[3 * i];
            double y = vectors[3 * i + 1];
            double z = vectors[3 * i + 2];
            double start = skipped == 0.0 ? 0.0 : skipped / Math.sqrt(x * x + y * y + z * z);
            boolean isHidden = x * x + y * y + z * z > 0.0
                    && single.isOccluded(from[0], from[1], from[2], x, y, z, start, 1.0 - start);
            assertThat(hidden[i]).as("%s, segment %d", name, i).isEqualTo(isHidden);
            some += isHidden ? 1 : 0;
        }
        return some;
    }
}
