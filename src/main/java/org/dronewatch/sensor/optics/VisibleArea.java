package org.dronewatch.sensor.optics;

import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.kdtree.StackTraversal;
import org.dronewatch.sensor.Outline;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;
import org.jogamp.vecmath.Matrix4d;
import org.jogamp.vecmath.Vector3d;

/**
 * How much of a camera's picture a drone covers, in pixels and parts of pixels: for what is smaller than a pixel, and for
 * heat, of which a pixel gathers what falls on any part of it. The drone is looked at by rays as close together as its size
 * asks for, so that the area is right to some percent however far away it is. Drones do not hide each other. One thread.
 */
public final class VisibleArea {
    /**
     * So many rays over the square about a drone, as a Fibonacci lattice: no edge of a drone runs along its rows, as edges run
     * along those of a grid.
     */
    private static final int RAYS = 987;

    private static final int STEP = 610;

    private final CameraObject camera;
    private final Visibility visibility;
    private final Vector3d forward;
    private final Vector3d right;
    private final Vector3d up;
    private final Matrix4d toModel = new Matrix4d();

    /** For the picture of a camera in a world. */
    public VisibleArea(CameraObject camera, World world) {
        this.camera = camera;
        this.visibility = new Visibility(world);
        Outline.Pyramid outline = camera.outline();
        this.forward = outline.forward().toVector3d();
        this.right = outline.right().toVector3d();
        this.up = outline.up().toVector3d();
    }

    /** The world that it is in. */
    public World world() {
        return visibility.world();
    }

    /** The area of a drone that is in the picture and that nothing of the site hides, in pixels. */
    public double of(Drone drone) {
        return of(drone, false);
    }

    /** The area of a drone that would be in the picture if nothing stood in the way, in pixels. */
    public double inTheOpen(Drone drone) {
        return of(drone, true);
    }

    private double of(Drone drone, boolean open) {
        Position from = camera.position();
        Vector3d way = Position.of(drone.position()).minus(from).toVector3d();
        double range = way.length();
        double reach = drone.reach();
        if (camera.isOutside(drone.position().x, drone.position().y, drone.position().z, reach)) {
            return 0.0;
        }
        if (range <= reach) {
            // It sits on the lens, or on the back of the camera.
            return way.dot(forward) < 0.0 ? 0.0 : (double) camera.width() * camera.height();
        }
        way.scale(1.0 / range);
        Vector3d top = Math.abs(way.z) < 0.9 ? new Vector3d(0, 0, 1) : new Vector3d(0, 1, 0);
        Vector3d aside = new Vector3d();
        aside.cross(way, top);
        aside.normalize();
        Vector3d above = new Vector3d();
        above.cross(aside, way);
        // What a ball of the drone's reach covers at 1 m before the camera.
        double half = reach / Math.sqrt(range * range - reach * reach);
        double share = 4.0 * half * half / RAYS;
        drone.worldToModel(toModel);
        RayTracer model = new StackTraversal(drone.tree());
        double area = 0.0;
        Vector3d ray = new Vector3d();
        for (int i = 0; i < RAYS; i++) {
            double u = half * (2.0 * (i + 0.5) / RAYS - 1.0);
            double v = half * (2.0 * ((long) i * STEP % RAYS + 0.5) / RAYS - 1.0);
            ray.scaleAdd(u, aside, way);
            ray.scaleAdd(v, above, ray);
            area += seen(model, ray, open) ? pixels(ray, share) : 0.0;
        }
        return area;
    }

    private boolean seen(RayTracer model, Vector3d ray, boolean open) {
        Position at = camera.position();
        Matrix4d m = toModel;
        boolean hit = model.closestHit(
                m.m00 * at.x() + m.m01 * at.y() + m.m02 * at.z() + m.m03,
                m.m10 * at.x() + m.m11 * at.y() + m.m12 * at.z() + m.m13,
                m.m20 * at.x() + m.m21 * at.y() + m.m22 * at.z() + m.m23,
                m.m00 * ray.x + m.m01 * ray.y + m.m02 * ray.z,
                m.m10 * ray.x + m.m11 * ray.y + m.m12 * ray.z,
                m.m20 * ray.x + m.m21 * ray.y + m.m22 * ray.z,
                0.0,
                Double.POSITIVE_INFINITY);
        return hit && (open || visibility.isFreeAlong(at.x(), at.y(), at.z(), ray.x, ray.y, ray.z, model.distance()));
    }

    /**
     * How many pixels a ray of the bundle stands for; none outside the picture.
     *
     * @param share of the plane across the way to the drone, 1 m before the camera, m2
     */
    private double pixels(Vector3d ray, double share) {
        double ahead = ray.dot(forward);
        if (ahead <= 0.0) {
            return 0.0;
        }
        double x = ray.dot(right) / ahead;
        double y = ray.dot(up) / ahead;
        double focal = camera.focalLength();
        if (Math.abs(x) * focal > 0.5 * camera.width() || Math.abs(y) * focal > 0.5 * camera.height()) {
            return 0.0;
        }
        // Solid angle of the ray's cell, then of a pixel there: both shrink with the cube of the length.
        double length = ray.length();
        double solid = share / (length * length * length);
        double oblique = Math.sqrt(1.0 + x * x + y * y);
        return solid * focal * focal * oblique * oblique * oblique;
    }
}
