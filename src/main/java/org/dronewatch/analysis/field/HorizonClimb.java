package org.dronewatch.analysis.field;

import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * Finds the least height on a vertical line from which a point is visible. For a ray that is blocked, the triangle that
 * blocks it is known. In the vertical plane through the point and the line, that triangle is a segment, which also
 * blocks all lines of sight between the blocked one and the one that passes over the higher end of the segment. So the
 * height is raised to where the latter meets the vertical line, and the next ray is traced to that height: no free
 * height is passed over, and each triangle is met once. Keeps scratch memory: for use by one thread at a time.
 * Allocates nothing per ray.
 */
final class HorizonClimb {
    /** By how much a line of sight passes above the edge that it clears, at the vertical line, m. */
    private static final double CLEARANCE = 1e-4;

    /** The greatest number of triangles that are cleared. */
    private static final int MOST = 20_000;

    /** What is nearer to the point in plan view counts as above or below it, m. */
    private static final double NEAREST = 1e-9;

    private static final int CORNERS = 3;

    private final Visibility visibility;
    private final TriangleMesh mesh;

    /** The corners of a triangle, from the point: along the plane, away from it, and up, m. */
    private final double[] ahead = new double[CORNERS];

    private final double[] aside = new double[CORNERS];
    private final double[] up = new double[CORNERS];

    /** Where its edges cross the plane. */
    private final double[] crossingAhead = new double[2 * CORNERS];

    private final double[] crossingUp = new double[2 * CORNERS];
    private int crossings;

    HorizonClimb(World world) {
        this.visibility = new Visibility(world);
        this.mesh = world.mesh();
    }

    /**
     * The least height from which a point is visible, found from below.
     *
     * @param point the point, m
     * @param x of the vertical line, m
     * @param y of the vertical line, m
     * @param bottom where the search begins, m
     * @param top where it ends, m
     * @return from bottom to top, too high by at most 0.1 mm; NaN if the point is not visible from any height up to
     *     there
     */
    double lowest(Position point, double x, double y, double bottom, double top) {
        double dx = x - point.x();
        double dy = y - point.y();
        double distance = Math.sqrt(dx * dx + dy * dy);
        double z = bottom;
        for (int i = 0; i < MOST && z <= top; i++) {
            if (!visibility.findFirstAlong(point.x(), point.y(), point.z(), dx, dy, z - point.z(), 1.0)) {
                return z;
            }
            if (distance <= NEAREST && z >= point.z()) {
                return Double.NaN;
            }
            // Straight below the point, the line of sight ends on the surface that was hit.
            double over = distance > NEAREST
                    ? cleared(point, dx / distance, dy / distance, distance)
                    : point.z() + visibility.distance() * (z - point.z());
            z = Math.max(z, over) + CLEARANCE;
        }
        return Double.NaN;
    }

    /** The height of the line of sight over the higher end of the segment, where it meets the vertical line, m. */
    private double cleared(Position point, double alongX, double alongY, double distance) {
        int triangle = visibility.triangle();
        for (int corner = 0; corner < CORNERS; corner++) {
            double x = mesh.coordinate(triangle, corner, 0) - point.x();
            double y = mesh.coordinate(triangle, corner, 1) - point.y();
            ahead[corner] = x * alongX + y * alongY;
            aside[corner] = y * alongX - x * alongY;
            up[corner] = mesh.coordinate(triangle, corner, 2) - point.z();
        }
        crossings = 0;
        for (int corner = 0; corner < CORNERS; corner++) {
            addCrossing(corner, (corner + 1) % CORNERS);
        }
        double steepest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < crossings; i++) {
            for (int k = 0; k < crossings; k++) {
                steepest = Math.max(steepest, slope(i, k, distance));
            }
        }
        return point.z() + steepest * distance;
    }

    /** Adds the point at which an edge crosses the plane; both ends of one that lies in it. */
    private void addCrossing(int from, int to) {
        if (aside[from] == 0.0 && aside[to] == 0.0) {
            addCrossing(from, to, 0.0);
            addCrossing(from, to, 1.0);
        } else if (aside[from] * aside[to] <= 0.0) {
            addCrossing(from, to, aside[from] / (aside[from] - aside[to]));
        }
    }

    private void addCrossing(int from, int to, double share) {
        crossingAhead[crossings] = ahead[from] + share * (ahead[to] - ahead[from]);
        crossingUp[crossings] = up[from] + share * (up[to] - up[from]);
        crossings++;
    }

    /**
     * The slope, height over distance, at one end of a part of the segment: of what lies in front of the point, but not
     * beyond the vertical line. Minus infinity if this end is behind the point.
     */
    private double slope(int end, int other, double distance) {
        double at = crossingAhead[end];
        double cut = Math.min(distance, Math.max(NEAREST, at));
        if (cut == at) {
            return crossingUp[end] / at;
        }
        double share = (cut - at) / (crossingAhead[other] - at);
        return share >= 0.0 && share <= 1.0
                ? (crossingUp[end] + share * (crossingUp[other] - crossingUp[end])) / cut
                : Double.NEGATIVE_INFINITY;
    }
}
