package org.dronewatch.bvh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.fail;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.util.Arrays;
import java.util.Random;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.kdtree.StackTraversal;
import org.dronewatch.parallel.VectorInstructions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Rays of a packet hit what they hit one by one, bit for bit, and as far away as in the kd-tree. */
class RayPacketTest {
    private static final long SEED = 20261126;

    /** Where triangles meet in the very point, the tree may report another one. */
    private static final double LAST_BITS = 1e-15;

    /** A room of 10 x 8 x 4 m. */
    private static final float[] CORNERS = {0, 0, 0, 10, 0, 0, 10, 8, 0, 0, 8, 0, 0, 0, 4, 10, 0, 4, 10, 8, 4, 0, 8, 4};

    private static final int[] WALLS = {
        0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7
    };

    private final Random random = new Random(SEED);
    private final double[][] rays = new double[RayPacket.RAYS][6];
    private RayPacket packet;
    private RayTracer alone;
    private RayTracer inTree;
    private int hits;

    @BeforeEach
    void needVectors() {
        assumeTrue(VectorInstructions.areAvailable(), "no vectors of 256 bits, or the module of vectors is not named");
    }

    private void trace(float[] corners, int[] triangles) {
        KDTree tree = KDTree.of(TriangleMesh.of(corners, triangles));
        alone = new TracingIndex(tree).newIncoherentRayTracer();
        // Convex rooms have another one (ConvexRoomTest).
        packet = new FewTrianglesPacket(tree.triangles(), alone);
        inTree = new StackTraversal(tree);
        hits = 0;
    }

    private void compare() {
        for (int i = 0; i < rays.length; i++) {
            double[] r = rays[i];
            packet.set(i, r[0], r[1], r[2], r[3], r[4], r[5]);
        }
        packet.trace(rays.length);
        for (int i = 0; i < rays.length; i++) {
            double[] r = rays[i];
            boolean hit = alone.closestHit(r[0], r[1], r[2], r[3], r[4], r[5], 0.0, Double.POSITIVE_INFINITY);
            boolean same = packet.isHit(i) == hit;
            if (hit) {
                hits++;
                inTree.closestHit(r[0], r[1], r[2], r[3], r[4], r[5], 0.0, Double.POSITIVE_INFINITY);
                same &= packet.triangle(i) == alone.triangle()
                        && packet.distance(i) == alone.distance()
                        && Math.abs(packet.distance(i) - inTree.distance()) <= LAST_BITS * packet.distance(i);
            }
            if (!same) {
                fail("seed %d, ray %s", SEED, Arrays.toString(r));
            }
        }
    }

    private void draw(double[] ray) {
        for (int axis = 0; axis < 3; axis++) {
            ray[axis] = -2.0 + 14.0 * random.nextDouble();
            ray[axis + 3] = random.nextGaussian();
        }
    }

    /** From one point of a lattice to another one. */
    private void drawFromLattice(double[] ray, int x, int y, int z) {
        int[] limits = {x, y, z};
        do {
            for (int axis = 0; axis < 3; axis++) {
                ray[axis] = random.nextInt(limits[axis] + 1);
                ray[axis + 3] = random.nextInt(limits[axis] + 1) - ray[axis];
            }
        } while (ray[3] == 0.0 && ray[4] == 0.0 && ray[5] == 0.0);
    }

    /** In the plane of one of the triangles. */
    private void drawInPlane(double[] ray, float[] corners, int[] triangles) {
        int triangle = 3 * random.nextInt(triangles.length / 3);
        int along = random.nextInt(7) - 3;
        int across = random.nextInt(7) - 3;
        for (int axis = 0; axis < 3; axis++) {
            float a = corners[3 * triangles[triangle] + axis];
            float b = corners[3 * triangles[triangle + 1] + axis];
            float c = corners[3 * triangles[triangle + 2] + axis];
            ray[axis] = a + along * (b - a) + across * (c - a);
            ray[axis + 3] = (2 - across) * (b - a) + (1 - along) * (c - a);
        }
        if (ray[3] == 0.0 && ray[4] == 0.0 && ray[5] == 0.0) {
            draw(ray);
        }
    }

    /** From inside and outside; the axis of a ray's largest component often changes. */
    @Test
    void randomRaysInARoom() {
        trace(CORNERS, WALLS);
        for (int i = 0; i < 10_000; i++) {
            draw(rays[random.nextInt(rays.length)]);
            compare();
        }
        assertThat(hits).isBetween(10_000, 35_000);
    }

    /** Among them rays within walls, and along edges. */
    @Test
    void raysThroughEdgesAndCorners() {
        trace(CORNERS, WALLS);
        for (int i = 0; i < 10_000; i++) {
            drawFromLattice(rays[i % rays.length], 10, 8, 4);
            compare();
        }
        assertThat(hits).isGreaterThan(35_000);
    }

    /** Coinciding, thin, and without area; some rays lie in their planes. */
    @Test
    void trianglesOfAllKinds() {
        for (int mesh = 0; mesh < 200; mesh++) {
            int[] triangles = new int[3 * (1 + random.nextInt(FewTriangles.MOST))];
            float[] corners = new float[3 * 12];
            for (int i = 0; i < corners.length; i++) {
                corners[i] = mesh % 2 == 0 ? random.nextInt(5) : 5.0f * random.nextFloat();
            }
            for (int i = 0; i < triangles.length; i++) {
                triangles[i] = random.nextInt(12);
            }
            trace(corners, triangles);
            for (int i = 0; i < 100; i++) {
                drawInPlane(rays[0], corners, triangles);
                drawFromLattice(rays[1], 4, 4, 4);
                draw(rays[2 + random.nextInt(2)]);
                compare();
            }
        }
    }

    @Test
    void largerMeshesHaveNone() {
        int[] triangles = new int[3 * (FewTriangles.MOST + 1)];
        for (int i = 0; i < triangles.length; i++) {
            triangles[i] = WALLS[i % WALLS.length];
        }
        KDTree tree = KDTree.of(TriangleMesh.of(CORNERS, triangles));
        assertThat(new TracingIndex(tree).newRayPacket()).isEmpty();
        KDTree room = KDTree.of(TriangleMesh.of(CORNERS, WALLS));
        assertThat(new TracingIndex(room, RayTraversal.STACK).newRayPacket().orElseThrow())
                .as("convex rooms always have one")
                .isInstanceOf(ConvexRoomPacket.class);
    }
}
