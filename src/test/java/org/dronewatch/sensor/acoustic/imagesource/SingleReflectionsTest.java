package org.dronewatch.sensor.acoustic.imagesource;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.junit.jupiter.api.Test;

/** Compared with a trial of every wall. */
class SingleReflectionsTest {
    private static final long SEED = 2411;
    private final SplittableRandom random = new SplittableRandom(SEED);

    private int tried;
    private int found;
    private int reflecting;

    /** Whether the point at which a wall would mirror one point to the other is on the wall, on their side of it. */
    private static boolean reflects(WallPlanes planes, int wall, Position a, Position b) {
        double[] image = new double[3];
        planes.mirror(wall, new double[] {b.x(), b.y(), b.z()}, 0, image, 0);
        double here = planes.height(wall, a.x(), a.y(), a.z());
        double there = planes.height(wall, image[0], image[1], image[2]);
        double fraction = here / (here - there);
        return here * there < 0.0
                && planes.mayContain(
                        wall,
                        a.x() + fraction * (image[0] - a.x()),
                        a.y() + fraction * (image[1] - a.y()),
                        a.z() + fraction * (image[2] - a.z()));
    }

    private void compare(WallPlanes planes, SingleReflections reflections, Position a, Position b) {
        reflections.find(a.x(), a.y(), a.z(), b.x(), b.y(), b.z());
        int[] walls =
                IntStream.range(0, reflections.count()).map(reflections::wall).toArray();
        assertThat(walls).as("seed %d: in order, each once", SEED).isSorted().doesNotHaveDuplicates();
        int[] needed = IntStream.range(0, planes.count())
                .filter(wall -> reflects(planes, wall, a, b))
                .toArray();
        if (needed.length > 0) {
            assertThat(walls).as("seed %d: %s to %s", SEED, a, b).contains(needed);
        }
        tried += planes.count();
        found += walls.length;
        reflecting += needed.length;
    }

    private static WallPlanes planes(TriangleMesh mesh) {
        return new WallPlanes(mesh, new BandSurfaces(List.of(SurfaceMaterial.uniform("wall", 0.1, 0.1))));
    }

    private double between(double low, double high) {
        return low + (high - low) * random.nextDouble();
    }

    private Position anywhere(double half, double low, double high) {
        return new Position(between(-half, half), between(-half, half), between(low, high));
    }

    /** A square of hilly ground, in triangles of 10 m. */
    private TriangleMesh terrain(int side) {
        float[] vertices = new float[3 * side * side];
        int[] corners = new int[6 * (side - 1) * (side - 1)];
        int at = 0;
        for (int i = 0; i < side; i++) {
            for (int j = 0; j < side; j++) {
                int vertex = i * side + j;
                vertices[3 * vertex] = 10f * (i - side / 2);
                vertices[3 * vertex + 1] = 10f * (j - side / 2);
                vertices[3 * vertex + 2] = (float) (20.0 * Math.sin(i / 9.0) * Math.cos(j / 7.0) + between(0.0, 1.0));
                if (i > 0 && j > 0) {
                    for (int corner : new int[] {0, 1, side + 1, 0, side + 1, side}) {
                        corners[at++] = vertex - side - 1 + corner;
                    }
                }
            }
        }
        return TriangleMesh.of(vertices, corners);
    }

    /** Triangles in all directions, of very different sizes. */
    private TriangleMesh rubble(int triangles) {
        float[] vertices = new float[9 * triangles];
        for (int i = 0; i < triangles; i++) {
            Position about = anywhere(60.0, -60.0, 60.0);
            double size = Math.pow(10.0, between(-2.0, 2.0));
            for (int k = 0; k < 3; k++) {
                Position corner = about.plus(anywhere(size, -size, size));
                vertices[9 * i + 3 * k] = (float) corner.x();
                vertices[9 * i + 3 * k + 1] = (float) corner.y();
                vertices[9 * i + 3 * k + 2] = (float) corner.z();
            }
        }
        return TriangleMesh.of(vertices, IntStream.range(0, 3 * triangles).toArray());
    }

    @Test
    void fewWallsOfATerrainNeedToBeTried() {
        WallPlanes planes = planes(terrain(64));
        SingleReflections reflections = new SingleReflections(planes);
        for (int run = 0; run < 200; run++) {
            // In the air, and close to the ground or below it.
            compare(planes, reflections, anywhere(300.0, 20.0, 120.0), anywhere(300.0, -25.0, 25.0));
        }
        assertThat(reflecting).isGreaterThan(100);
        assertThat(found).isLessThan(tried / 10);
    }

    @Test
    void noReflectionIsMissedAmongWallsInAllDirections() {
        for (int walls : new int[] {1, 2, 8, 9, 17, 500}) {
            WallPlanes planes = planes(rubble(walls));
            SingleReflections reflections = new SingleReflections(planes);
            for (int run = 0; run < 200; run++) {
                compare(planes, reflections, anywhere(90.0, -90.0, 90.0), anywhere(90.0, -90.0, 90.0));
            }
        }
        assertThat(reflecting).isGreaterThan(1000);
    }

    /** Where the directions to both ends change most: one or both within the box of the wall, or in one place. */
    @Test
    void noReflectionIsMissedCloseToWalls() {
        TriangleMesh mesh = rubble(300);
        WallPlanes planes = planes(mesh);
        SingleReflections reflections = new SingleReflections(planes);
        for (int run = 0; run < 400; run++) {
            int triangle = random.nextInt(mesh.triangleCount());
            double off = Math.pow(10.0, between(-7.0, 1.0));
            Position near = corner(mesh, triangle).plus(anywhere(off, -off, off));
            compare(planes, reflections, near, anywhere(90.0, -90.0, 90.0));
            compare(planes, reflections, near, near.plus(anywhere(off, -off, off)));
            compare(planes, reflections, near, near);
        }
        assertThat(reflecting).isGreaterThan(1000);
    }

    @Test
    void withoutWallsNothingIsFound() {
        TriangleMesh empty = TriangleMesh.of(new float[0], new int[0]);
        SingleReflections reflections = new SingleReflections(planes(empty));
        reflections.find(0.0, 0.0, 1.0, 5.0, 0.0, 1.0);
        assertThat(reflections.count()).isZero();
    }

    private static Position corner(TriangleMesh mesh, int triangle) {
        return new Position(
                mesh.coordinate(triangle, 0, 0), mesh.coordinate(triangle, 0, 1), mesh.coordinate(triangle, 0, 2));
    }
}
