package org.dronewatch.sensor.camera;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.mesh.io.ModelSettings;
import org.jogamp.vecmath.Vector3d;

/** Meshes with known pictures. */
public final class Shapes {
    private Shapes() {}

    /** A rectangle between two opposite corners of equal x, y or z. */
    public static TriangleMesh rectangle(Position a, Position b, Position c) {
        Position d = a.plus(c.minus(b));
        return mesh(List.of(a, b, c, d), new int[] {0, 1, 2, 0, 2, 3});
    }

    /** A level square with its centre on the z axis. */
    public static TriangleMesh ground(double edge, double z) {
        double h = edge / 2;
        return rectangle(new Position(-h, -h, z), new Position(h, -h, z), new Position(h, h, z));
    }

    /** A closed box. */
    public static TriangleMesh box(Position low, Position high) {
        List<Position> corners = new ArrayList<>();
        for (int i = 0; i < 8; i++) {
            corners.add(new Position(
                    (i & 1) == 0 ? low.x() : high.x(),
                    (i & 2) == 0 ? low.y() : high.y(),
                    (i & 4) == 0 ? low.z() : high.z()));
        }
        int[] quads = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
        int[] triangles = new int[36];
        for (int quad = 0; quad < 6; quad++) {
            int[] order = {0, 1, 2, 0, 2, 3};
            for (int k = 0; k < 6; k++) {
                triangles[6 * quad + k] = quads[4 * quad + order[k]];
            }
        }
        return mesh(corners, triangles);
    }

    /** A sphere about the origin: an octahedron whose triangles were cut in four so many times. */
    public static TriangleMesh sphere(double radius, int cuts) {
        List<Position> points = new ArrayList<>(List.of(
                new Position(1, 0, 0),
                new Position(-1, 0, 0),
                new Position(0, 1, 0),
                new Position(0, -1, 0),
                new Position(0, 0, 1),
                new Position(0, 0, -1)));
        int[] triangles = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
        for (int cut = 0; cut < cuts; cut++) {
            triangles = cutInFour(points, triangles);
        }
        return mesh(points.stream().map(p -> p.times(radius)).toList(), triangles);
    }

    private static int[] cutInFour(List<Position> points, int[] triangles) {
        Map<List<Integer>, Integer> middles = new HashMap<>();
        int[] finer = new int[4 * triangles.length];
        for (int i = 0; i < triangles.length; i += 3) {
            int[] corner = {triangles[i], triangles[i + 1], triangles[i + 2]};
            int[] middle = new int[3];
            for (int k = 0; k < 3; k++) {
                int a = Math.min(corner[k], corner[(k + 1) % 3]);
                int b = Math.max(corner[k], corner[(k + 1) % 3]);
                middle[k] = middles.computeIfAbsent(List.of(a, b), edge -> {
                    Position sum = points.get(a).plus(points.get(b));
                    points.add(sum.times(1.0 / sum.length()));
                    return points.size() - 1;
                });
            }
            int[] four = {
                corner[0], middle[0], middle[2], corner[1], middle[1], middle[0],
                corner[2], middle[2], middle[1], middle[0], middle[1], middle[2]
            };
            System.arraycopy(four, 0, finer, 4 * i, four.length);
        }
        return finer;
    }

    private static TriangleMesh mesh(List<Position> points, int[] triangles) {
        float[] vertices = new float[3 * points.size()];
        for (int i = 0; i < points.size(); i++) {
            vertices[3 * i] = (float) points.get(i).x();
            vertices[3 * i + 1] = (float) points.get(i).y();
            vertices[3 * i + 2] = (float) points.get(i).z();
        }
        return TriangleMesh.of(vertices, triangles);
    }

    /** A drone of a mesh, with the mesh's origin at a place. */
    public static Drone drone(String id, TriangleMesh mesh, Position place) {
        DroneSettings settings = DroneSettings.of(ModelSettings.of("none.obj"), new Hover(place, 0.0));
        return new Drone(id, settings, KDTree.of(mesh)).move(place.toVector3d());
    }

    /** A drone in a random attitude at a random place of a cube about the origin. */
    public static Drone tumbled(Drone drone, double edge, Random random) {
        Vector3d place = new Vector3d(
                edge * (random.nextDouble() - 0.5),
                edge * (random.nextDouble() - 0.5),
                edge * (random.nextDouble() - 0.5));
        return drone.move(place)
                .rotateX(2 * Math.PI * random.nextDouble(), 1)
                .rotateY(2 * Math.PI * random.nextDouble(), 1)
                .rotateZ(2 * Math.PI * random.nextDouble(), 1);
    }
}
