package org.dronewatch.sensor.acoustic.imagesource;

import java.util.Arrays;
import java.util.Collections;
import java.util.Map;
import java.util.WeakHashMap;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.stream.IntStream;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.EllipsoidQuery;
import org.dronewatch.world.World;

/**
 * The triangles of a world that coincide, for instance where solids touch face to face: a ray meets only one of them.
 * They are found for each triangle when they are first requested. Thread-safe.
 */
final class TouchingFaces {
    /** Triangles that touch are parallel: the cosine of the angle between their normals is greater than this. */
    private static final double PARALLEL = 0.999;

    /** The touching faces of worlds in use: many sensors share one world. */
    private static final Map<World, TouchingFaces> KNOWN = Collections.synchronizedMap(new WeakHashMap<>());

    private final TriangleMesh mesh;
    private final double tolerance;
    private final EllipsoidQuery query;
    private final AtomicReferenceArray<int[]> others;

    private TouchingFaces(World world, WallPlanes planes) {
        this.mesh = world.mesh();
        this.tolerance = planes.tolerance();
        this.query = new EllipsoidQuery(world.tree());
        this.others = new AtomicReferenceArray<>(mesh.triangleCount());
    }

    /** The touching faces of a world, created once. */
    static TouchingFaces of(World world) {
        return KNOWN.computeIfAbsent(world, key -> new TouchingFaces(key, WallPlanes.of(key)));
    }

    /** The greatest distance between faces that touch, m; it is not 0, since coordinates are rounded. */
    double tolerance() {
        return tolerance;
    }

    /** The triangles that may touch a given one, in ascending order; not to be modified. */
    int[] of(int triangle) {
        int[] known = others.get(triangle);
        if (known == null) {
            known = find(triangle);
            others.set(triangle, known);
        }
        return known;
    }

    private synchronized int[] find(int triangle) {
        double[] normal = unitNormal(triangle);
        Position centre = centre(triangle);
        double reach = IntStream.range(0, 3)
                .mapToDouble(corner -> centre.distance(corner(triangle, corner)))
                .max()
                .orElseThrow();
        Position unit = new Position(normal[0], normal[1], normal[2]);
        query.findAtPlane(centre, centre, 2.0 * (reach + tolerance), unit, tolerance);
        return IntStream.range(0, query.count())
                .map(query::triangle)
                .filter(other -> other != triangle && isParallel(normal, unitNormal(other)))
                .filter(other -> overlap(triangle, other))
                .sorted()
                .toArray();
    }

    private double[] unitNormal(int triangle) {
        double[] normal = new double[3];
        mesh.normal(triangle, normal);
        double length =
                Math.sqrt(Arrays.stream(normal).map(number -> number * number).sum());
        return Arrays.stream(normal).map(number -> number / length).toArray();
    }

    private static boolean isParallel(double[] one, double[] other) {
        return Math.abs(one[0] * other[0] + one[1] * other[1] + one[2] * other[2]) > PARALLEL;
    }

    private Position centre(int triangle) {
        return corner(triangle, 0)
                .plus(corner(triangle, 1))
                .plus(corner(triangle, 2))
                .times(1.0 / 3.0);
    }

    private Position corner(int triangle, int corner) {
        return new Position(
                mesh.coordinate(triangle, corner, 0),
                mesh.coordinate(triangle, corner, 1),
                mesh.coordinate(triangle, corner, 2));
    }

    /** Whether two triangles in one plane overlap: no line along an edge of either has the other on its far side. */
    private boolean overlap(int one, int other) {
        return !isApart(one, other) && !isApart(other, one);
    }

    private boolean isApart(int triangle, int other) {
        Position normal = corner(triangle, 1)
                .minus(corner(triangle, 0))
                .cross(corner(triangle, 2).minus(corner(triangle, 0)));
        for (int edge = 0; edge < 3; edge++) {
            Position from = corner(triangle, edge);
            Position inward = normal.cross(corner(triangle, (edge + 1) % 3).minus(from));
            boolean isBeyond = true;
            for (int corner = 0; corner < 3; corner++) {
                Position at = corner(other, corner).minus(from);
                isBeyond &= at.dot(inward) <= tolerance * inward.length();
            }
            if (isBeyond) {
                return true;
            }
        }
        return false;
    }
}
