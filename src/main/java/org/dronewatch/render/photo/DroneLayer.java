package org.dronewatch.render.photo;

import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.optics.CameraObject;
import org.jogamp.vecmath.Matrix4d;
import org.jogamp.vecmath.Point2d;

/**
 * One drone in one picture: its surfaces, where it may appear, and the transformation into its model's space.
 * Immutable.
 */
final class DroneLayer {
    private final Drone drone;
    private final Surfaces surfaces;
    private final Matrix4d toModel;
    private final double left;
    private final double top;
    private final double right;
    private final double bottom;

    DroneLayer(Drone drone, Surfaces surfaces, CameraObject camera) {
        this.drone = drone;
        this.surfaces = surfaces;
        this.toModel = drone.worldToModel();
        Position at = drone.origin();
        double reach = drone.radius();
        double[] view = new double[3];
        camera.toView(at.x(), at.y(), at.z(), view, 0);
        double near = view[2] - reach;
        if (camera.isOutside(at.x(), at.y(), at.z(), reach)) {
            left = Double.POSITIVE_INFINITY;
            top = Double.POSITIVE_INFINITY;
            right = Double.NEGATIVE_INFINITY;
            bottom = Double.NEGATIVE_INFINITY;
        } else if (near <= CameraObject.NEAR) {
            left = 0.0;
            top = 0.0;
            right = camera.width();
            bottom = camera.height();
        } else {
            double focal = camera.focalLength();
            double far = view[2] + reach;
            // Not the middle of the image where the lens is shifted.
            Position ahead = camera.position().plus(camera.outline().forward());
            Point2d axis = camera.pixelOf(ahead.toPoint3d()).orElseThrow();
            left = axis.x + focal * Math.min((view[0] - reach) / near, (view[0] - reach) / far);
            right = axis.x + focal * Math.max((view[0] + reach) / near, (view[0] + reach) / far);
            top = axis.y - focal * Math.max((view[1] + reach) / near, (view[1] + reach) / far);
            bottom = axis.y - focal * Math.min((view[1] - reach) / near, (view[1] - reach) / far);
        }
    }

    Drone drone() {
        return drone;
    }

    Surfaces surfaces() {
        return surfaces;
    }

    /** Whether it may appear in a rectangle of pixels. */
    boolean mayAppear(int column, int row, int columns, int rows) {
        return right >= column && left <= column + columns && bottom >= row && top <= row + rows;
    }

    /** Transforms a point of the world into the model's space, or a direction if the last component is 0. */
    void toModel(double[] vector, double last, double[] target) {
        Matrix4d m = toModel;
        target[0] = m.m00 * vector[0] + m.m01 * vector[1] + m.m02 * vector[2] + last * m.m03;
        target[1] = m.m10 * vector[0] + m.m11 * vector[1] + m.m12 * vector[2] + last * m.m13;
        target[2] = m.m20 * vector[0] + m.m21 * vector[1] + m.m22 * vector[2] + last * m.m23;
    }

    /**
     * Writes the normal of a triangle in the world's frame, of any length: normals are transformed by the transposed
     * inverse.
     */
    void normal(int triangle, double[] scratch, double[] target) {
        surfaces.normal(triangle, scratch);
        Matrix4d m = toModel;
        target[0] = m.m00 * scratch[0] + m.m10 * scratch[1] + m.m20 * scratch[2];
        target[1] = m.m01 * scratch[0] + m.m11 * scratch[1] + m.m21 * scratch[2];
        target[2] = m.m02 * scratch[0] + m.m12 * scratch[1] + m.m22 * scratch[2];
    }
}
