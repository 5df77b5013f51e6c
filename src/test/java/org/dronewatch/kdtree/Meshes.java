package org.dronewatch.kdtree;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.mesh.io.ModelLoader;

/** Meshes to test with. */
public final class Meshes {
    private static final int[][] BOX_FACES = {
        {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}
    };

    private final List<float[]> vertices = new ArrayList<>();
    private final List<int[]> faces = new ArrayList<>();

    private Meshes() {}

    /** A model of the project, in the coordinates of its file. */
    public static TriangleMesh model(String name) {
        return new ModelLoader(Path.of("models")).loadAsWritten(name).mesh();
    }

    /**
     * A closed room of 10 x 8 x 3 m with closed boxes in it: most are parallel to the walls, all stand on the floor.
     */
    public static TriangleMesh room() {
        Meshes room = new Meshes();
        room.box(0, 0, 0, 10, 8, 3, 0);
        SplittableRandom random = new SplittableRandom(2);
        for (int i = 0; i < 40; i++) {
            double x = 1 + 0.25 * random.nextInt(28);
            double y = 1 + 0.25 * random.nextInt(20);
            double turn = i % 4 == 0 ? random.nextDouble() : 0.0;
            room.box(x, y, 0, x + 0.1 + random.nextDouble(), y + 0.25, 0.2 + 2.5 * random.nextDouble(), turn);
        }
        return room.build();
    }

    /** Triangles of random place and shape in a cube from -1 to 1, each about as large as a share of the cube. */
    public static TriangleMesh soup(int triangles, double share, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Meshes soup = new Meshes();
        for (int i = 0; i < triangles; i++) {
            double[] middle = {uniform(random, 1 - share), uniform(random, 1 - share), uniform(random, 1 - share)};
            soup.face(
                    soup.vertexNear(middle, share, random),
                    soup.vertexNear(middle, share, random),
                    soup.vertexNear(middle, share, random));
        }
        return soup.build();
    }

    /** A closed ball of radius 1: an icosahedron of which each face is cut in four, so many times. */
    public static TriangleMesh icosphere(int subdivisions) {
        Meshes ball = new Meshes();
        double g = 0.5 * (1 + Math.sqrt(5));
        for (int axis = 0; axis < 3; axis++) {
            for (int sign = 0; sign < 4; sign++) {
                double[] p = new double[3];
                p[axis] = (sign & 1) == 0 ? 1 : -1;
                p[(axis + 1) % 3] = (sign & 2) == 0 ? g : -g;
                ball.vertexOnUnitSphere(p);
            }
        }
        // The faces are the triples of vertices that are all neighbours.
        for (int a = 0; a < 12; a++) {
            for (int b = a + 1; b < 12; b++) {
                for (int c = b + 1; c < 12; c++) {
                    if (ball.areNear(a, b, 1.1) && ball.areNear(b, c, 1.1) && ball.areNear(c, a, 1.1)) {
                        ball.face(a, b, c);
                    }
                }
            }
        }
        for (int i = 0; i < subdivisions; i++) {
            ball.subdivide();
        }
        return ball.build();
    }

    /** Input that upsets builders, by name. */
    public static Map<String, TriangleMesh> degenerate() {
        Map<String, TriangleMesh> meshes = new LinkedHashMap<>();
        meshes.put("empty", TriangleMesh.of(new float[0], new int[0]));
        meshes.put("one", soup(1, 1.0, 3));
        meshes.put("identical", identical());
        meshes.put("coplanar, off the grid of planes", coplanar(0.1f));
        meshes.put("coplanar, on the grid", coplanar(0.5f));
        meshes.put("points", points());
        meshes.put("slivers", slivers());
        meshes.put("huge", moved(soup(300, 0.3, 4), 9e29f, 0f));
        meshes.put("tiny", moved(soup(300, 0.3, 5), 1e-30f, 0f));
        meshes.put("subnormal", moved(soup(100, 0.3, 6), 1e-42f, 0f));
        meshes.put("far from the origin", moved(soup(300, 0.3, 7), 1f, 1e5f));
        meshes.put("of mixed scale", mixed());
        return meshes;
    }

    private static TriangleMesh identical() {
        Meshes mesh = new Meshes();
        for (int i = 0; i < 50; i++) {
            mesh.face(mesh.vertex(0, 0, 0), mesh.vertex(1, 0.2, 0.3), mesh.vertex(0.1, 1, -0.4));
        }
        return mesh.build();
    }

    private static TriangleMesh coplanar(float z) {
        SplittableRandom random = new SplittableRandom(8);
        Meshes mesh = new Meshes();
        for (int i = 0; i < 200; i++) {
            double[] middle = {uniform(random, 1), uniform(random, 1), z};
            int first = mesh.vertexNear(middle, 0.2, random);
            mesh.face(first, mesh.vertexNear(middle, 0.2, random), mesh.vertexNear(middle, 0.2, random));
        }
        mesh.vertices.forEach(vertex -> vertex[2] = z);
        return mesh.build();
    }

    private static TriangleMesh points() {
        SplittableRandom random = new SplittableRandom(9);
        Meshes mesh = new Meshes();
        for (int i = 0; i < 30; i++) {
            int point = mesh.vertexNear(new double[3], 1, random);
            mesh.face(point, point, point);
        }
        return mesh.build();
    }

    /** Long triangles without area, or with hardly any. */
    private static TriangleMesh slivers() {
        SplittableRandom random = new SplittableRandom(10);
        Meshes mesh = new Meshes();
        for (int i = 0; i < 100; i++) {
            int a = mesh.vertexNear(new double[3], 1, random);
            int b = mesh.vertexNear(new double[3], 1, random);
            float[] p = mesh.vertices.get(a);
            float[] q = mesh.vertices.get(b);
            double width = i % 2 == 0 ? 0.0 : 1e-4 * random.nextDouble();
            mesh.face(a, b, mesh.vertex(0.5 * (p[0] + q[0]) + width, 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2])));
            mesh.face(a, a, b);
        }
        return mesh.build();
    }

    /** Triangles of a micrometre to a metre, clustered about the origin, inside one of a kilometre. */
    private static TriangleMesh mixed() {
        SplittableRandom random = new SplittableRandom(11);
        Meshes mesh = new Meshes();
        mesh.face(mesh.vertex(-1000, -1000, -1), mesh.vertex(1000, -800, -2), mesh.vertex(0, 1000, 2));
        for (int i = 0; i < 400; i++) {
            double size = Math.pow(10, -6 * random.nextDouble());
            double[] middle = {uniform(random, size), uniform(random, size), uniform(random, size)};
            int first = mesh.vertexNear(middle, size, random);
            mesh.face(first, mesh.vertexNear(middle, size, random), mesh.vertexNear(middle, size, random));
        }
        return mesh.build();
    }

    private static TriangleMesh moved(TriangleMesh mesh, float scale, float shift) {
        float[] vertices = new float[3 * mesh.vertexCount()];
        for (int i = 0; i < vertices.length; i++) {
            vertices[i] = mesh.vertexCoordinate(i / 3, i % 3) * scale + shift;
        }
        int[] corners = new int[3 * mesh.triangleCount()];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = mesh.vertexIndex(i / 3, i % 3);
        }
        return TriangleMesh.of(vertices, corners);
    }

    private static double uniform(SplittableRandom random, double limit) {
        return limit * (2 * random.nextDouble() - 1);
    }

    private int vertexNear(double[] middle, double reach, SplittableRandom random) {
        return vertex(
                middle[0] + uniform(random, reach),
                middle[1] + uniform(random, reach),
                middle[2] + uniform(random, reach));
    }

    private int vertexOnUnitSphere(double[] p) {
        double length = Math.sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        return vertex(p[0] / length, p[1] / length, p[2] / length);
    }

    private int vertex(double x, double y, double z) {
        vertices.add(new float[] {(float) x, (float) y, (float) z});
        return vertices.size() - 1;
    }

    private void face(int a, int b, int c) {
        faces.add(new int[] {a, b, c});
    }

    /** A closed box whose walls are turned about its first edge. */
    private void box(double x0, double y0, double z0, double x1, double y1, double z1, double turn) {
        int first = vertices.size();
        for (int i = 0; i < 8; i++) {
            double x = (i & 1) == 0 ? 0 : x1 - x0;
            double y = (i & 2) == 0 ? 0 : y1 - y0;
            vertex(
                    x0 + Math.cos(turn) * x - Math.sin(turn) * y,
                    y0 + Math.sin(turn) * x + Math.cos(turn) * y,
                    (i & 4) == 0 ? z0 : z1);
        }
        for (int[] face : BOX_FACES) {
            face(first + face[0], first + face[1], first + face[2]);
            face(first + face[0], first + face[2], first + face[3]);
        }
    }

    private boolean areNear(int a, int b, double reach) {
        float[] p = vertices.get(a);
        float[] q = vertices.get(b);
        return Math.hypot(Math.hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]) < reach;
    }

    private void subdivide() {
        Map<Long, Integer> middles = new HashMap<>();
        List<int[]> coarse = List.copyOf(faces);
        faces.clear();
        for (int[] f : coarse) {
            int ab = middle(f[0], f[1], middles);
            int bc = middle(f[1], f[2], middles);
            int ca = middle(f[2], f[0], middles);
            face(f[0], ab, ca);
            face(ab, f[1], bc);
            face(ca, bc, f[2]);
            face(ab, bc, ca);
        }
    }

    private int middle(int a, int b, Map<Long, Integer> middles) {
        return middles.computeIfAbsent((long) Math.min(a, b) << 32 | Math.max(a, b), edge -> {
            float[] p = vertices.get(a);
            float[] q = vertices.get(b);
            return vertexOnUnitSphere(new double[] {(double) p[0] + q[0], (double) p[1] + q[1], (double) p[2] + q[2]});
        });
    }

    private TriangleMesh build() {
        float[] coordinates = new float[3 * vertices.size()];
        for (int i = 0; i < coordinates.length; i++) {
            coordinates[i] = vertices.get(i / 3)[i % 3];
        }
        int[] corners = faces.stream().flatMapToInt(java.util.Arrays::stream).toArray();
        return TriangleMesh.of(coordinates, corners);
    }
}
