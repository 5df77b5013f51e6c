package org.dronewatch.kdtree;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.Set;
import java.util.SplittableRandom;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.junit.jupiter.api.Test;

class EllipsoidQueryTest {
    /**
     * Every triangle of which a sampled point is inside, and in the plane if one is asked for, is found, and none
     * twice.
     */
    @Test
    void whatReachesIntoTheEllipsoidIsFound() {
        long seed = 77;
        SplittableRandom random = new SplittableRandom(seed);
        float[] vertices = new float[9 * 3000];
        int[] corners = new int[3 * 3000];
        for (int i = 0; i < 3000; i++) {
            Position at = point(random, 50);
            for (int k = 0; k < 3; k++) {
                Position corner = at.plus(point(random, i % 50 == 0 ? 40 : 2));
                vertices[9 * i + 3 * k] = (float) corner.x();
                vertices[9 * i + 3 * k + 1] = (float) corner.y();
                vertices[9 * i + 3 * k + 2] = (float) corner.z();
                corners[3 * i + k] = 3 * i + k;
            }
        }
        TriangleMesh mesh = TriangleMesh.of(vertices, corners);
        EllipsoidQuery query = new EllipsoidQuery(KDTree.of(mesh));
        int inside = 0;
        int answered = 0;
        for (int run = 0; run < 40; run++) {
            Position a = point(random, 50);
            Position b = point(random, 50);
            double sum = a.distance(b) + Math.pow(10, 4 * random.nextDouble() - 2.5);
            Position normal = b.minus(a).cross(point(random, 1)).unit();
            for (boolean atPlane : new boolean[] {false, true}) {
                if (atPlane) {
                    query.findAtPlane(a, b, sum, normal, 1e-7);
                } else {
                    query.find(a, b, sum);
                }
                Set<Integer> found = new HashSet<>();
                for (int i = 0; i < query.count(); i++) {
                    assertThat(found.add(query.triangle(i))).as("once").isTrue();
                    assertIsNear(mesh, query, i, a, b, sum, atPlane ? normal : null);
                }
                answered += query.count();
                for (int i = 0; i < mesh.triangleCount(); i++) {
                    if (reaches(mesh, i, a, b, sum, atPlane ? normal : null)) {
                        inside++;
                        assertThat(found).as("seed %d, run %d", seed, run).contains(i);
                    }
                }
            }
        }
        assertThat(inside).isGreaterThan(2000);
        assertThat(answered).as("boxes, not all triangles").isLessThan(2 * inside);
    }

    /** The box of a triangle found reaches into the ellipsoid and, if there is a plane, the triangle into the plane. */
    private static void assertIsNear(
            TriangleMesh mesh, EllipsoidQuery query, int found, Position a, Position b, double sum, Position normal) {
        int triangle = query.triangle(found);
        Position low = corner(mesh, triangle, 0);
        Position high = low;
        double lowest = Double.POSITIVE_INFINITY;
        double highest = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < 3; k++) {
            Position at = corner(mesh, triangle, k);
            assertThat(new Position(
                            query.coordinate(found, k, 0),
                            query.coordinate(found, k, 1),
                            query.coordinate(found, k, 2)))
                    .isEqualTo(at);
            low = new Position(Math.min(low.x(), at.x()), Math.min(low.y(), at.y()), Math.min(low.z(), at.z()));
            high = new Position(Math.max(high.x(), at.x()), Math.max(high.y(), at.y()), Math.max(high.z(), at.z()));
            lowest = normal == null ? 0 : Math.min(lowest, at.minus(a).dot(normal));
            highest = normal == null ? 0 : Math.max(highest, at.minus(a).dot(normal));
        }
        assertThat(lowest).isLessThanOrEqualTo(1.1e-7);
        assertThat(highest).isGreaterThanOrEqualTo(-1.1e-7);
        assertThat(a.distance(nearest(a, low, high)) + b.distance(nearest(b, low, high)))
                .isLessThanOrEqualTo(sum * (1 + 1e-9));
    }

    private static Position nearest(Position point, Position low, Position high) {
        return new Position(
                Math.max(low.x(), Math.min(high.x(), point.x())),
                Math.max(low.y(), Math.min(high.y(), point.y())),
                Math.max(low.z(), Math.min(high.z(), point.z())));
    }

    private static boolean reaches(
            TriangleMesh mesh, int triangle, Position a, Position b, double sum, Position normal) {
        int n = 12;
        boolean before = false;
        boolean behind = false;
        boolean near = false;
        for (int i = 0; i <= n; i++) {
            for (int j = 0; i + j <= n; j++) {
                double p = (double) i / n;
                double q = (double) j / n;
                Position at = corner(mesh, triangle, 0)
                        .times(1 - p - q)
                        .plus(corner(mesh, triangle, 1).times(p))
                        .plus(corner(mesh, triangle, 2).times(q));
                near |= a.distance(at) + at.distance(b) <= sum;
                before |= normal == null || at.minus(a).dot(normal) >= 0;
                behind |= normal == null || at.minus(a).dot(normal) <= 0;
            }
        }
        return near && before && behind;
    }

    private static Position corner(TriangleMesh mesh, int triangle, int k) {
        return new Position(
                mesh.coordinate(triangle, k, 0), mesh.coordinate(triangle, k, 1), mesh.coordinate(triangle, k, 2));
    }

    private static Position point(SplittableRandom random, double half) {
        return new Position(
                half * (2 * random.nextDouble() - 1),
                half * (2 * random.nextDouble() - 1),
                half * (2 * random.nextDouble() - 1));
    }
}
