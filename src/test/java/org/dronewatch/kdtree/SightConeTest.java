package org.dronewatch.kdtree;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.junit.jupiter.api.Test;

/** Clear lines of sight to a sphere against rays. */
class SightConeTest {
    @Test
    void noRayToASphereThatIsClearMeetsATriangle() {
        long seed = System.nanoTime();
        System.out.println("SightConeTest: seed " + seed);
        SplittableRandom random = new SplittableRandom(seed);
        int triangles = 400;
        float[] vertices = new float[9 * triangles];
        int[] corners = new int[3 * triangles];
        for (int i = 0; i < triangles; i++) {
            Position at = point(random, 50);
            for (int k = 0; k < 3; k++) {
                Position corner = at.plus(point(random, i % 20 == 0 ? 60 : 3));
                vertices[9 * i + 3 * k] = (float) corner.x();
                vertices[9 * i + 3 * k + 1] = (float) corner.y();
                vertices[9 * i + 3 * k + 2] = (float) corner.z();
                corners[3 * i + k] = 3 * i + k;
            }
        }
        KDTree tree = KDTree.of(TriangleMesh.of(vertices, corners));
        StackTraversal rays = new StackTraversal(tree);
        int clear = 0;
        int free = 0;
        for (int i = 0; i < 3000; i++) {
            Position from = point(random, 60);
            Position at = point(random, 60);
            double radius = Math.pow(random.nextDouble(), 3);
            boolean isClear = new SightCone(tree, from).isClear(at, radius);
            boolean isFree = true;
            for (int k = 0; k < 60; k++) {
                Position aside = point(random, 1).unit().times(radius);
                Position ray = at.plus(aside).minus(from);
                isFree &= !rays.closestHit(from.x(), from.y(), from.z(), ray.x(), ray.y(), ray.z(), 0.0, 1.0);
            }
            assertThat(isClear && !isFree).as("seed %d, run %d", seed, i).isFalse();
            clear += isClear ? 1 : 0;
            free += isFree ? 1 : 0;
        }
        assertThat(free).as("seed %d", seed).isGreaterThan(300);
        assertThat(clear).as("seed %d: of %d that are free", seed, free).isGreaterThan(free / 2);
    }

    private static Position point(SplittableRandom random, double half) {
        return new Position(
                half * (2 * random.nextDouble() - 1),
                half * (2 * random.nextDouble() - 1),
                half * (2 * random.nextDouble() - 1));
    }
}
