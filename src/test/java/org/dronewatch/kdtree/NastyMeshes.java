package org.dronewatch.kdtree;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.dronewatch.geometry.TriangleMesh;

/**
 * Meshes of any number of triangles whose triangles no plane parts well, or whose corners lie where planes of a tree
 * do. The same arguments give the same mesh.
 */
public final class NastyMeshes {
    private final float[] corners;
    private int used;

    private NastyMeshes(int triangles) {
        this.corners = new float[9 * triangles];
    }

    /** One mesh of each kind, of about as many triangles as asked for, by name. */
    public static Map<String, TriangleMesh> all(int triangles, long seed) {
        Map<String, TriangleMesh> meshes = new LinkedHashMap<>();
        meshes.put("fan", fan(triangles + 2));
        meshes.put("tilted fan", tiltedFan(triangles + 2));
        meshes.put("needles through a point", needles(triangles, seed));
        meshes.put("parallel needles", parallelNeedles(triangles));
        meshes.put("identical", identical(triangles));
        meshes.put("spanning the box", spanning(triangles, seed));
        meshes.put("crossing strips", crossingStrips(triangles));
        meshes.put("concentric shells", concentricShells(triangles));
        meshes.put("a giant over many tiny ones", giantOverMany(triangles, seed));
        meshes.put("lattice", lattice((int) Math.cbrt(triangles / 6.0), 1.0, seed));
        meshes.put("lattice with holes", lattice((int) Math.cbrt(triangles / 2.0), 0.3, seed));
        return meshes;
    }

    /** A flat polygon of corners on a circle of radius 10, cut as a fan: slivers through its first corner. */
    public static TriangleMesh fan(int polygonCorners) {
        NastyMeshes mesh = new NastyMeshes(polygonCorners - 2);
        for (int i = 1; i < polygonCorners - 1; i++) {
            mesh.corner(10, 0, 0);
            mesh.onCircle(i, polygonCorners);
            mesh.onCircle(i + 1, polygonCorners);
        }
        return mesh.build();
    }

    private void onCircle(int i, int count) {
        double angle = 2 * Math.PI * i / count;
        corner(10 * Math.cos(angle), 10 * Math.sin(angle), 0);
    }

    /** The same, in a plane that is parallel to no axis. */
    public static TriangleMesh tiltedFan(int polygonCorners) {
        TriangleMesh flat = fan(polygonCorners);
        NastyMeshes mesh = new NastyMeshes(flat.triangleCount());
        for (int i = 0; i < 3 * flat.triangleCount(); i++) {
            double x = flat.coordinate(i / 3, i % 3, 0);
            double y = flat.coordinate(i / 3, i % 3, 1);
            mesh.corner(0.6 * x - 0.64 * y, 0.6 * y + 0.3 * x, 0.8 * x - 0.48 * y);
        }
        return mesh.build();
    }

    /** Long thin triangles in random directions through the origin. */
    public static TriangleMesh needles(int triangles, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        NastyMeshes mesh = new NastyMeshes(triangles);
        for (int i = 0; i < triangles; i++) {
            double[] d = onSphere(random);
            double[] across = onSphere(random);
            mesh.corner(-d[0], -d[1], -d[2]);
            mesh.corner(d[0], d[1], d[2]);
            mesh.corner(d[0] + 1e-3 * across[0], d[1] + 1e-3 * across[1], d[2] + 1e-3 * across[2]);
        }
        return mesh.build();
    }

    /** Long thin triangles side by side along the diagonal of a cube, as many across it in each of two directions. */
    public static TriangleMesh parallelNeedles(int triangles) {
        int rows = Math.max(1, (int) Math.sqrt(triangles));
        NastyMeshes mesh = new NastyMeshes(triangles);
        for (int i = 0; i < triangles; i++) {
            double u = (double) (i % rows) / rows;
            double v = (double) (i / rows) / rows;
            double thin = 0.2 / rows;
            mesh.corner(u, v - u, -v);
            mesh.corner(u + 10, v - u + 10, 10 - v);
            mesh.corner(u + 10 + thin, v - u + 10, 10 - v);
        }
        return mesh.build();
    }

    /** One triangle again and again. */
    public static TriangleMesh identical(int triangles) {
        NastyMeshes mesh = new NastyMeshes(triangles);
        for (int i = 0; i < triangles; i++) {
            mesh.corner(0, 0, 0);
            mesh.corner(1, 0.2, 0.3);
            mesh.corner(0.1, 1, -0.4);
        }
        return mesh.build();
    }

    /** Triangles with their corners on the faces of a cube, each as large as the cube on all three axes. */
    public static TriangleMesh spanning(int triangles, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        NastyMeshes mesh = new NastyMeshes(triangles);
        for (int i = 0; i < triangles; i++) {
            mesh.corner(-1, uniform(random), 1);
            mesh.corner(1, -1, uniform(random));
            mesh.corner(uniform(random), 1, -1);
        }
        return mesh.build();
    }

    /** Long strips on two levels, those of one across those of the other, at 45 degrees to the axes. */
    public static TriangleMesh crossingStrips(int triangles) {
        int perLevel = Math.max(1, triangles / 4);
        NastyMeshes mesh = new NastyMeshes(4 * perLevel);
        double width = 20.0 / perLevel;
        for (int level = 0; level < 2; level++) {
            for (int i = 0; i < perLevel; i++) {
                double near = -10 + i * width;
                double far = near + 0.7 * width;
                mesh.strip(level, near, -10, far, 10, far, -10);
                mesh.strip(level, near, -10, near, 10, far, 10);
            }
        }
        return mesh.build();
    }

    private void strip(int level, double... acrossAndAlong) {
        for (int k = 0; k < 6; k += 2) {
            double across = acrossAndAlong[k];
            double along = level == 0 ? acrossAndAlong[k + 1] : -acrossAndAlong[k + 1];
            double x = level == 0 ? across : along;
            double y = level == 0 ? along : across;
            corner(x + y, y - x, 0.01 * level);
        }
    }

    /** Balls of 80 triangles about one middle, each hardly larger than the last. */
    public static TriangleMesh concentricShells(int triangles) {
        TriangleMesh ball = Meshes.icosphere(1);
        int shells = Math.max(1, triangles / ball.triangleCount());
        NastyMeshes mesh = new NastyMeshes(shells * ball.triangleCount());
        for (int shell = 0; shell < shells; shell++) {
            double radius = 1 + 0.5 * shell / shells;
            for (int i = 0; i < 3 * ball.triangleCount(); i++) {
                mesh.corner(
                        radius * ball.coordinate(i / 3, i % 3, 0),
                        radius * ball.coordinate(i / 3, i % 3, 1),
                        radius * ball.coordinate(i / 3, i % 3, 2));
            }
        }
        return mesh.build();
    }

    /** A triangle of a kilometre aslant through tiny ones on a plain. */
    public static TriangleMesh giantOverMany(int triangles, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        NastyMeshes mesh = new NastyMeshes(triangles);
        mesh.corner(-500, -500, -0.5);
        mesh.corner(500, -400, 0.2);
        mesh.corner(0, 500, 0.7);
        double size = 200 / Math.sqrt(triangles);
        for (int i = 1; i < triangles; i++) {
            double x = 400 * uniform(random);
            double y = 400 * uniform(random);
            for (int corner = 0; corner < 3; corner++) {
                mesh.corner(x + size * uniform(random), y + size * uniform(random), 0.1 * size * uniform(random));
            }
        }
        return mesh.build();
    }

    /**
     * Unit right triangles on integer coordinates: all squares of a lattice of cubes from 0 to a number of cells on
     * each axis, cut in two. All corners and edges lie where planes of a tree do.
     *
     * @param cells how many cubes on each axis
     * @param share of the triangles that there are, 0 to 1; which they are is up to the seed
     */
    public static TriangleMesh lattice(int cells, double share, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        int planes = cells + 1;
        NastyMeshes mesh = new NastyMeshes(6 * planes * cells * cells);
        int[] p = new int[3];
        for (int axis = 0; axis < 3; axis++) {
            int second = (axis + 1) % 3;
            int third = (axis + 2) % 3;
            for (int square = 0; square < planes * cells * cells; square++) {
                for (int half = 0; half < 2; half++) {
                    if (random.nextDouble() >= share) {
                        continue;
                    }
                    for (int corner = 0; corner < 3; corner++) {
                        int alongSecond = corner == 1 || corner == 2 && half == 0 ? 1 : 0;
                        int alongThird = corner == 2 || corner == 1 && half == 1 ? 1 : 0;
                        p[axis] = square / (cells * cells);
                        p[second] = square / cells % cells + alongSecond;
                        p[third] = square % cells + alongThird;
                        mesh.corner(p[0], p[1], p[2]);
                    }
                }
            }
        }
        return mesh.build();
    }

    /** A mesh made larger by a factor, then moved along all axes. */
    public static TriangleMesh moved(TriangleMesh mesh, double factor, double shift) {
        NastyMeshes moved = new NastyMeshes(mesh.triangleCount());
        for (int i = 0; i < moved.corners.length; i++) {
            moved.corners[moved.used++] = (float) (factor * mesh.coordinate(i / 9, i / 3 % 3, i % 3) + shift);
        }
        return moved.build();
    }

    private static double[] onSphere(SplittableRandom random) {
        double z = uniform(random);
        double angle = Math.PI * uniform(random);
        double radius = Math.sqrt(1 - z * z);
        return new double[] {radius * Math.cos(angle), radius * Math.sin(angle), z};
    }

    private static double uniform(SplittableRandom random) {
        return 2 * random.nextDouble() - 1;
    }

    private void corner(double x, double y, double z) {
        corners[used++] = (float) x;
        corners[used++] = (float) y;
        corners[used++] = (float) z;
    }

    private TriangleMesh build() {
        float[] filled = Arrays.copyOf(corners, used);
        return TriangleMesh.of(filled, IntStream.range(0, used / 3).toArray());
    }
}
