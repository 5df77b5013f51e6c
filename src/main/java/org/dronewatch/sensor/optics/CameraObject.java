package org.dronewatch.sensor.optics;

import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.Ray;
import org.dronewatch.sensor.Outline;
import org.jogamp.vecmath.Point2d;
import org.jogamp.vecmath.Point3d;
import org.joml.Matrix4d;
import org.joml.Vector4d;

/**
 * Pose and projection of a camera. In its own frame, x is to the right and y is up, and the camera looks along -z;
 * pixel (0, 0) is the top left one; a pixel's ray goes through its centre. Immutable.
 */
public final class CameraObject {
    /** Minimum depth that is projected, m: so small that no ray meets a drone at a smaller depth. */
    public static final double NEAR = 1e-6;

    private final Position position;
    private final int width;
    private final int height;
    private final double focalLength;
    private final double roll;
    private final Projection lens;

    /** The point at which the axis meets the image, in pixels from the left and from the top edge. */
    private final double axisColumn;

    private final double axisRow;

    private final CameraAxes axes;
    private final Position right;
    private final Position up;
    private final Position forward;
    private final Matrix4d view;
    private final Matrix4d projection;

    /** A camera with these settings. Without roll, north is at the top if the camera looks straight down. */
    public CameraObject(PictureSettings settings) {
        this(
                settings.position(),
                settings.aim().from(settings.position()),
                settings.roll(),
                settings.width(),
                settings.height(),
                settings.focalLength(),
                settings.projection());
    }

    /**
     * A camera. The horizon is level; north is at the top if the camera looks straight down.
     *
     * @param position its centre of projection, m
     * @param direction line of sight of the camera, of any non-zero length
     * @param width number of pixels per row
     * @param height number of rows
     * @param focalLength focal length in pixels
     */
    public CameraObject(Position position, Position direction, int width, int height, double focalLength) {
        this(position, direction, 0.0, width, height, focalLength, Projection.DEFAULT);
    }

    /**
     * A camera.
     *
     * @param position its centre of projection, m
     * @param direction line of sight of the camera, of any non-zero length
     * @param roll rotation about that direction, its right side down, rad; at 0 the horizon is level, and north is at
     *     the top if the camera looks straight down
     * @param width number of pixels per row
     * @param height number of rows
     * @param focalLength focal length in pixels
     * @param lens position of its axis in the image, and its near and far planes
     */
    public CameraObject(
            Position position,
            Position direction,
            double roll,
            int width,
            int height,
            double focalLength,
            Projection lens) {
        this.position = position;
        this.width = width;
        this.height = height;
        this.focalLength = focalLength;
        this.roll = roll;
        this.lens = lens;
        this.axisColumn = (0.5 - lens.shiftRight()) * width;
        this.axisRow = (0.5 + lens.shiftUp()) * height;

        this.axes = new CameraAxes(direction, roll);
        this.forward = axes.forward;
        this.right = axes.right;
        this.up = axes.up;
        Position top = axes.top();
        this.view = new Matrix4d()
                .lookAt(
                        position.x(),
                        position.y(),
                        position.z(),
                        position.x() + forward.x(),
                        position.y() + forward.y(),
                        position.z() + forward.z(),
                        top.x(),
                        top.y(),
                        top.z());
        this.projection = newProjection();
    }

    private Matrix4d newProjection() {
        if (lens.equals(Projection.DEFAULT)) {
            double fovY = 2.0 * Math.atan(0.5 * height / focalLength);
            return new Matrix4d().perspective(fovY, (double) width / height, NEAR, Double.POSITIVE_INFINITY);
        }
        double nearest = Math.max(NEAR, lens.near());
        double scale = nearest / focalLength;
        return new Matrix4d()
                .frustum(
                        -axisColumn * scale,
                        (width - axisColumn) * scale,
                        (axisRow - height) * scale,
                        axisRow * scale,
                        nearest,
                        lens.limit());
    }

    /** Everything that determines what a camera sees of a site. */
    record Pose(
            Position position,
            Position forward,
            Position right,
            Position up,
            int width,
            int height,
            double focalLength,
            Projection lens) {}

    /** Everything that determines what this camera sees of a site, for comparison with other cameras. */
    Pose pose() {
        return new Pose(position, forward, right, up, width, height, focalLength, lens);
    }

    /** This camera with another number of pixels, and the same vertical field of view. */
    public CameraObject withPixels(int columns, int rows) {
        return new CameraObject(position, forward, roll, columns, rows, focalLength * rows / height, lens);
    }

    /** The matrix from the world to the camera's frame. */
    public Matrix4d view() {
        return new Matrix4d(view);
    }

    /** The matrix from the camera's frame to clip space. */
    public Matrix4d projection() {
        return new Matrix4d(projection);
    }

    /** The matrix from a model's space to clip space: projection times view times model. */
    public Matrix4d modelViewProjection(org.jogamp.vecmath.Matrix4d model) {
        Matrix4d m = new Matrix4d(
                model.m00, model.m10, model.m20, model.m30, model.m01, model.m11, model.m21, model.m31, model.m02,
                model.m12, model.m22, model.m32, model.m03, model.m13, model.m23, model.m33);
        return projection().mul(view).mul(m);
    }

    /** The ray through the centre of a pixel, with a unit direction. */
    public Ray ray(int column, int row) {
        double[] direction = new double[3];
        direction(column, row, direction);
        return new Ray(position, new Position(direction[0], direction[1], direction[2]));
    }

    /** The ray through the centre of a pixel, with a unit direction, from the near plane to the far one. */
    public Ray seeingRay(int column, int row) {
        Ray ray = ray(column, row);
        double slant = obliqueness(column, row);
        return new Ray(ray.origin(), ray.direction(), slant * near(), slant * far());
    }

    /** Writes the unit direction of a pixel's ray in the world's frame; does not allocate. */
    public void direction(int column, int row, double[] target) {
        axes.direction((column + 0.5 - axisColumn) / focalLength, (axisRow - row - 0.5) / focalLength, target);
    }

    /**
     * The directions of all pixels as a grid in the world's frame: that of the first pixel, and its changes per column
     * and per row, three numbers each. They reach one unit along the camera's axis, so they are longer than unit
     * vectors by the factor {@link #obliqueness}.
     */
    public double[][] grid() {
        double x = (0.5 - axisColumn) / focalLength;
        double y = (axisRow - 0.5) / focalLength;
        return new double[][] {
            {
                forward.x() + x * right.x() + y * up.x(),
                forward.y() + x * right.y() + y * up.y(),
                forward.z() + x * right.z() + y * up.z()
            },
            {right.x() / focalLength, right.y() / focalLength, right.z() / focalLength},
            {-up.x() / focalLength, -up.y() / focalLength, -up.z() / focalLength}
        };
    }

    /** The ratio of the distance along a pixel's ray to that along the camera's axis, 1 or more. */
    public double obliqueness(int column, int row) {
        double x = (column + 0.5 - axisColumn) / focalLength;
        double y = (axisRow - row - 0.5) / focalLength;
        return Math.sqrt(1.0 + x * x + y * y);
    }

    /**
     * Writes the coordinates of a point of the world relative to the camera, from index {@code at} of the target on:
     * metres to the right, up and ahead.
     */
    public void toView(double x, double y, double z, double[] target, int at) {
        double dx = x - position.x();
        double dy = y - position.y();
        double dz = z - position.z();
        target[at] = dx * right.x() + dy * right.y() + dz * right.z();
        target[at + 1] = dx * up.x() + dy * up.y() + dz * up.z();
        target[at + 2] = dx * forward.x() + dy * forward.y() + dz * forward.z();
    }

    /**
     * Whether a sphere, given by its centre and radius, m, is entirely outside the image, or nearer than the near plane
     * or beyond the far plane; true only if that is certain.
     */
    public boolean isOutside(double x, double y, double z, double radius) {
        double dx = x - position.x();
        double dy = y - position.y();
        double dz = z - position.z();
        double depth = dx * forward.x() + dy * forward.y() + dz * forward.z();
        double across = dx * right.x() + dy * right.y() + dz * right.z();
        double above = dx * up.x() + dy * up.y() + dz * up.z();
        return depth < lens.near() - radius
                || depth > lens.limit() + radius
                || isBeyond(across, depth, width - axisColumn, radius)
                || isBeyond(-across, depth, axisColumn, radius)
                || isBeyond(above, depth, axisRow, radius)
                || isBeyond(-above, depth, height - axisRow, radius);
    }

    /** Whether a sphere lies wholly beyond an edge of the image that is a given number of pixels away from the axis. */
    private boolean isBeyond(double aside, double depth, double pixels, double radius) {
        double slope = pixels / focalLength;
        return aside - slope * depth > radius * Math.sqrt(1.0 + slope * slope);
    }

    /** Column of a point that lies to the right and ahead of the camera, in pixels from the left edge. */
    double column(double across, double ahead) {
        return axisColumn + focalLength * across / ahead;
    }

    /** Row of a point that lies above and ahead of the camera, in pixels from the top edge. */
    double row(double above, double ahead) {
        return axisRow - focalLength * above / ahead;
    }

    /**
     * The position of a point of the world in the image.
     *
     * @return column and row in pixels, (0, 0) being the top left corner of the top left pixel; empty for a point
     *     nearer than {@link #NEAR}, not between the near and the far plane, or behind the camera. The point may lie
     *     outside the image.
     */
    public Optional<Point2d> pixelOf(Point3d point) {
        Vector4d clip = projection().mul(view).transform(new Vector4d(point.x, point.y, point.z, 1.0));
        return clip.w < NEAR || clip.w < lens.near() || clip.w > lens.limit()
                ? Optional.empty()
                : Optional.of(new Point2d(column(clip), row(clip)));
    }

    /** Column of a point in clip space, in pixels from the left edge. */
    double column(Vector4d clip) {
        return 0.5 * (clip.x / clip.w + 1.0) * width;
    }

    /** Row of a point in clip space, in pixels from the top edge. */
    double row(Vector4d clip) {
        return 0.5 * (1.0 - clip.y / clip.w) * height;
    }

    /** The field of view of the image. */
    public Outline.Frustum outline() {
        return new Outline.Frustum(
                forward,
                right,
                up,
                0.5 * width / focalLength,
                0.5 * height / focalLength,
                (0.5 * width - axisColumn) / focalLength,
                (axisRow - 0.5 * height) / focalLength,
                lens.near(),
                lens.limit());
    }

    /** Distance of the near plane along the axis, m: nothing closer is seen. */
    public double near() {
        return lens.near();
    }

    /** Distance of the far plane along the axis, m: nothing farther is seen; infinity for no limit. */
    public double far() {
        return lens.limit();
    }

    /** The position of the camera, m. */
    public Position position() {
        return position;
    }

    /** The number of pixels per row. */
    public int width() {
        return width;
    }

    /** The number of rows of the image. */
    public int height() {
        return height;
    }

    /** Focal length in pixels. */
    public double focalLength() {
        return focalLength;
    }
}
