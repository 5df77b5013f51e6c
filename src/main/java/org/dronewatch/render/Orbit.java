package org.dronewatch.render;

import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.optics.CameraObject;

/**
 * The viewpoint of a site view, on a sphere around its target. Immutable.
 *
 * @param target the point at the centre of the picture, m
 * @param bearing bearing of the eye from the target, clockwise from north, rad
 * @param elevation elevation of the eye above the horizontal, seen from the target, -pi/2 to pi/2, rad
 * @param distance distance from eye to target, above 0, m
 * @param fov vertical field of view, rad
 */
public record Orbit(Position target, double bearing, double elevation, double distance, double fov) {
    /** Default vertical field of view, rad. */
    private static final double NATURAL = Math.toRadians(38.0);

    /** Near-orthographic field of view for plans and side views, which are rendered from far away, rad. */
    private static final double NARROW = Math.toRadians(2.0);

    /** The steepest elevation, rad: just short of straight up or down, where the view would have no bearing. */
    private static final double STEEPEST = Math.toRadians(89.9);

    private static final double NEAREST = 0.05;
    private static final double FARTHEST = 1e7;

    /** Margin around the framed box, as a factor. */
    private static final double MARGIN = 1.2;

    /** Clamps elevation and distance to their limits, and reduces the bearing to -pi to pi. */
    public Orbit {
        elevation = Math.max(-0.5 * Math.PI, Math.min(0.5 * Math.PI, elevation));
        distance = Math.max(NEAREST, Math.min(FARTHEST, distance));
        bearing = Math.IEEEremainder(bearing, 2.0 * Math.PI);
    }

    /** A view from the south-west and above, with all of a box in a picture with a given ratio of width to height. */
    public static Orbit about(AABB box, double aspect) {
        double narrow = 2.0 * Math.atan(Math.tan(0.5 * NATURAL) * Math.min(1.0, aspect));
        double radius = 0.5 * Math.max(1e-3, box.diagonal());
        return new Orbit(
                Position.of(box.center()),
                Math.toRadians(215.0),
                Math.toRadians(28.0),
                0.9 * radius / Math.sin(0.5 * narrow),
                NATURAL);
    }

    /** A plan view, north up, with all of a box in a picture with a given ratio of width to height. */
    public static Orbit top(AABB box, double aspect) {
        double high = Math.max(box.maxY() - box.minY(), (box.maxX() - box.minX()) / aspect);
        // As if the eye had come from the south and risen: then north is up, and turning continues from there.
        return flat(box, Math.PI, 0.5 * Math.PI, high);
    }

    /**
     * A horizontal view, with all of a box in a picture with a given ratio of width to height, and the eye at a given
     * bearing from the box, clockwise from north, rad.
     */
    public static Orbit side(AABB box, double aspect, double bearing) {
        double across = Math.abs(Math.cos(bearing)) * (box.maxX() - box.minX())
                + Math.abs(Math.sin(bearing)) * (box.maxY() - box.minY());
        return flat(box, bearing, 0.0, Math.max(box.maxZ() - box.minZ(), across / aspect));
    }

    private static Orbit flat(AABB box, double bearing, double elevation, double high) {
        double distance = MARGIN * 0.5 * Math.max(1e-3, high) / Math.tan(0.5 * NARROW);
        return new Orbit(Position.of(box.center()), bearing, elevation, distance, NARROW);
    }

    /** This orbit with the eye moved on its sphere, clockwise as seen from above, and upwards, rad. */
    public Orbit turned(double clockwise, double upwards) {
        double steep = Math.max(-STEEPEST, Math.min(STEEPEST, elevation + upwards));
        return new Orbit(target, bearing + clockwise, steep, distance, fov);
    }

    /** This orbit with its distance multiplied by a factor: nearer to the target if the factor is less than 1. */
    public Orbit zoomed(double factor) {
        return new Orbit(target, bearing, elevation, distance * factor, fov);
    }

    /** This orbit around another point, m. */
    public Orbit at(Position point) {
        return new Orbit(point, bearing, elevation, distance, fov);
    }

    /** This orbit at the distance at which the view has a given height at its target, m. */
    public Orbit showing(double high) {
        return new Orbit(target, bearing, elevation, 0.5 * high / Math.tan(0.5 * fov), fov);
    }

    /** This orbit moved in the plane of the view: to the right, and upwards, m. */
    public Orbit panned(double right, double up) {
        double level = Math.sin(elevation);
        Position aside = new Position(-Math.cos(bearing), Math.sin(bearing), 0.0).times(right);
        Position above =
                new Position(-level * Math.sin(bearing), -level * Math.cos(bearing), Math.cos(elevation)).times(up);
        return at(target.plus(aside).plus(above));
    }

    /** This orbit moved horizontally: ahead, and to the right, m. */
    public Orbit walked(double ahead, double right) {
        double x = -Math.sin(bearing) * ahead - Math.cos(bearing) * right;
        double y = -Math.cos(bearing) * ahead + Math.sin(bearing) * right;
        return at(target.plus(new Position(x, y, 0.0)));
    }

    /**
     * This orbit rotated about its eye, which stays where it is while the target moves: clockwise as seen from above,
     * and upwards, rad.
     */
    public Orbit lookedAbout(double clockwise, double upwards) {
        Orbit next = turned(clockwise, -upwards);
        return next.at(target.plus(eye().minus(next.eye())));
    }

    /** The position of the eye, m. */
    public Position eye() {
        double level = Math.cos(elevation);
        return target.plus(new Position(
                distance * level * Math.sin(bearing),
                distance * level * Math.cos(bearing),
                distance * Math.sin(elevation)));
    }

    /** The camera for a picture of a given size in pixels. */
    public CameraObject camera(int width, int height) {
        Position eye = eye();
        return new CameraObject(eye, target.minus(eye), width, height, 0.5 * height / Math.tan(0.5 * fov));
    }

    /** The size of a pixel at the target, m, in a picture with a given number of rows. */
    public double metresPerPixel(int height) {
        return 2.0 * distance * Math.tan(0.5 * fov) / height;
    }
}
