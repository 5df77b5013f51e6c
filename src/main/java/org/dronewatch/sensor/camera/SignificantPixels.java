package org.dronewatch.sensor.camera;

import org.dronewatch.geometry.AABB;
import org.dronewatch.world.Drone;
import org.jogamp.vecmath.Point3d;
import org.joml.Matrix4d;
import org.joml.Vector4d;

/**
 * The pixels that can show a drone: those inside the projection of its bounding box. Corners behind the camera would flip
 * through the projection's divide, so the box's edges are cut at the near plane first.
 */
final class SignificantPixels {
    /** Rounding of the projection, in pixels: a rectangle a little too large costs nothing. */
    private static final double MARGIN = 1e-6;

    private static final int CORNERS = 8;

    private final CameraObject camera;

    SignificantPixels(CameraObject camera) {
        this.camera = camera;
    }

    /** The rectangle of pixels around a drone, within the picture. */
    PixelRectangle of(Drone drone) {
        Point3d place = drone.position();
        // Most cameras of a site look elsewhere: they are done here.
        if (camera.isOutside(place.x, place.y, place.z, drone.reach())) {
            return PixelRectangle.EMPTY;
        }
        Matrix4d toClip = camera.modelViewProjection(drone.modelMatrix());
        Vector4d[] clip = clipCorners(drone.modelBounds(), toClip);
        Bounds bounds = new Bounds();
        for (int corner = 0; corner < CORNERS; corner++) {
            if (isVisible(clip[corner])) {
                bounds.add(clip[corner]);
            }
            // The corners differ from their neighbours in one bit: each of the box's twelve edges once.
            for (int bit = 1; bit < CORNERS; bit <<= 1) {
                int other = corner | bit;
                if (other != corner && isVisible(clip[corner]) != isVisible(clip[other])) {
                    bounds.add(atNearPlane(clip[corner], clip[other]));
                }
            }
        }
        return bounds.toRectangle();
    }

    private static Vector4d[] clipCorners(AABB box, Matrix4d toClip) {
        Point3d[] corners = box.corners();
        Vector4d[] clip = new Vector4d[CORNERS];
        for (int i = 0; i < CORNERS; i++) {
            clip[i] = toClip.transform(new Vector4d(corners[i].x, corners[i].y, corners[i].z, 1.0));
        }
        return clip;
    }

    /** In front of the near plane: w is the depth along the camera's axis. */
    private static boolean isVisible(Vector4d clip) {
        return clip.w >= CameraObject.NEAR;
    }

    private static Vector4d atNearPlane(Vector4d from, Vector4d to) {
        double fraction = (CameraObject.NEAR - from.w) / (to.w - from.w);
        return new Vector4d(from).lerp(to, fraction);
    }

    /** The smallest rectangle around what was added. */
    private final class Bounds {
        private double left = Double.POSITIVE_INFINITY;
        private double top = Double.POSITIVE_INFINITY;
        private double right = Double.NEGATIVE_INFINITY;
        private double bottom = Double.NEGATIVE_INFINITY;

        void add(Vector4d clip) {
            left = Math.min(left, camera.column(clip));
            right = Math.max(right, camera.column(clip));
            top = Math.min(top, camera.row(clip));
            bottom = Math.max(bottom, camera.row(clip));
        }

        /** The pixels whose centres lie inside. */
        PixelRectangle toRectangle() {
            double first = 0.5 + MARGIN;
            double last = 0.5 - MARGIN;
            PixelRectangle rectangle = new PixelRectangle(
                    (int) Math.max(0.0, Math.ceil(left - first)),
                    (int) Math.max(0.0, Math.ceil(top - first)),
                    (int) Math.min(camera.width() - 1.0, Math.floor(right - last)),
                    (int) Math.min(camera.height() - 1.0, Math.floor(bottom - last)));
            return rectangle.isEmpty() ? PixelRectangle.EMPTY : rectangle;
        }
    }
}
