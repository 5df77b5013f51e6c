package org.dronewatch.sensor.optics;

import java.util.function.DoublePredicate;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.silhouette.SilhouetteMask;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.sensor.Outline;
import org.dronewatch.world.World;
import org.jogamp.vecmath.Matrix4d;

/**
 * The area of a drone in a camera's image, in pixels and fractions of pixels: for drones smaller than a pixel, and for
 * thermal images, in which a pixel integrates over its area. The drone is sampled by rays whose spacing adapts to its
 * size, so that the area is accurate to a few percent at any distance. Occlusion by other drones is left out. For use
 * by one thread at a time.
 */
public final class VisibleArea {
    /**
     * The step in number from one ray to the next that is traced: after a few steps, the rays are spread over the whole
     * square.
     */
    private static final int STRIDE = 377;

    /** The factor by which the area must grow before it is checked again whether it is enough. */
    private static final double MORE = 1.25;

    private static final DoublePredicate NEVER = area -> false;

    private final CameraObject camera;
    private final RayBundle bundle;
    private final Outline.Frustum outline;
    private final Matrix4d toModel = new Matrix4d();

    /** The contribution of each ray to the area, pixels. */
    private final double[] parts = new double[RayBundle.RAYS];

    private boolean isObstructed;

    // The position of the camera in the drone's model.
    private double fromX;
    private double fromY;
    private double fromZ;

    // The tracer of the drone that was traced last; null if there is none.
    private KDTree traced;
    private RayTracer tracer;

    /** Areas in the image of a camera in a world. */
    public VisibleArea(CameraObject camera, World world) {
        this.camera = camera;
        this.bundle = new RayBundle(camera, world);
        this.outline = camera.outline();
    }

    /** The world. */
    public World world() {
        return bundle.world();
    }

    /** The camera. */
    public CameraObject camera() {
        return camera;
    }

    /** The rays. */
    RayBundle bundle() {
        return bundle;
    }

    /** The area in the image of the part of a drone that the site does not hide, in pixels. */
    public double of(Drone drone) {
        return of(drone, NEVER);
    }

    /**
     * The area that {@link #of(Drone)} gives, or a smaller area if that is already sufficient, in pixels.
     *
     * @param enough whether an area is sufficient; if it is, every larger area must be as well
     */
    public double of(Drone drone, DoublePredicate enough) {
        return of(drone, false, enough, null);
    }

    /**
     * The area of a drone that nothing hides, or a smaller area if that is already sufficient, in pixels; in all other
     * respects as {@link #of(Drone, DoublePredicate)}.
     *
     * @param silhouette decides the outcome of many rays; its bounds must be {@linkplain SilhouetteArea#isOf those} of
     *     the drone
     */
    public double ofClear(Drone drone, SilhouetteArea silhouette, DoublePredicate enough) {
        return of(drone, true, enough, silhouette);
    }

    /**
     * The area of a drone that the site may hide in part, or a smaller area if that is already sufficient, in pixels;
     * parameters as for {@link #ofClear}.
     */
    public double of(Drone drone, SilhouetteArea silhouette, DoublePredicate enough) {
        return of(drone, false, enough, silhouette);
    }

    /** The area that a drone would have in the image if nothing hid it, in pixels. */
    public double inTheOpen(Drone drone) {
        return inTheOpen(drone, NEVER);
    }

    /** The area that {@link #inTheOpen(Drone)} gives, or a smaller area if that is already sufficient, in pixels. */
    public double inTheOpen(Drone drone, DoublePredicate enough) {
        return of(drone, true, enough, null);
    }

    private double of(Drone drone, boolean open, DoublePredicate enough, SilhouetteArea silhouette) {
        isObstructed = false;
        Position from = camera.position();
        Position at = drone.origin();
        Position vector = at.minus(from);
        double range = vector.length();
        double radius = drone.radius();
        if (camera.isOutside(at.x(), at.y(), at.z(), radius)) {
            return 0.0;
        }
        if (range <= radius) {
            // The drone sits on the lens, which a near plane keeps clear, or on the back of the camera.
            return camera.near() > 0.0 || vector.dot(outline.forward()) < 0.0
                    ? 0.0
                    : (double) camera.width() * camera.height();
        }
        bundle.set(vector, range, radius);
        RayTracer model = tracer(drone);
        double found = 0.0;
        double asked = 0.0;
        for (int number = 0; number < RayBundle.RAYS; number++) {
            int i = inOrder(number);
            byte kind = silhouette == null ? SilhouetteMask.LIKELY : silhouette.kind(i);
            boolean isSeen = kind != SilhouetteMask.OUTSIDE
                    && (silhouette == null ? seen(model, i, open) : seen(model, i, open, kind));
            parts[i] = isSeen ? bundle.part(i) : 0.0;
            found += parts[i];
            if (found > asked) {
                if (enough.test(found)) {
                    return found;
                }
                asked = MORE * found;
            }
        }
        // Always added up in the same order, so that the rounding does not depend on the order of tracing.
        double area = 0.0;
        for (double part : parts) {
            area += part;
        }
        return area;
    }

    /** The ray that is traced after a number of others. */
    static int inOrder(int number) {
        return number * STRIDE % RayBundle.RAYS;
    }

    /** The tracer of a drone's own mesh, with the drone at its present position. */
    RayTracer tracer(Drone drone) {
        Position at = camera.position();
        Matrix4d m = toModel;
        drone.worldToModel(m);
        fromX = m.m00 * at.x() + m.m01 * at.y() + m.m02 * at.z() + m.m03;
        fromY = m.m10 * at.x() + m.m11 * at.y() + m.m12 * at.z() + m.m13;
        fromZ = m.m20 * at.x() + m.m21 * at.y() + m.m22 * at.z() + m.m23;
        if (drone.tree() != traced) {
            traced = drone.tree();
            tracer = drone.newRayTracer();
        }
        return tracer;
    }

    /**
     * Whether a ray of the bundle as it is set meets the drone, whether or not the site is in its way.
     *
     * @param model the {@link #tracer} of the drone, the one requested last
     */
    boolean meets(RayTracer model, int ray) {
        bundle.aim(ray);
        return isHit(model);
    }

    private boolean seen(RayTracer model, int ray, boolean open) {
        boolean hit = meets(model, ray);
        boolean isSeen = hit && (open || bundle.isFree(model.distance()));
        isObstructed |= hit && !isSeen;
        return isSeen;
    }

    /**
     * Whether a ray shows the drone, if a mask states something about that ray: the ray is traced only if the mask
     * leaves it in doubt.
     */
    private boolean seen(RayTracer model, int ray, boolean open, byte kind) {
        if (!open && isObstructed && bundle.isKnownHidden(ray)) {
            return false;
        }
        bundle.aim(ray);
        boolean isInside = kind == SilhouetteMask.INSIDE;
        if (!isInside && !isHit(model)) {
            return false;
        }
        byte sight = open ? RayBundle.FREE : bundle.sight(ray);
        if (sight == RayBundle.UNCERTAIN) {
            return seen(model, ray, false);
        }
        isObstructed |= sight == RayBundle.HIDDEN;
        return sight == RayBundle.FREE;
    }

    /** Whether the ray of the bundle that was aimed last meets the drone; the tracer states where. */
    private boolean isHit(RayTracer model) {
        double depth = bundle.depth();
        if (depth <= 0.0) {
            return false;
        }
        double x = bundle.x();
        double y = bundle.y();
        double z = bundle.z();
        Matrix4d m = toModel;
        return model.closestHit(
                fromX,
                fromY,
                fromZ,
                m.m00 * x + m.m01 * y + m.m02 * z,
                m.m10 * x + m.m11 * y + m.m12 * z,
                m.m20 * x + m.m21 * y + m.m22 * z,
                camera.near() / depth,
                camera.far() / depth);
    }

    /** Whether the site hid any part of the drone whose area was last requested. */
    public boolean isObstructed() {
        return isObstructed;
    }
}
