package org.dronewatch.sensor.acoustic.propagation;

import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * The surface below the line between two points and beside it. In its frame, u is measured horizontally from below the
 * first point towards the second, and v to the left of that direction. For use by one thread.
 */
final class GroundProfile {
    /** Points no farther apart in plan view than this, m, count as directly above one another. */
    private static final double BESIDE = 1e-3;

    private final TriangleMesh mesh;
    private final Visibility visibility;
    private final ArcSight arcs;
    private final double[] normal = new double[3];
    private Position from;
    private Position to;
    private double eastOfU;
    private double northOfU;
    private double distance;

    GroundProfile(World world) {
        this.mesh = world.mesh();
        this.visibility = new Visibility(world);
        this.arcs = new ArcSight(world);
    }

    /** Sets the line: from one point to another, m. */
    void between(Position first, Position second) {
        from = first;
        to = second;
        distance = Math.hypot(to.x() - from.x(), to.y() - from.y());
        eastOfU = distance > BESIDE ? (to.x() - from.x()) / distance : 1.0;
        northOfU = distance > BESIDE ? (to.y() - from.y()) / distance : 0.0;
    }

    /** The horizontal distance between the two points, m. */
    double distance() {
        return distance;
    }

    /**
     * Whether nothing obstructs the lines between a point at a height, m, and the two points.
     *
     * @param bulge curvature of the ground when arcs are drawn as straight lines, in terms of horizontal distances, 1/m
     */
    boolean isSeen(double u, double v, double z, double bulge) {
        return isSeenFrom(from, x(u, v), y(u, v), z, bulge) && isSeenFrom(to, x(u, v), y(u, v), z, bulge);
    }

    private boolean isSeenFrom(Position end, double x, double y, double z, double bulge) {
        double levelSquared = square(x - end.x()) + square(y - end.y());
        // The sag of an arc depends on the length of its chord; for both halves of a path, it must be computed from the
        // same horizontal distances.
        double curvature = bulge == 0.0 ? 0.0 : bulge * levelSquared / (levelSquared + square(z - end.z()));
        return arcs.isFree(end.x(), end.y(), end.z(), x, y, z, curvature);
    }

    private static double square(double value) {
        return value * value;
    }

    /**
     * The height of the surface at a point, m; NaN if there is none. The surface is searched for downward from the line
     * between the points; beside the line, the search begins at a point that is as far above the height of the line as
     * it is away from the line, and that must be visible from the line.
     */
    double z(double u, double v) {
        double nearest = Math.max(0.0, Math.min(distance, u));
        double fraction = distance > BESIDE ? nearest / distance : 0.0;
        // If the points are straight above each other, the line is vertical: its lower end is the point of the line
        // that is nearest to the ground.
        double z = distance > BESIDE ? from.z() + fraction * (to.z() - from.z()) : Math.min(from.z(), to.z());
        double aside = Math.hypot(u - nearest, v);
        double x = x(u, v);
        double y = y(u, v);
        if (aside > 0.0 && !visibility.isFree(x(nearest, 0.0), y(nearest, 0.0), z, x, y, z + aside)) {
            return Double.NaN;
        }
        if (!visibility.findFirstAlong(x, y, z + aside, 0.0, 0.0, -1.0, Double.POSITIVE_INFINITY)) {
            return Double.NaN;
        }
        int triangle = visibility.triangle();
        mesh.normal(triangle, normal);
        return mesh.coordinate(triangle, 0, 2)
                - (normal[0] * (x - mesh.coordinate(triangle, 0, 0))
                                + normal[1] * (y - mesh.coordinate(triangle, 0, 1)))
                        / normal[2];
    }

    /**
     * Looks for the highest surface at a position on the line; {@link #material} is then the material of that surface.
     */
    boolean findHighest(double u) {
        double above = visibility.world().bounds().maxZ() + 1.0;
        return visibility.findFirstAlong(x(u, 0.0), y(u, 0.0), above, 0.0, 0.0, -1.0, Double.POSITIVE_INFINITY);
    }

    private double x(double u, double v) {
        return from.x() + eastOfU * u - northOfU * v;
    }

    private double y(double u, double v) {
        return from.y() + northOfU * u + eastOfU * v;
    }

    /** The index, in the world, of the material that {@link #z} found last. */
    int material() {
        return visibility.material();
    }

    /** The coordinate u of a position. */
    double u(double x, double y) {
        return eastOfU * (x - from.x()) + northOfU * (y - from.y());
    }

    /** The coordinate v of a position. */
    double v(double x, double y) {
        return eastOfU * (y - from.y()) - northOfU * (x - from.x());
    }
}
