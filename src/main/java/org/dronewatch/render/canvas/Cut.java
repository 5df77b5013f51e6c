package org.dronewatch.render.canvas;

import org.dronewatch.geometry.Position;

/**
 * A clipping plane that opens the site to view: everything on the side to which its normal points is hidden.
 *
 * @param normal unit vector towards the part that is cut away
 * @param offset scalar product of the plane's points with the normal, m
 */
public record Cut(Position normal, double offset) {

    /** Clips everything above a height, m. */
    public static Cut above(double height) {
        return new Cut(new Position(0, 0, 1), height);
    }

    /** Clips everything beyond a point in a direction of any nonzero length. */
    public static Cut from(Position point, Position direction) {
        Position normal = direction.unit();
        return new Cut(normal, dot(normal, point));
    }

    private static double dot(Position a, Position b) {
        return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
    }

    /** Distance of a point beyond the plane, m; negative on the visible side. */
    public double depth(double x, double y, double z) {
        return normal.x() * x + normal.y() * y + normal.z() * z - offset;
    }

    /** Whether a point is shown. */
    public boolean keeps(Position point) {
        return depth(point.x(), point.y(), point.z()) <= 0.0;
    }

    /**
     * The increase of the {@link #depth} of a point that is moved by a vector, m: the scalar product of the vector with
     * the normal.
     */
    public double rate(double dx, double dy, double dz) {
        return normal.x() * dx + normal.y() * dy + normal.z() * dz;
    }
}
