package org.dronewatch.drone.silhouette;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.kdtree.StackTraversal;
import org.dronewatch.sensor.camera.Shapes;
import org.dronewatch.world.World;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Masks of silhouettes against rays: what a mask is certain about holds for every ray from anywhere. */
class SilhouetteTableTest {
    private static final int DIRECTIONS = 16;
    private static final int RAYS = 1500;

    static Stream<Arguments> shapes() {
        return Stream.of(
                Arguments.of("box", Shapes.box(new Position(-0.4, -0.2, -0.1), new Position(0.4, 0.2, 0.1)), 0.5),
                // Seen along y they overlap; seen a degree from there, a gap opens between them.
                Arguments.of("two plates, one behind the other", plates(), 0.1),
                Arguments.of("random triangles", soup(), 0.02));
    }

    @ParameterizedTest
    @MethodSource("shapes")
    void whatAMaskIsCertainAboutHoldsForAllRays(String name, TriangleMesh mesh, double leastInside) {
        long seed = System.nanoTime();
        System.out.println("SilhouetteTableTest: " + name + ", seed " + seed);
        SplittableRandom random = new SplittableRandom(seed);
        SilhouetteTable table = new SilhouetteTable(mesh);
        RayTracer tracer = new StackTraversal(KDTree.of(mesh));
        int inside = 0;
        int covered = 0;
        for (int i = 0; i < DIRECTIONS; i++) {
            double azimuth = (random.nextDouble() - 0.5) * (i % 3 == 0 ? 0.1 : 20.0);
            double elevation =
                    i == 1 ? 0.5 * Math.PI : i % 3 == 0 ? azimuth : Math.asin(2.0 * random.nextDouble() - 1.0);
            double range = table.minRange() * (i % 2 == 0 ? 1.0 : 1.0 / (1.0 - random.nextDouble()));
            View view = new View(azimuth, elevation, range);
            SilhouetteMask mask = mask(table, azimuth, elevation);
            for (int ray = 0; ray < RAYS; ray++) {
                double zoom = ray % 2 == 0 ? 1.0 : 0.2;
                double across = zoom * table.halfWidth() * (2.0 * random.nextDouble() - 1.0);
                double above = zoom * table.halfWidth() * (2.0 * random.nextDouble() - 1.0);
                boolean hit = view.hits(tracer, across, above);
                int kind = mask.kind(texel(table, across) + SilhouetteMask.TEXELS * texel(table, above));
                String as = "seed %d, azimuth %s, elevation %s, range %s, ray through %s, %s"
                        .formatted(seed, azimuth, elevation, range, across, above);
                if (kind == SilhouetteMask.INSIDE || kind == SilhouetteMask.OUTSIDE) {
                    assertThat(hit).as(as).isEqualTo(kind == SilhouetteMask.INSIDE);
                }
                inside += kind == SilhouetteMask.INSIDE ? 1 : 0;
                covered += hit ? 1 : 0;
            }
        }
        assertThat((double) inside / covered)
                .as("certain of what is covered, seed %d", seed)
                .isGreaterThan(leastInside);
    }

    private static int texel(SilhouetteTable table, double coordinate) {
        return (int) ((coordinate + table.halfWidth()) / (2.0 * table.halfWidth()) * SilhouetteMask.TEXELS);
    }

    private static SilhouetteMask mask(SilhouetteTable table, double azimuth, double elevation) {
        SilhouetteMask mask = null;
        while (mask == null) {
            mask = table.mask(azimuth, elevation, 100);
        }
        return mask;
    }

    /** A view of a drone whose nose is to the north, from a distance. */
    private static final class View {
        private final double[] side;
        private final double[] top;
        private final double[] ahead;
        private final double range;

        View(double azimuth, double elevation, double range) {
            double sin = Math.sin(azimuth);
            double cos = Math.cos(azimuth);
            this.side = new double[] {cos, -sin, 0.0};
            this.top = new double[] {-sin * Math.sin(elevation), -cos * Math.sin(elevation), Math.cos(elevation)};
            this.ahead = new double[] {sin * Math.cos(elevation), cos * Math.cos(elevation), Math.sin(elevation)};
            this.range = range;
        }

        /** Whether the ray from the camera through a point of the plane across the line of sight hits the drone. */
        boolean hits(RayTracer tracer, double across, double above) {
            double[] from = new double[3];
            double[] along = new double[3];
            for (int axis = 0; axis < 3; axis++) {
                from[axis] = -range * ahead[axis];
                along[axis] = across * side[axis] + above * top[axis] - from[axis];
            }
            return tracer.closestHit(
                    from[0], from[1], from[2], along[0], along[1], along[2], 0.0, Double.POSITIVE_INFINITY);
        }
    }

    /** A plate to the left, and one to the right and farther back, whose rims meet in the middle of the picture. */
    private static TriangleMesh plates() {
        return World.merge(List.of(
                Shapes.rectangle(
                        new Position(-0.3, -1.5, -0.3), new Position(0.0, -1.5, -0.3), new Position(0.0, -1.5, 0.3)),
                Shapes.rectangle(
                        new Position(0.0, 1.5, -0.3), new Position(0.3, 1.5, -0.3), new Position(0.3, 1.5, 0.3))));
    }

    /** Triangles without order: open, intersecting, some of them slivers, some sharing an edge with two others. */
    private static TriangleMesh soup() {
        SplittableRandom random = new SplittableRandom(5);
        int points = 24;
        float[] corners = new float[3 * points];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = (float) (random.nextDouble() - 0.5);
        }
        int triangles = 30;
        int[] indices = new int[3 * triangles];
        for (int i = 0; i < triangles; i++) {
            int first = random.nextInt(points);
            indices[3 * i] = first;
            indices[3 * i + 1] = (first + 1) % points;
            indices[3 * i + 2] = i % 5 == 0 ? (first + 1) % points : (first + 2 + random.nextInt(points - 3)) % points;
        }
        return TriangleMesh.of(corners, indices);
    }
}
