package org.dronewatch.kdtree;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.dronewatch.geometry.TriangleMesh;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Rays in the plane of a triangle: its edge functions are zero, or roundings, however far beside it the ray passes. */
class EdgeOnTest {
    private static final double END = Double.POSITIVE_INFINITY;

    /** How near to an edge rounding may take a miss for a hit, m. */
    private static final double ROUNDINGS = 1e-9;

    @ParameterizedTest
    @EnumSource
    void aTriangleSeenEdgeOnIsNotHitFromBeside(Way way) {
        TriangleMesh mesh = mesh(3, 3, 2, 1, 1, 6, 1, 5, 4, 3, 3, 3, 0, 7, 6, 7, 4, 6, 7, 6, 0, 7, 6, 4, 3, 3, 0);
        double[] ray = {3, 7, 0, 3, -7, -1};
        assertThat(new BruteForce(mesh).closest(ray).found()).isFalse();
        RayTracer tracer = way.on(KDTree.of(mesh));
        assertThat(Way.closest(tracer, ray)).isEqualTo(END);
        assertThat(Rays.isOccluded(tracer, ray, 0.0, END)).isFalse();
    }

    /** Triangles and rays on a lattice of whole numbers, each ray in the plane of one of the triangles. */
    @ParameterizedTest
    @EnumSource
    void raysInThePlaneOfATriangle(Way way) {
        long seed = 22452;
        SplittableRandom random = new SplittableRandom(seed);
        int missed = 0;
        for (int number = 0; number < 3_000; number++) {
            float[] corners = new float[9 * (1 + random.nextInt(4))];
            for (int i = 0; i < corners.length; i++) {
                corners[i] = random.nextInt(9);
            }
            TriangleMesh mesh = mesh(corners);
            RayTracer tracer = way.on(KDTree.of(mesh));
            BruteForce exact = new BruteForce(mesh);
            for (int i = 0; i < 20; i++) {
                double[] ray = inPlaneOf(mesh, random);
                double found = Way.closest(tracer, ray);
                String what = "seed %d, mesh %d %s, ray %s"
                        .formatted(seed, number, Arrays.toString(corners), Arrays.toString(ray));
                if (found < END && !(Math.abs(exact.hit(ray, tracer.triangle()) - found) < ROUNDINGS)) {
                    assertThat(exact.edgeDistance(ray, tracer.triangle()))
                            .as(what)
                            .isLessThan(ROUNDINGS);
                }
                missed += found == END ? 1 : 0;
                // Whether a ray that starts on a triangle meets it there is left open.
                if (!(found < ROUNDINGS)) {
                    assertThat(Rays.isOccluded(tracer, ray, 0.0, END)).as(what).isEqualTo(found < END);
                }
            }
        }
        assertThat(missed).as("rays of seed %d that pass beside", seed).isGreaterThan(10_000);
    }

    private static TriangleMesh mesh(float... corners) {
        return TriangleMesh.of(corners, IntStream.range(0, corners.length / 3).toArray());
    }

    /** From a point of the first triangle's plane along a direction in it, both whole numbers. */
    private static double[] inPlaneOf(TriangleMesh mesh, SplittableRandom random) {
        double[] ray = new double[6];
        int[] weights = {random.nextInt(-3, 4), random.nextInt(-3, 4), random.nextInt(-3, 4), random.nextInt(-3, 4)};
        for (int axis = 0; axis < 3; axis++) {
            double a = mesh.coordinate(0, 0, axis);
            double b = mesh.coordinate(0, 1, axis) - a;
            double c = mesh.coordinate(0, 2, axis) - a;
            ray[axis] = a + weights[0] * b + weights[1] * c;
            ray[3 + axis] = weights[2] * b + weights[3] * c;
        }
        if (ray[3] == 0.0 && ray[4] == 0.0 && ray[5] == 0.0) {
            ray[3] = 1.0;
        }
        return ray;
    }
}
