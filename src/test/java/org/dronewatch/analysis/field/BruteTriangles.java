package org.dronewatch.analysis.field;

import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.DoubleUnaryOperator;
import org.dronewatch.geometry.Ints;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * The triangles of a site, of which every one is tested: a segment by its signed volumes with the three sides of a
 * triangle, in double precision, without a tree.
 */
final class BruteTriangles {
    /** Surfaces within this distance of each other may be met in either order, m: coordinates are floats. */
    private static final double SAME_PLACE = 1e-3;

    /** Width of the columns into which the ground is sorted, m. */
    private static final double COLUMN = 50.0;

    /** Steps of a search, of which each leaves two thirds. */
    private static final int STEPS = 40;

    private final World world;
    private final double[] corners;

    /** How far a triangle reaches from its first corner, m. */
    private final double[] reach;

    private final Map<Long, Ints> ground = new HashMap<>();

    BruteTriangles(World world) {
        this.world = world;
        TriangleMesh mesh = world.mesh();
        this.corners = new double[9 * mesh.triangleCount()];
        this.reach = new double[mesh.triangleCount()];
        for (int i = 0; i < mesh.triangleCount(); i++) {
            for (int k = 0; k < 9; k++) {
                corners[9 * i + k] = mesh.coordinate(i, k / 3, k % 3);
            }
            reach[i] = Math.max(side(9 * i, 9 * i + 3), side(9 * i, 9 * i + 6));
            if (!world.isKnownEverywhere() && world.obstacle(i).model().role() == ModelRole.TERRAIN) {
                sort(i);
            }
        }
    }

    private void sort(int triangle) {
        TriangleMesh mesh = world.mesh();
        for (long x = column(mesh.least(triangle, 0)); x <= column(mesh.greatest(triangle, 0)); x++) {
            for (long y = column(mesh.least(triangle, 1)); y <= column(mesh.greatest(triangle, 1)); y++) {
                ground.computeIfAbsent(x << 32 ^ y & 0xFFFFFFFFL, key -> new Ints())
                        .add(triangle);
            }
        }
    }

    private static long column(double coordinate) {
        return (long) Math.floor(coordinate / COLUMN);
    }

    private double side(int a, int b) {
        return Math.sqrt(Math.pow(corners[b] - corners[a], 2)
                + Math.pow(corners[b + 1] - corners[a + 1], 2)
                + Math.pow(corners[b + 2] - corners[a + 2], 2));
    }

    /** Whether there is ground in each of some points of a line in plan view, a metre apart. */
    boolean isGroundBelow(Position from, Position to) {
        int steps = (int) Math.ceil(Math.hypot(to.x() - from.x(), to.y() - from.y())) + 1;
        for (int i = 0; i <= steps; i++) {
            double share = (double) i / steps;
            if (!hasGround(from.x() + share * (to.x() - from.x()), from.y() + share * (to.y() - from.y()))) {
                return false;
            }
        }
        return true;
    }

    private boolean hasGround(double x, double y) {
        Ints candidates = ground.get(column(x) << 32 ^ column(y) & 0xFFFFFFFFL);
        for (int i = 0; candidates != null && i < candidates.size(); i++) {
            int at = 9 * candidates.get(i);
            double one = side(x, y, at, at + 3);
            double two = side(x, y, at + 3, at + 6);
            double three = side(x, y, at + 6, at);
            if (Math.min(one, Math.min(two, three)) >= 0.0 || Math.max(one, Math.max(two, three)) <= 0.0) {
                return true;
            }
        }
        return false;
    }

    private double side(double x, double y, int a, int b) {
        return (corners[b] - corners[a]) * (y - corners[a + 1]) - (corners[b + 1] - corners[a + 1]) * (x - corners[a]);
    }

    /**
     * What may stand between a sensor and the points of a drone.
     *
     * @param from position of the sensor, m
     * @param middle of the drone, m
     * @param radius of the drone, m
     */
    Sight sight(Position from, Position middle, double radius) {
        Ints near = new Ints();
        for (int i = 0; i < corners.length / 9; i++) {
            if (distance(i, from, middle) <= radius + reach[i] + SAME_PLACE) {
                near.add(i);
            }
        }
        return new Sight(from, near);
    }

    /** How far the first corner of a triangle is from a segment, m. */
    private double distance(int triangle, Position from, Position to) {
        Position corner = new Position(corners[9 * triangle], corners[9 * triangle + 1], corners[9 * triangle + 2]);
        Position along = to.minus(from);
        double share = corner.minus(from).dot(along) / along.dot(along);
        return corner.distance(from.plus(along.times(Math.max(0.0, Math.min(1.0, share)))));
    }

    /** The view of a sensor towards a drone. */
    final class Sight {
        private final Position from;
        private final Ints near;

        private Sight(Position from, Ints near) {
            this.from = from;
            this.near = near;
        }

        /** The roles of the first surface on the way to a point, or of those that meet there; empty if it is free. */
        Set<ModelRole> before(Position to) {
            double nearest = first(to);
            Set<ModelRole> roles = EnumSet.noneOf(ModelRole.class);
            for (int i = 0; i < near.size() && nearest <= 1.0; i++) {
                double at = hit(near.get(i), from, to);
                if (at >= margin(to) && at <= nearest + SAME_PLACE / to.distance(from)) {
                    roles.add(world.obstacle(near.get(i)).model().role());
                }
            }
            return roles;
        }

        /** The roles of surfaces that force a wave to a point on a detour of at most so many metres. */
        Set<ModelRole> beside(Position to, double detour) {
            Set<ModelRole> roles = EnumSet.noneOf(ModelRole.class);
            double most = to.distance(from) + detour;
            for (int i = 0; i < near.size(); i++) {
                if (shortest(near.get(i), from, to) <= most) {
                    roles.add(world.obstacle(near.get(i)).model().role());
                }
            }
            return roles;
        }

        /** How many of some points are visible. */
        int visible(List<Position> points) {
            return (int) points.stream().filter(point -> first(point) > 1.0).count();
        }

        private double first(Position to) {
            double nearest = Double.POSITIVE_INFINITY;
            for (int i = 0; i < near.size(); i++) {
                double at = hit(near.get(i), from, to);
                if (at >= margin(to) && at <= 1.0 - margin(to)) {
                    nearest = Math.min(nearest, at);
                }
            }
            return nearest;
        }

        private double margin(Position to) {
            return Visibility.MARGIN / to.distance(from);
        }
    }

    /** Where a segment meets a triangle, as a fraction of its length; infinite if it does not. */
    private double hit(int triangle, Position from, Position to) {
        int at = 9 * triangle;
        double dx = to.x() - from.x();
        double dy = to.y() - from.y();
        double dz = to.z() - from.z();
        double ax = corners[at] - from.x();
        double ay = corners[at + 1] - from.y();
        double az = corners[at + 2] - from.z();
        double bx = corners[at + 3] - from.x();
        double by = corners[at + 4] - from.y();
        double bz = corners[at + 5] - from.z();
        double cx = corners[at + 6] - from.x();
        double cy = corners[at + 7] - from.y();
        double cz = corners[at + 8] - from.z();
        double u = volume(dx, dy, dz, bx, by, bz, cx, cy, cz);
        double v = volume(dx, dy, dz, cx, cy, cz, ax, ay, az);
        double w = volume(dx, dy, dz, ax, ay, az, bx, by, bz);
        if (Math.min(u, Math.min(v, w)) < 0.0 && Math.max(u, Math.max(v, w)) > 0.0) {
            return Double.POSITIVE_INFINITY;
        }
        double sum = u + v + w;
        double far = volume(ax, ay, az, bx, by, bz, cx, cy, cz);
        return sum == 0.0 ? Double.POSITIVE_INFINITY : far / sum;
    }

    /** The length of the shortest way between two points by way of a triangle, m: convex in a place on the triangle. */
    private double shortest(int triangle, Position from, Position to) {
        return least(u -> least(v -> length(triangle, u, v * (1.0 - u), from, to)));
    }

    /** The least value of a convex function between 0 and 1. */
    private static double least(DoubleUnaryOperator convex) {
        double low = 0.0;
        double high = 1.0;
        for (int i = 0; i < STEPS; i++) {
            double third = (high - low) / 3.0;
            if (convex.applyAsDouble(low + third) <= convex.applyAsDouble(high - third)) {
                high -= third;
            } else {
                low += third;
            }
        }
        return convex.applyAsDouble(0.5 * (low + high));
    }

    private double length(int triangle, double u, double v, Position from, Position to) {
        int at = 9 * triangle;
        double[] p = new double[3];
        for (int k = 0; k < 3; k++) {
            double first = corners[at + k];
            p[k] = first + u * (corners[at + 3 + k] - first) + v * (corners[at + 6 + k] - first);
        }
        Position by = new Position(p[0], p[1], p[2]);
        return from.distance(by) + by.distance(to);
    }

    private static double volume(
            double ax, double ay, double az, double bx, double by, double bz, double cx, double cy, double cz) {
        return ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
    }
}
