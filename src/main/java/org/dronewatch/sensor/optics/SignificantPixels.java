package org.dronewatch.sensor.optics;

import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.AABB;
import org.jogamp.vecmath.Matrix4d;

/**
 * The pixels that can show a drone: those inside the projection of its bounding box. Corners behind the camera would
 * flip through the projection's divide, so the box's edges are cut at the near plane first. Allocates nothing. For use
 * by one thread.
 */
final class SignificantPixels {
    /**
     * Tolerance for the rounding of the projection, in pixels: a rectangle that is a little too large costs nothing.
     */
    private static final double MARGIN = 1e-6;

    private static final int CORNERS = 8;

    private final CameraObject camera;
    private final Matrix4d model = new Matrix4d();

    /** The box's corners in the camera's frame: to the right, up and ahead. */
    private final double[] corners = new double[3 * CORNERS];

    // The smallest rectangle around the points added so far, in pixels.
    private double left;
    private double top;
    private double right;
    private double bottom;

    SignificantPixels(CameraObject camera) {
        this.camera = camera;
    }

    /** Finds the rectangle of pixels around a drone, within the image. */
    void find(Drone drone, PixelRectangle target) {
        target.clear();
        drone.modelMatrix(model);
        // Most cameras of a site look elsewhere: for them, nothing more needs to be done.
        if (camera.isOutside(model.m03, model.m13, model.m23, drone.radius())) {
            return;
        }
        setCorners(drone.modelBounds());
        left = Double.POSITIVE_INFINITY;
        top = Double.POSITIVE_INFINITY;
        right = Double.NEGATIVE_INFINITY;
        bottom = Double.NEGATIVE_INFINITY;
        for (int corner = 0; corner < CORNERS; corner++) {
            if (isAhead(corner)) {
                add(corners[3 * corner], corners[3 * corner + 1], corners[3 * corner + 2]);
            }
            // The corners differ from their neighbours in one bit: each of the box's twelve edges once.
            for (int bit = 1; bit < CORNERS; bit <<= 1) {
                int other = corner | bit;
                if (other != corner && isAhead(corner) != isAhead(other)) {
                    addAtNearPlane(3 * corner, 3 * other);
                }
            }
        }
        setRectangle(target);
    }

    private void setCorners(AABB box) {
        for (int corner = 0; corner < CORNERS; corner++) {
            double x = (corner & 1) == 0 ? box.minX() : box.maxX();
            double y = (corner & 2) == 0 ? box.minY() : box.maxY();
            double z = (corner & 4) == 0 ? box.minZ() : box.maxZ();
            camera.toView(
                    model.m00 * x + model.m01 * y + model.m02 * z + model.m03,
                    model.m10 * x + model.m11 * y + model.m12 * z + model.m13,
                    model.m20 * x + model.m21 * y + model.m22 * z + model.m23,
                    corners,
                    3 * corner);
        }
    }

    private boolean isAhead(int corner) {
        return corners[3 * corner + 2] >= CameraObject.NEAR;
    }

    private void addAtNearPlane(int from, int to) {
        double fraction = (CameraObject.NEAR - corners[from + 2]) / (corners[to + 2] - corners[from + 2]);
        add(
                corners[from] + fraction * (corners[to] - corners[from]),
                corners[from + 1] + fraction * (corners[to + 1] - corners[from + 1]),
                CameraObject.NEAR);
    }

    private void add(double across, double above, double ahead) {
        double column = camera.column(across, ahead);
        double row = camera.row(above, ahead);
        left = Math.min(left, column);
        right = Math.max(right, column);
        top = Math.min(top, row);
        bottom = Math.max(bottom, row);
    }

    /** Sets the rectangle to the pixels whose centres lie inside. */
    private void setRectangle(PixelRectangle target) {
        double first = 0.5 + MARGIN;
        double last = 0.5 - MARGIN;
        target.set(
                (int) Math.max(0.0, Math.ceil(left - first)),
                (int) Math.max(0.0, Math.ceil(top - first)),
                (int) Math.min(camera.width() - 1.0, Math.floor(right - last)),
                (int) Math.min(camera.height() - 1.0, Math.floor(bottom - last)));
        if (target.isEmpty()) {
            target.clear();
        }
    }
}
