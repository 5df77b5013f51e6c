package org.dronewatch.sensor.acoustic.edge;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.EllipsoidQuery;
import org.dronewatch.sensor.acoustic.propagation.ArcSight;
import org.dronewatch.sensor.acoustic.propagation.PathCurvature;
import org.dronewatch.world.World;

/**
 * Finds the edges close to an unobstructed line of sight that would obstruct the line if it passed on their other side.
 * Only bends in the outline of an obstacle are edges: seams in flat surfaces are not, nor are valleys, such as the
 * base of a wall on the ground. For use by one thread.
 */
public final class NearEdges {
    /**
     * An edge near a line of sight.
     *
     * @param detour length of the path that touches the edge minus that of the straight line, 0 or more, m
     * @param bend angle by which the outline of the obstacle bends at the edge, rad; pi for the edge of a sheet
     * @param material index of the material of a triangle at the edge
     */
    public record NearEdge(double detour, double bend, int material) {}

    private record Key(float x, float y, float z, float toX, float toY, float toZ) {}

    /** An obstacle may rise above the path that touches its edge by this angle, rad. */
    private static final double TOUCHING = 1e-3;

    /** Distance at which the path along which the edge must be visible passes the edge, m. */
    private static final double PASSING = 1e-4;

    private static final double NOTHING = 1e-9;

    private final TriangleMesh mesh;
    private final EllipsoidQuery query;
    private final ArcSight sight;
    private final Cone cone = new Cone();
    private final EdgeNeighbours neighbours;
    private final double[] normal = new double[3];
    private double curvature;

    /** Searches among the edges of a world. */
    public NearEdges(World world) {
        this.mesh = world.mesh();
        this.query = new EllipsoidQuery(world.tree());
        this.sight = new ArcSight(world);
        this.neighbours = new EdgeNeighbours(world);
    }

    /**
     * Finds the edges near the line between two points that have a line of sight.
     *
     * @param longest maximum detour, above 0, m
     */
    public List<NearEdge> find(Position source, Position sensor, double longest) {
        return find(source, sensor, longest, 0.0);
    }

    /**
     * Finds the edges near the unobstructed arc of sound between two points.
     *
     * @param longest maximum detour, above 0, m
     * @param bending curvature of sound from the source to the sensor: {@link PathCurvature#along}, 1/m
     */
    public List<NearEdge> find(Position source, Position sensor, double longest, double bending) {
        double straight = source.distance(sensor);
        curvature = bending;
        if (!(straight > 0.0) || mesh.triangleCount() == 0) {
            return List.of();
        }
        query.find(source, sensor, PathCurvature.reach(curvature, straight, straight + longest));
        if (query.count() == 0) {
            return List.of();
        }
        Map<Key, List<Integer>> trianglesOfEdges = new LinkedHashMap<>();
        for (int i = 0; i < query.count(); i++) {
            int triangle = query.triangle(i);
            for (int k = 0; k < 3; k++) {
                Position one = corner(triangle, k);
                Position other = corner(triangle, (k + 1) % 3);
                double raised = raised(source, sensor, straight, one, other);
                if (detour(source, sensor, nearest(source, sensor, one, other, raised), straight) < longest) {
                    trianglesOfEdges
                            .computeIfAbsent(key(triangle, k), unseen -> new ArrayList<>(2))
                            .add(triangle);
                }
            }
        }
        Position ahead = sensor.minus(source).times(1.0 / straight);
        List<NearEdge> edges = new ArrayList<>();
        trianglesOfEdges.forEach((key, triangles) -> {
            Position one = new Position(key.x(), key.y(), key.z());
            Position other = new Position(key.toX(), key.toY(), key.toZ());
            double raised = raised(source, sensor, straight, one, other);
            Position at = nearest(source, sensor, one, other, raised);
            double bend = bend(source, ahead, straight, at, raised, other.minus(one), triangles);
            if (bend > 0.0 && isSeen(source, sensor, ahead, at, raised)) {
                edges.add(new NearEdge(detour(source, sensor, at, straight), bend, mesh.material(triangles.get(0))));
            }
        });
        return edges;
    }

    /**
     * The height by which an edge is raised when arcs of sound are drawn as straight lines, at its nearest point, m.
     */
    private double raised(Position source, Position sensor, double straight, Position one, Position other) {
        if (curvature == 0.0) {
            return 0.0;
        }
        double raised = 0.0;
        // The edge is raised by this height, which also moves its nearest point.
        for (int round = 0; round < 2; round++) {
            Position at = nearest(source, sensor, one, other, raised);
            double along = at.minus(source).dot(sensor.minus(source)) / straight;
            raised = PathCurvature.sag(curvature, straight, along);
        }
        return raised;
    }

    private static double detour(Position source, Position sensor, Position at, double straight) {
        return Math.max(0.0, source.distance(at) + at.distance(sensor) - straight);
    }

    /**
     * The point of an edge over which the path is shortest: the point at which the path is straight once both legs are
     * turned into one plane.
     *
     * @param raised height by which the edge is raised when arcs of sound are drawn as straight lines, m
     */
    private static Position nearest(Position source, Position sensor, Position low, Position high, double raised) {
        Position one = raised == 0.0 ? low : low.plus(new Position(0.0, 0.0, raised));
        Position other = raised == 0.0 ? high : high.plus(new Position(0.0, 0.0, raised));
        Position edge = other.minus(one);
        double square = edge.dot(edge);
        if (!(square > 0.0)) {
            return one;
        }
        double ofSource = source.minus(one).dot(edge) / square;
        double ofSensor = sensor.minus(one).dot(edge) / square;
        double fromSource = source.distance(one.plus(edge.times(ofSource)));
        double fromSensor = sensor.distance(one.plus(edge.times(ofSensor)));
        double both = fromSource + fromSensor;
        double at = both > 0.0 ? (ofSource * fromSensor + ofSensor * fromSource) / both : ofSource;
        return one.plus(edge.times(Math.max(0.0, Math.min(1.0, at))));
    }

    /**
     * The angle by which the triangles of an edge bend in the plane through both ends of the line and a point of the
     * edge; 0 if they would not obstruct a line on the other side of the edge.
     */
    private double bend(
            Position source,
            Position ahead,
            double straight,
            Position at,
            double raised,
            Position edge,
            List<Integer> triangles) {
        Position ofMesh = raised == 0.0 ? at : at.minus(new Position(0.0, 0.0, raised));
        Position vector = at.minus(source);
        double u = vector.dot(ahead);
        Position beside = vector.minus(ahead.times(u));
        double v = beside.length();
        if (v < NOTHING) {
            // The line touches the edge: the obstacle is on the side of the edge's triangles.
            beside = new Position(0.0, 0.0, 0.0);
            for (int triangle : triangles) {
                Position inward = inward(triangle, ofMesh, edge);
                beside = beside.plus(inward.minus(ahead.times(inward.dot(ahead))));
            }
        }
        if (!(beside.length() > NOTHING * NOTHING)) {
            return 0.0;
        }
        Position side = beside.unit();
        Position plane = ahead.cross(side);
        cone.clear();
        double fold = Math.PI;
        for (int triangle : triangles) {
            mesh.normal(triangle, normal);
            Position along = new Position(normal[0], normal[1], normal[2]).cross(plane);
            Position inward = inward(triangle, ofMesh, edge);
            for (int other : triangles) {
                fold = other == triangle ? fold : Math.min(fold, Math.PI - inward.angle(inward(other, ofMesh, edge)));
            }
            double into = along.dot(inward);
            double length = along.length();
            if (Math.abs(into) <= NOTHING * length * inward.length()) {
                // The edge lies in the plane, in which it has no outline.
                return 0.0;
            }
            double sign = Math.copySign(1.0 / length, into);
            cone.add(sign * along.dot(ahead), sign * along.dot(side));
        }
        if (!mayObstruct(u, v, straight)) {
            return 0.0;
        }
        fold = Math.min(fold, neighbours.widen(cone, ofMesh, ahead, side, triangles.get(0)));
        // In a plane nearly coplanar with a surface, rounded coordinates show as bends of that surface.
        return mayObstruct(u, v, straight) ? Math.min(fold, cone.bend()) : 0.0;
    }

    /** Whether the surfaces at an edge, as far as they are known, leave the line free but not its other side. */
    private boolean mayObstruct(double u, double v, double straight) {
        return cone.isCorner()
                && !cone.contains(-u, -v, TOUCHING)
                && !cone.contains(straight - u, -v, TOUCHING)
                && !isOnNearSide(cone.firstU(), cone.firstV(), u, v, straight)
                && !isOnNearSide(cone.lastU(), cone.lastV(), u, v, straight)
                && !isOnNearSide(cone.middleU(), cone.middleV(), u, v, straight);
    }

    /** The direction from an edge into a triangle, perpendicular to the edge. */
    private Position inward(int triangle, Position at, Position edge) {
        Position centre = corner(triangle, 0)
                .plus(corner(triangle, 1))
                .plus(corner(triangle, 2))
                .times(1.0 / 3.0);
        Position inward = centre.minus(at);
        return inward.minus(edge.times(inward.dot(edge) / edge.dot(edge)));
    }

    /** Whether a direction from the edge at (u, v) points between the legs to both ends, towards the line. */
    private static boolean isOnNearSide(double du, double dv, double u, double v, double straight) {
        double toSource = -u * dv + v * du;
        double toSensor = -dv * (straight - u) - du * v;
        return toSource > TOUCHING * Math.hypot(u, v) && toSensor > TOUCHING * Math.hypot(straight - u, v);
    }

    /** Whether nothing hides an edge: it may lie inside a building or under the ground. */
    private boolean isSeen(Position source, Position sensor, Position ahead, Position at, double raised) {
        Position vector = at.minus(source);
        Position beside = vector.minus(ahead.times(vector.dot(ahead)));
        double distance = beside.length();
        if (distance < PASSING) {
            return true;
        }
        Position passing = at.minus(beside.times(PASSING / distance));
        return isFree(source, passing, raised) && isFree(sensor, passing, raised);
    }

    private boolean isFree(Position end, Position at, double raised) {
        return sight.isFree(end.x(), end.y(), end.z(), at.x(), at.y(), at.z() - raised, curvature);
    }

    private Position corner(int triangle, int corner) {
        return new Position(
                mesh.coordinate(triangle, corner, 0),
                mesh.coordinate(triangle, corner, 1),
                mesh.coordinate(triangle, corner, 2));
    }

    /** The key of an edge: its corners, in the same order for all triangles of the edge. */
    private Key key(int triangle, int k) {
        int next = (k + 1) % 3;
        // Positive and negative zeros are the same coordinate.
        float x = 0.0f + mesh.coordinate(triangle, k, 0);
        float y = 0.0f + mesh.coordinate(triangle, k, 1);
        float z = 0.0f + mesh.coordinate(triangle, k, 2);
        float toX = 0.0f + mesh.coordinate(triangle, next, 0);
        float toY = 0.0f + mesh.coordinate(triangle, next, 1);
        float toZ = 0.0f + mesh.coordinate(triangle, next, 2);
        boolean swap = x != toX ? x > toX : y != toY ? y > toY : z > toZ;
        return swap ? new Key(toX, toY, toZ, x, y, z) : new Key(x, y, z, toX, toY, toZ);
    }
}
