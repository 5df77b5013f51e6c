package org.dronewatch.scenes;

import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.kdtree.StackTraversal;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.world.World;
import org.jogamp.vecmath.Matrix4d;

/** Counts a drone's pixels by tracing every pixel of the picture anew: no significant pixels, nothing remembered. */
final class EveryPixel {
    private EveryPixel() {}

    static int count(CameraObject camera, World world, Drone drone) {
        RayTracer ground = world.newRayTracer();
        RayTracer body = new StackTraversal(drone.tree());
        Matrix4d m = drone.worldToModel();
        Position eye = camera.position();
        double x = m.m00 * eye.x() + m.m01 * eye.y() + m.m02 * eye.z() + m.m03;
        double y = m.m10 * eye.x() + m.m11 * eye.y() + m.m12 * eye.z() + m.m13;
        double z = m.m20 * eye.x() + m.m21 * eye.y() + m.m22 * eye.z() + m.m23;
        double[] d = new double[3];
        int count = 0;
        for (int row = 0; row < camera.height(); row++) {
            for (int column = 0; column < camera.width(); column++) {
                camera.direction(column, row, d);
                double dx = m.m00 * d[0] + m.m01 * d[1] + m.m02 * d[2];
                double dy = m.m10 * d[0] + m.m11 * d[1] + m.m12 * d[2];
                double dz = m.m20 * d[0] + m.m21 * d[1] + m.m22 * d[2];
                if (body.closestHit(x, y, z, dx, dy, dz, 0.0, Double.POSITIVE_INFINITY)
                        && !ground.isOccluded(eye.x(), eye.y(), eye.z(), d[0], d[1], d[2], 0.0, body.distance())) {
                    count++;
                }
            }
        }
        return count;
    }
}
