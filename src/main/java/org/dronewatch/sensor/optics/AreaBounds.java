package org.dronewatch.sensor.optics;

import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * Bounds on the {@link VisibleArea} of a drone at a position, at little cost; they hold whatever its orientation. For
 * use by one thread at a time.
 */
public final class AreaBounds {
    /** The least cosine of the angle between the camera's axis and the drone for which an upper bound is stated. */
    private static final double LEAST_COSINE = 0.1;

    /** Tolerance for rounding. */
    private static final double SLACK = 1e-6;

    private static final double[] SIGNS = {-1.0, 1.0};

    /** How many times the square around a drone is divided into four. */
    private static final int DIVISIONS = 4;

    /** The number of surfaces in front of the middle of a square that are tried. */
    private static final int SURFACES = 6;

    private final CameraObject camera;
    private final Visibility visibility;

    /** Bounds for a camera in a world. */
    public AreaBounds(CameraObject camera, World world) {
        this.camera = camera;
        this.visibility = new Visibility(world);
    }

    /**
     * An upper bound on the area of a drone in the image, whether or not it is hidden, pixels.
     *
     * @param at position of its origin, m
     * @param radius greatest distance of its mesh from its origin, m
     * @return the bound; {@link Double#MAX_VALUE} where none is known: close to the camera, and far from its axis
     */
    public double most(Position at, double radius) {
        Bundle bundle = new Bundle(camera.position(), at, radius);
        double least = bundle.ahead.dot(camera.outline().forward()) - Math.sqrt(2.0) * bundle.half;
        if (!bundle.isNarrow() || least < LEAST_COSINE) {
            return Double.MAX_VALUE;
        }
        double focal = camera.focalLength();
        return 4.0 * bundle.half * bundle.half * focal * focal / (least * least * least) * (1.0 + SLACK);
    }

    /**
     * Whether the site certainly hides a drone: one triangle in front of it covers a square around its outline, or
     * several triangles cover the parts of that square. Arguments as for {@link #most}.
     */
    public boolean isHidden(Position at, double radius) {
        Position from = camera.position();
        Bundle bundle = new Bundle(from, at, radius);
        double end = bundle.range - radius - 2.0 * Visibility.MARGIN;
        if (!bundle.isNarrow() || !(end > 0.0)) {
            return false;
        }
        return isHidden(bundle, 0.0, 0.0, 1.0, end, DIVISIONS);
    }

    /** Whether a part of the bundle is hidden: a square, given by its middle and half the length of its side. */
    private boolean isHidden(Bundle bundle, double side, double up, double size, double end, int divisions) {
        Position from = camera.position();
        Position middle = bundle.ray(side, up);
        double last = end / middle.length();
        boolean isBlocked =
                visibility.findFirstAlong(from.x(), from.y(), from.z(), middle.x(), middle.y(), middle.z(), last);
        if (!isBlocked) {
            return false;
        }
        for (int i = 0; i < SURFACES && isBlocked; i++) {
            if (isBehind(visibility.triangle(), bundle, side, up, size, end)) {
                return true;
            }
            isBlocked = visibility.findNext();
        }
        if (divisions == 0) {
            return false;
        }
        double half = 0.5 * size;
        return isHidden(bundle, side - half, up - half, half, end, divisions - 1)
                && isHidden(bundle, side + half, up - half, half, end, divisions - 1)
                && isHidden(bundle, side - half, up + half, half, end, divisions - 1)
                && isHidden(bundle, side + half, up + half, half, end, divisions - 1);
    }

    /** Whether a triangle is in front of a square of the bundle. */
    private boolean isBehind(int triangle, Bundle bundle, double aside, double upwards, double size, double end) {
        Surface surface = new Surface(visibility.world().mesh(), triangle, camera.position());
        for (double side : SIGNS) {
            for (double up : SIGNS) {
                Position ray = bundle.ray(aside + side * size, upwards + up * size);
                double distance = surface.distance(ray);
                double depth = distance * ray.dot(camera.outline().forward());
                boolean isBefore = distance > 2.0 * Visibility.MARGIN
                        && distance * ray.length() < end
                        && depth > camera.near() + 2.0 * Visibility.MARGIN;
                if (!isBefore) {
                    return false;
                }
            }
        }
        return true;
    }

    /**
     * A square bundle of rays around the drone's bounding sphere: it contains all rays of a {@link VisibleArea}, and is
     * a little wider.
     */
    private static final class Bundle {
        private final double range;
        private final double half;
        private final Position ahead;
        private final Position aside;
        private final Position above;

        Bundle(Position from, Position at, double radius) {
            Position vector = at.minus(from);
            this.range = vector.length();
            this.half = range > radius
                    ? (1.0 + SLACK) * radius / Math.sqrt(range * range - radius * radius)
                    : Double.POSITIVE_INFINITY;
            this.ahead = range > 0.0 ? vector.times(1.0 / range) : new Position(0, 0, 1);
            Position top = Math.abs(ahead.z()) < 0.9 ? new Position(0, 0, 1) : new Position(0, 1, 0);
            this.aside = ahead.cross(top).unit();
            this.above = aside.cross(ahead);
        }

        boolean isNarrow() {
            return half < LEAST_COSINE;
        }

        /** The ray through a point of the square, given by two coordinates from -1 to 1. */
        Position ray(double side, double up) {
            return ahead.plus(aside.times(side * half)).plus(above.times(up * half));
        }
    }

    /** A triangle as it is seen from a point. */
    private static final class Surface {
        private final Position corner;
        private final Position edge;
        private final Position other;

        Surface(TriangleMesh mesh, int triangle, Position from) {
            this.corner = corner(mesh, triangle, 0).minus(from);
            this.edge = corner(mesh, triangle, 1).minus(from).minus(corner);
            this.other = corner(mesh, triangle, 2).minus(from).minus(corner);
        }

        private static Position corner(TriangleMesh mesh, int triangle, int number) {
            return new Position(
                    mesh.coordinate(triangle, number, 0),
                    mesh.coordinate(triangle, number, 1),
                    mesh.coordinate(triangle, number, 2));
        }

        /**
         * The distance at which a ray meets the inside of the triangle, as a multiple of the ray; NaN if it does not,
         * or if it passes close to an edge.
         */
        double distance(Position ray) {
            Position normal = ray.cross(other);
            double determinant = edge.dot(normal);
            Position back = corner.times(-1.0);
            double u = back.dot(normal) / determinant;
            Position across = back.cross(edge);
            double v = ray.dot(across) / determinant;
            return u > SLACK && v > SLACK && u + v < 1.0 - SLACK ? other.dot(across) / determinant : Double.NaN;
        }
    }
}
