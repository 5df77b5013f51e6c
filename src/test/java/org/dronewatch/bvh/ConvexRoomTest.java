package org.dronewatch.bvh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.kdtree.StackTraversal;
import org.dronewatch.parallel.VectorInstructions;
import org.junit.jupiter.api.Test;

/** Which meshes are convex rooms, and what rays hit in them. */
class ConvexRoomTest {
    private static final long SEED = 20261127;
    private static final double END = Double.POSITIVE_INFINITY;

    /** A room of 10 x 8 x 4 m. */
    private static final float[] BOX = {0, 0, 0, 10, 0, 0, 10, 8, 0, 0, 8, 0, 0, 0, 4, 10, 0, 4, 10, 8, 4, 0, 8, 4};

    private static final int[] WALLS = {
        0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7
    };

    private static final float[] TENT = {-3, -2, 0, 5, -2, 0, 1, 6, 0, 1, 1, 5};
    private static final int[] FOUR = {0, 1, 2, 0, 1, 3, 1, 2, 3, 2, 0, 3};

    private final Random random = new Random(SEED);

    private static Optional<ConvexRoom> room(float[] corners, int... triangles) {
        return ConvexRoom.of(KDTree.of(TriangleMesh.of(corners, triangles)).triangles());
    }

    private static int walls(float[] corners, int... triangles) {
        return room(corners, triangles).orElseThrow().count();
    }

    private static float[] with(float[] corners, float... more) {
        float[] all = Arrays.copyOf(corners, corners.length + more.length);
        System.arraycopy(more, 0, all, corners.length, more.length);
        return all;
    }

    private static int[] with(int[] triangles, int... more) {
        int[] all = Arrays.copyOf(triangles, triangles.length + more.length);
        System.arraycopy(more, 0, all, triangles.length, more.length);
        return all;
    }

    @Test
    void boxesAndTentsAreConvex() {
        assertThat(walls(BOX, WALLS)).isEqualTo(6);
        assertThat(walls(TENT, FOUR)).isEqualTo(4);
        float[] octahedron = {1, 0, 0, 0, 1, 0, 0, 0, 1, -1, 0, 0, 0, -1, 0, 0, 0, -1};
        int[] faces = {0, 1, 2, 1, 3, 2, 3, 4, 2, 4, 0, 2, 0, 1, 5, 1, 3, 5, 3, 4, 5, 4, 0, 5};
        assertThat(walls(octahedron, faces)).isEqualTo(8);
        int[] turned = WALLS.clone();
        turned[3] = 3;
        turned[4] = 0;
        assertThat(walls(BOX, turned)).as("a triangle the other way around").isEqualTo(6);
    }

    @Test
    void roomsThatAreOpenOrHoldSomethingAreNot() {
        assertThat(room(BOX, Arrays.copyOf(WALLS, 33)))
                .as("a triangle is missing")
                .isEmpty();
        assertThat(room(BOX, Arrays.copyOf(WALLS, 30))).as("a wall is missing").isEmpty();
        assertThat(room(with(BOX, 5, 4, 2), with(WALLS, 0, 1, 8)))
                .as("something inside")
                .isEmpty();
        assertThat(room(BOX, with(WALLS, 0, 1, 6))).as("a partition").isEmpty();
        assertThat(room(BOX, with(WALLS, 0, 2, 1))).as("a triangle twice").isEmpty();
        assertThat(room(BOX, with(WALLS, 0, 1, 1)))
                .as("a triangle without area")
                .isEmpty();
        float[] dented = BOX.clone();
        dented[20] = 3.5f;
        assertThat(room(dented, WALLS)).as("a corner pressed in").isEmpty();
    }

    @Test
    void thereIsNoRoomWithoutTriangles() {
        assertThat(room(new float[0])).isEmpty();
        assertThat(new TracingIndex(KDTree.of(TriangleMesh.of(new float[0], new int[0]))).newRayPacket())
                .isEmpty();
    }

    /** Each edge of these is one of two triangles, as in a closed room. */
    @Test
    void sheetsOfTwoLayersAreNot() {
        assertThat(room(TENT, 0, 1, 2, 0, 2, 1)).isEmpty();
        assertThat(room(TENT, 0, 1, 2, 0, 2, 1, 0, 1, 3, 0, 3, 1)).isEmpty();
    }

    private static void trace(double[][] rays, RayPacket packet) {
        for (int i = 0; i < rays.length; i++) {
            double[] r = rays[i];
            packet.set(i, r[0], r[1], r[2], r[3], r[4], r[5]);
        }
        packet.trace(rays.length);
    }

    private static void compare(double[] ray, RayPacket packet, int number, RayTracer tree, TriangleMesh mesh) {
        String shown = String.format(Locale.ROOT, "seed %d, ray %s", SEED, Arrays.toString(ray));
        boolean hit = tree.closestHit(ray[0], ray[1], ray[2], ray[3], ray[4], ray[5], 0.0, END);
        assertThat(packet.isHit(number)).as(shown).isEqualTo(hit);
        if (hit) {
            // Coordinates of some 10 m are exact to 1e-15 m; a ray that grazes a wall makes more of that.
            double[] normal = new double[3];
            mesh.normal(tree.triangle(), normal);
            double cosine = Math.abs(normal[0] * ray[3] + normal[1] * ray[4] + normal[2] * ray[5])
                    / Math.sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
            assertThat(packet.distance(number)).as(shown).isCloseTo(tree.distance(), within(2e-14 / cosine));
            assertThat(packet.triangle(number)).as(shown).isEqualTo(tree.triangle());
        }
    }

    /** A ray from inside or, now and then, from outside. */
    private double[] ray(float[] corners) {
        double[] ray = new double[6];
        int from = random.nextInt(corners.length / 3);
        double part = random.nextInt(10) == 0 ? 1.5 : random.nextDouble();
        for (int axis = 0; axis < 3; axis++) {
            double middle = 0.0;
            for (int i = axis; i < corners.length; i += 3) {
                middle += corners[i] / (corners.length / 3);
            }
            ray[axis] = middle + part * (corners[3 * from + axis] - middle) * random.nextDouble();
            ray[axis + 3] = random.nextGaussian();
        }
        double length = Math.sqrt(ray[3] * ray[3] + ray[4] * ray[4] + ray[5] * ray[5]);
        for (int axis = 3; axis < 6; axis++) {
            ray[axis] /= length;
        }
        return ray;
    }

    @Test
    void raysHitWhatTheyHitInTheKdTree() {
        float[] oblique = {0, 0, 0, 9, 1, 0, 10, 7, 1, -1, 6, 0, 1, 0, 5};
        int[] pyramid = {0, 1, 3, 1, 2, 3, 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
        for (float[] corners : List.of(BOX, TENT, oblique)) {
            int[] triangles = corners == BOX ? WALLS : corners == TENT ? FOUR : pyramid;
            TriangleMesh mesh = TriangleMesh.of(corners, triangles);
            KDTree tree = KDTree.of(mesh);
            RayPacket packet = new TracingIndex(tree).newRayPacket().orElseThrow();
            assertThat(packet).isInstanceOf(ConvexRoomPacket.class);
            RayTracer inTree = new StackTraversal(tree);
            for (int i = 0; i < 5_000; i++) {
                double[][] rays = new double[1 + i % RayPacket.RAYS][];
                Arrays.setAll(rays, k -> ray(corners));
                trace(rays, packet);
                for (int k = 0; k < rays.length; k++) {
                    compare(rays[k], packet, k, inTree, mesh);
                }
            }
        }
    }

    /** With vectors or without, alone or with others, the same ray hits the same, bit for bit. */
    @Test
    void vectorsAndOtherRaysChangeNothing() {
        assumeTrue(VectorInstructions.areAvailable(), "no vectors of 256 bits, or the module of vectors is not named");
        KDTree tree = KDTree.of(TriangleMesh.of(BOX, WALLS));
        RayTracer one = new StackTraversal(tree);
        ConvexRoom room = room(BOX, WALLS).orElseThrow();
        RayPacket vectors = new VectorConvexRoomPacket(tree.triangles(), room, one);
        RayPacket plain = new ConvexRoomPacket(tree.triangles(), room, one);
        int hits = 0;
        for (int i = 0; i < 2_000; i++) {
            double[][] rays = new double[RayPacket.RAYS][];
            Arrays.setAll(rays, k -> ray(BOX));
            trace(rays, vectors);
            for (int k = 0; k < rays.length; k++) {
                trace(new double[][] {rays[k]}, plain);
                assertThat(plain.isHit(0)).isEqualTo(vectors.isHit(k));
                if (plain.isHit(0)) {
                    hits++;
                    assertThat(plain.distance(0)).isEqualTo(vectors.distance(k));
                    assertThat(plain.triangle(0)).isEqualTo(vectors.triangle(k));
                }
            }
        }
        assertThat(hits).isGreaterThan(7_000);
    }

    /** From a wall, an edge or a corner, along a wall or an edge. */
    @Test
    void raysFromWallsHitWhatTheyHitAlone() {
        KDTree tree = KDTree.of(TriangleMesh.of(BOX, WALLS));
        TracingIndex index = new TracingIndex(tree);
        RayPacket packet = index.newRayPacket().orElseThrow();
        RayTracer alone = index.newIncoherentRayTracer();
        int hits = 0;
        for (int i = 0; i < 5_000; i++) {
            int wall = random.nextInt(6);
            double[] r = {random.nextInt(11), random.nextInt(9), random.nextInt(5), 0, 0, 0};
            r[wall / 2] = wall % 2 == 0 ? 0 : new int[] {10, 8, 4}[wall / 2];
            for (int axis = 3; axis < 6; axis++) {
                r[axis] = random.nextInt(3) - 1;
            }
            if (r[3] != 0.0 || r[4] != 0.0 || r[5] != 0.0) {
                packet.set(0, r[0], r[1], r[2], r[3], r[4], r[5]);
                packet.trace(1);
                boolean hit = alone.closestHit(r[0], r[1], r[2], r[3], r[4], r[5], 0.0, END);
                assertThat(packet.isHit(0)).as(Arrays.toString(r)).isEqualTo(hit);
                if (hit) {
                    hits++;
                    assertThat(packet.distance(0)).as(Arrays.toString(r)).isEqualTo(alone.distance());
                    assertThat(packet.triangle(0)).as(Arrays.toString(r)).isEqualTo(alone.triangle());
                }
            }
        }
        assertThat(hits).isGreaterThan(1_000);
    }
}
