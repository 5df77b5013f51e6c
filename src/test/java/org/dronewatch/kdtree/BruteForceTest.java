package org.dronewatch.kdtree;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.bvh.TracingIndex;
import org.dronewatch.geometry.TriangleMesh;
import org.junit.jupiter.api.Test;

/** The tree's answers against those of {@link BruteForce}: 140,000 rays, by both traversals. */
class BruteForceTest {
    private static final double SAME = 1e-5;
    /** A ray this near to an edge, relative to the mesh's size, may be judged either way. */
    private static final double EDGE = 1e-6;

    @Thorough
    @Test
    void hill() {
        compare("hill", Meshes.model("hill.obj"), 5_000, 101);
    }

    @Test
    void quadrotor() {
        compare("quadrotor", Meshes.model("quadrotor.obj"), 15_000, 102);
    }

    @Test
    void room() {
        compare("room", Meshes.room(), 40_000, 103);
    }

    @Test
    void randomTriangles() {
        compare("small triangles", Meshes.soup(2000, 0.05, 104), 15_000, 105);
        compare("large triangles", Meshes.soup(300, 0.9, 106), 17_000, 107);
    }

    @Test
    void degenerateMeshes() {
        for (Map.Entry<String, TriangleMesh> entry : Meshes.degenerate().entrySet()) {
            compare(entry.getKey(), entry.getValue(), 4_000, 108);
        }
    }

    private static void compare(String name, TriangleMesh mesh, int most, long seed) {
        int count = LongForm.count(most / 8, most);
        KDTree tree = KDTree.of(mesh);
        BruteForce bruteForce = new BruteForce(mesh);
        double[][] rays = new Rays(mesh, seed).any(count);
        BruteForce.Answer[] answers = IntStream.range(0, count)
                .parallel()
                .mapToObj(i -> bruteForce.closest(rays[i]))
                .toArray(BruteForce.Answer[]::new);
        double size = mesh.triangleCount() == 0 ? 0.0 : mesh.bounds().diagonal();

        for (RayTracer traversal : List.of(
                new StackTraversal(tree),
                new SequentialTraversal(tree),
                new TracingIndex(tree).newIncoherentRayTracer())) {
            List<String> excused = new ArrayList<>();
            List<String> wrong = new ArrayList<>();
            int hits = 0;
            for (int i = 0; i < count; i++) {
                boolean found = Rays.closestHit(traversal, rays[i]);
                hits += found ? 1 : 0;
                String difference = difference(traversal, found, rays[i], answers[i]);
                if (!difference.isEmpty()) {
                    boolean onEdge =
                            answers[i].found() && bruteForce.edgeDistance(rays[i], answers[i].triangle()) <= EDGE * size
                                    || found && bruteForce.edgeDistance(rays[i], traversal.triangle()) <= EDGE * size;
                    (onEdge ? excused : wrong).add(Arrays.toString(rays[i]) + ": " + difference);
                }
            }
            assertThat(wrong)
                    .as(
                            "%s, %s: wrong of %d rays of seed %d with %d hits; excused on edges: %s",
                            name, traversal.getClass().getSimpleName(), count, seed, hits, excused)
                    .isEmpty();
            // One ray in eight is aimed at a triangle; at a sliver, that is at an edge.
            assertThat(excused)
                    .as(
                            "%s, %s: excused of %d rays of seed %d",
                            name, traversal.getClass().getSimpleName(), count, seed)
                    .hasSizeLessThanOrEqualTo(name.equals("slivers") ? count / 8 : count / 1000);
        }
    }

    private static String difference(RayTracer traversal, boolean found, double[] ray, BruteForce.Answer expected) {
        if (found != expected.found()) {
            return found ? "hits triangle " + traversal.triangle() : "misses triangle " + expected.triangle();
        }
        if (!found) {
            return Rays.isOccluded(traversal, ray, 0.0, Double.POSITIVE_INFINITY) ? "is occluded by nothing" : "";
        }
        double t = traversal.distance();
        if (Math.abs(t - expected.distance()) > SAME * expected.distance()) {
            return "hits " + traversal.triangle() + " at " + t + " and not " + expected;
        }
        if (Rays.isOccluded(traversal, ray, 0.0, expected.distance() * (1 - SAME))) {
            return "is occluded before " + expected;
        }
        return Rays.isOccluded(traversal, ray, 0.0, expected.distance() * (1 + SAME))
                ? ""
                : "is not occluded behind " + expected;
    }
}
