package org.dronewatch.sensor.acoustic.edge;

import org.dronewatch.geometry.CutTriangle;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.EllipsoidQuery;

/**
 * The outline of a world in a plane through two points, near those points: the straight pieces in which the plane cuts
 * triangles, in coordinates u along the line from the first point to the second and v across it. Pieces that end at
 * about the same place share an end, such as those that share a corner or an edge of the mesh, or meet where a corner
 * lies on the edge of another triangle. A plane that runs through corners is treated as if it lay an infinitesimal
 * distance to one side of them, so that each triangle is cut in one piece or not at all.
 *
 * <p>If sound travels in arcs, the outline is bent in the opposite direction, so that the arcs are straight lines in
 * it; its pieces are divided, since flat ground becomes a bulge. For use by one thread.
 */
final class PlaneCut {
    /**
     * Corners nearer to the plane than this, m, are taken to lie on it: shorter pieces would have no meaningful
     * direction.
     */
    private static final double ON_PLANE = 1e-7;

    private final TriangleMesh mesh;
    private final EllipsoidQuery query;
    private final CutTriangle straightPiece;
    private final CutOutline outline;
    private final BentPieces bentPieces;

    private Position origin;
    private Position ahead;
    private Position side;
    private double straight;
    private double curvature;

    /** Corners of the current bent triangle, relative to the origin, with their heights above the plane. */
    private final double[][] corner = new double[3][3];

    private final double[] height = new double[3];
    private final double[] crossing = new double[3];
    private final double[] surfaceNormal = new double[3];

    /** The points at which the sides of a bent triangle are cut, at most two for each side. */
    private final int[] crossed = new int[6];

    private int crossings;

    PlaneCut(TriangleMesh mesh, EllipsoidQuery query) {
        this.mesh = mesh;
        this.outline = new CutOutline(CutTriangle.touching(mesh));
        this.bentPieces = new BentPieces(outline);
        this.query = query;
        this.straightPiece = new CutTriangle(query::coordinate, ON_PLANE);
    }

    /**
     * Cuts the triangles that reach into an ellipsoid with two points as its foci.
     *
     * @param from the first point
     * @param to the second
     * @param ahead unit vector from the first point to the second
     * @param side unit vector in the plane, perpendicular to {@code ahead}
     * @param sum sum of the distances of a point on the ellipsoid from both points, m
     * @param curvature curvature of sound from one point to the other, in either direction, 1/m
     */
    void cut(Position from, Position to, Position ahead, Position side, double sum, double curvature) {
        this.origin = from;
        this.ahead = ahead;
        this.side = side;
        this.straight = from.distance(to);
        this.curvature = curvature;
        Position normal = ahead.cross(side);
        query.findAtPlane(from, to, sum, normal, ON_PLANE + greatestSag(sum) * Math.abs(normal.z()));
        // Two sides of a triangle are cut at one point each; of a bent triangle, each of the three sides may be cut at
        // two.
        outline.clear((curvature == 0.0 ? 2 : 6) * query.count());
        bentPieces.clear();
        for (int i = 0; i < query.count(); i++) {
            if (curvature == 0.0) {
                if (straightPiece.cut(i, origin, normal)) {
                    outline.add(point(straightPiece.first()), point(straightPiece.second()));
                }
            } else {
                cutBent(i, normal);
            }
        }
        bentPieces.divide(curvature, straight);
        outline.finish();
    }

    /** The outline cut last. */
    CutOutline outline() {
        return outline;
    }

    /** The height across the line of the outline above the mesh, at a distance along the line, m. */
    double bulgeAt(double along) {
        return sag(along) * side.z();
    }

    /** The greatest height by which the outline is above or below the mesh within an ellipsoid, m. */
    private double greatestSag(double sum) {
        double beyond = 0.5 * (sum - straight);
        return Math.abs(curvature) * Math.max(0.125 * straight * straight, 0.5 * beyond * (straight + beyond));
    }

    /** The depth of arcs of sound below the line, m; continued beyond its ends. */
    private double sag(double along) {
        return 0.5 * curvature * along * (straight - along);
    }

    /**
     * Cuts a triangle that is bent by as much as the arcs of sound, but in the opposite direction: its sides are
     * parabolas.
     */
    private void cutBent(int found, Position normal) {
        for (int k = 0; k < 3; k++) {
            double[] c = corner[k];
            c[0] = query.coordinate(found, k, 0) - origin.x();
            c[1] = query.coordinate(found, k, 1) - origin.y();
            c[2] = query.coordinate(found, k, 2) - origin.z();
            double over = along(c, normal) + sag(along(c, ahead)) * normal.z();
            height[k] = Math.abs(over) < ON_PLANE ? 0.0 : over;
        }
        crossings = 0;
        for (int k = 0; k < 3; k++) {
            int next = (k + 1) % 3;
            boolean swap = CutTriangle.isAfter(corner[k], corner[next]);
            crossBent(swap ? next : k, swap ? k : next, normal.z());
        }
        mesh.normal(query.triangle(found), surfaceNormal);
        double across = along(surfaceNormal, side);
        // Surfaces are bent only across the line, by the component of the vertical that is across it.
        double raised = surfaceNormal[2] - along(surfaceNormal, ahead) * ahead.z();
        // At each distance along the line, there is one point that lies in both the plane and the surface; otherwise,
        // such points exist at only two distances.
        sortCrossings();
        for (int i = 0; i + 1 < crossings; i += 2) {
            if (crossed[i] != crossed[i + 1]) {
                bentPieces.add(crossed[i], crossed[i + 1], across == 0.0 ? 0.0 : raised / across);
            }
        }
    }

    /**
     * Finds where the plane cuts a bent side: once between corners on either side of it, otherwise twice or not at all.
     */
    private void crossBent(int one, int other, double vertical) {
        double[] from = corner[one];
        double[] to = corner[other];
        double ofFrom = height[one];
        double ofTo = height[other];
        double run = along(to, ahead) - along(from, ahead);
        // Height above the plane: (1 - t) ofFrom + t ofTo + bow t (1 - t).
        double bow = 0.5 * curvature * run * run * vertical;
        double half = 0.5 * (ofTo - ofFrom + bow);
        double root = Math.sqrt(Math.max(0.0, half * half + bow * ofFrom));
        // Of the two roots, one is computed without cancellation, and the other from their product.
        double greater = half >= 0.0 ? half + root : half - root;
        double first = bow == 0.0 ? Double.NaN : greater / bow;
        double second = greater == 0.0 ? Double.NaN : -ofFrom / greater;
        if (ofFrom >= 0.0 != ofTo >= 0.0) {
            if (ofFrom == 0.0 || ofTo == 0.0) {
                crossed[crossings++] = bent(ofFrom == 0.0 ? from : to);
            } else {
                boolean isSecond = second >= 0.0 && second <= 1.0;
                crossed[crossings++] = bent(from, to, isSecond ? second : first);
            }
        } else if (root > 0.0 && first > 0.0 && first < 1.0 && second > 0.0 && second < 1.0 && first != second) {
            crossed[crossings++] = bent(from, to, first);
            crossed[crossings++] = bent(from, to, second);
        }
    }

    private int bent(double[] from, double[] to, double fraction) {
        for (int axis = 0; axis < 3; axis++) {
            crossing[axis] = from[axis] + fraction * (to[axis] - from[axis]);
        }
        return bent(crossing);
    }

    private int bent(double[] at) {
        // Points are displaced only across the line, so that a straight line becomes a parabola over u.
        return outline.point(along(at, ahead), along(at, side) + sag(along(at, ahead)) * side.z());
    }

    private void sortCrossings() {
        for (int i = 1; i < crossings; i++) {
            int point = crossed[i];
            int place = i;
            while (place > 0 && outline.u(crossed[place - 1]) > outline.u(point)) {
                crossed[place] = crossed[place - 1];
                place--;
            }
            crossed[place] = point;
        }
    }

    private static double along(double[] vector, Position unit) {
        return vector[0] * unit.x() + vector[1] * unit.y() + vector[2] * unit.z();
    }

    private int point(double[] at) {
        return outline.point(along(at, ahead), along(at, side));
    }
}
