package org.dronewatch.sensor.optics;

import java.util.function.DoublePredicate;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.SilhouetteMask;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.kdtree.StackTraversal;
import org.dronewatch.sensor.Outline;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;
import org.jogamp.vecmath.Matrix4d;

/**
 * The area of a drone in a camera's image, in pixels and fractions of pixels: for drones smaller than a pixel, and for
 * thermal images, in which a pixel integrates over its area. The drone is sampled by rays whose spacing adapts to its
 * size, so that the area is accurate to a few percent at any distance. Drones do not hide each other. One thread at a
 * time.
 */
public final class VisibleArea {
    /**
     * Number of rays over the square around a drone, as a Fibonacci lattice: no edge of a drone runs along its rows, as
     * edges run along those of a grid.
     */
    static final int RAYS = 987;

    private static final int STEP = 610;

    /** From one ray to the next that is traced: after a few, they are spread over the whole square. */
    private static final int STRIDE = 377;

    /** How much larger an area must be before it is asked again whether it is enough. */
    private static final double MORE = 1.25;

    private static final DoublePredicate NEVER = area -> false;

    private final CameraObject camera;
    private final Visibility visibility;
    private final Outline.Frustum outline;
    private final Matrix4d toModel = new Matrix4d();

    /** What each ray adds to the area, pixels. */
    private final double[] parts = new double[RAYS];

    private boolean isObstructed;

    // The bundle of rays: its middle, which has length 1, its axes, and what a ray stands for in the plane 1 m away.
    private Position ahead;
    private Position aside;
    private Position above;
    private double half;
    private double cellArea;

    /** Areas in the image of a camera in a world. */
    public VisibleArea(CameraObject camera, World world) {
        this.camera = camera;
        this.visibility = new Visibility(world);
        this.outline = camera.outline();
    }

    /** The world. */
    public World world() {
        return visibility.world();
    }

    /** The camera. */
    public CameraObject camera() {
        return camera;
    }

    /** The area of a drone that is in the image and not hidden by the site, in pixels. */
    public double of(Drone drone) {
        return of(drone, NEVER);
    }

    /**
     * The same, or less if that is enough.
     *
     * @param enough whether an area is sufficient; if it is, every larger area must be as well
     */
    public double of(Drone drone, DoublePredicate enough) {
        return of(drone, false, enough, null);
    }

    /**
     * The same for a drone that nothing hides, or less if that is enough.
     *
     * @param silhouette knows many of the rays: its bounds must be {@linkplain SilhouetteArea#isOf those} of the drone
     */
    public double ofClear(Drone drone, SilhouetteArea silhouette, DoublePredicate enough) {
        return of(drone, true, enough, silhouette);
    }

    /** The area of a drone that would be in the image without obstructions, in pixels. */
    public double inTheOpen(Drone drone) {
        return inTheOpen(drone, NEVER);
    }

    /** The same, or less if that is enough; parameters as above. */
    public double inTheOpen(Drone drone, DoublePredicate enough) {
        return of(drone, true, enough, null);
    }

    private double of(Drone drone, boolean open, DoublePredicate enough, SilhouetteArea silhouette) {
        isObstructed = false;
        Position from = camera.position();
        Position at = drone.origin();
        Position vector = at.minus(from);
        double range = vector.length();
        double reach = drone.reach();
        if (camera.isOutside(at.x(), at.y(), at.z(), reach)) {
            return 0.0;
        }
        if (range <= reach) {
            // It sits on the lens, which a near plane keeps free, or on the back of the camera.
            return camera.near() > 0.0 || vector.dot(outline.forward()) < 0.0
                    ? 0.0
                    : (double) camera.width() * camera.height();
        }
        setBundle(vector, range, halfWidth(range, reach));
        drone.worldToModel(toModel);
        RayTracer model = new StackTraversal(drone.tree());
        double found = 0.0;
        double asked = 0.0;
        for (int number = 0; number < RAYS; number++) {
            int i = number * STRIDE % RAYS;
            double u = half * across(i);
            double v = half * upwards(i);
            double x = v * above.x() + (u * aside.x() + ahead.x());
            double y = v * above.y() + (u * aside.y() + ahead.y());
            double z = v * above.z() + (u * aside.z() + ahead.z());
            byte kind = silhouette == null ? SilhouetteMask.LIKELY : silhouette.kind(i);
            boolean isSeen =
                    kind == SilhouetteMask.INSIDE || kind != SilhouetteMask.OUTSIDE && seen(model, x, y, z, open);
            parts[i] = isSeen ? pixels(x, y, z) : 0.0;
            found += parts[i];
            if (found > asked) {
                if (enough.test(found)) {
                    return found;
                }
                asked = MORE * found;
            }
        }
        // Always in the same order, whose rounding does not depend on that of tracing.
        double area = 0.0;
        for (double part : parts) {
            area += part;
        }
        return area;
    }

    /** What the drone's bounding sphere covers 1 m in front of the camera: half of a square's side, m. */
    static double halfWidth(double range, double reach) {
        return reach / Math.sqrt(range * range - reach * reach);
    }

    /** The position of a ray of the bundle to the side, from -1 to 1. */
    static double across(int ray) {
        return 2.0 * (ray + 0.5) / RAYS - 1.0;
    }

    /** Its position upwards, from -1 to 1. */
    static double upwards(int ray) {
        return 2.0 * ((long) ray * STEP % RAYS + 0.5) / RAYS - 1.0;
    }

    /** Sets the bundle of rays around a vector from the camera. */
    void setBundle(Position vector, double range, double halfWidth) {
        ahead = vector.times(1.0 / range);
        Position top = Math.abs(ahead.z()) < 0.9 ? new Position(0, 0, 1) : new Position(0, 1, 0);
        aside = ahead.cross(top).unit();
        above = aside.cross(ahead);
        half = halfWidth;
        cellArea = 4.0 * half * half / RAYS;
    }

    /** How many pixels a ray of the bundle stands for, if it shows the drone. */
    double part(int ray) {
        double u = half * across(ray);
        double v = half * upwards(ray);
        return pixels(
                v * above.x() + (u * aside.x() + ahead.x()),
                v * above.y() + (u * aside.y() + ahead.y()),
                v * above.z() + (u * aside.z() + ahead.z()));
    }

    private boolean seen(RayTracer model, double x, double y, double z, boolean open) {
        double depth = along(outline.forward(), x, y, z);
        if (depth <= 0.0) {
            return false;
        }
        Position at = camera.position();
        Matrix4d m = toModel;
        double start = camera.near() / depth;
        boolean hit = model.closestHit(
                m.m00 * at.x() + m.m01 * at.y() + m.m02 * at.z() + m.m03,
                m.m10 * at.x() + m.m11 * at.y() + m.m12 * at.z() + m.m13,
                m.m20 * at.x() + m.m21 * at.y() + m.m22 * at.z() + m.m23,
                m.m00 * x + m.m01 * y + m.m02 * z,
                m.m10 * x + m.m11 * y + m.m12 * z,
                m.m20 * x + m.m21 * y + m.m22 * z,
                start,
                camera.far() / depth);
        boolean isSeen = hit && (open || isFree(start, x, y, z, model.distance()));
        isObstructed |= hit && !isSeen;
        return isSeen;
    }

    /** Whether the site hid any part of the drone whose area was asked for last. */
    public boolean isObstructed() {
        return isObstructed;
    }

    /** Whether the site leaves a ray free from the near plane on. */
    private boolean isFree(double start, double x, double y, double z, double end) {
        Position at = camera.position();
        return visibility.isFreeAlong(at.x() + start * x, at.y() + start * y, at.z() + start * z, x, y, z, end - start);
    }

    /**
     * How many pixels a ray of the bundle stands for; none outside the image.
     */
    private double pixels(double rayX, double rayY, double rayZ) {
        double depth = along(outline.forward(), rayX, rayY, rayZ);
        if (depth <= 0.0) {
            return 0.0;
        }
        double x = along(outline.right(), rayX, rayY, rayZ) / depth;
        double y = along(outline.up(), rayX, rayY, rayZ) / depth;
        double focal = camera.focalLength();
        double fromMiddle = Math.abs(x - outline.middleRight());
        double overMiddle = Math.abs(y - outline.middleUp());
        if (fromMiddle * focal > 0.5 * camera.width() || overMiddle * focal > 0.5 * camera.height()) {
            return 0.0;
        }
        // Solid angle of the ray's cell, then of a pixel there: both shrink with the cube of the length.
        double length = Math.sqrt(rayX * rayX + rayY * rayY + rayZ * rayZ);
        double solid = cellArea / (length * length * length);
        double oblique = Math.sqrt(1.0 + x * x + y * y);
        return solid * focal * focal * oblique * oblique * oblique;
    }

    private static double along(Position axis, double x, double y, double z) {
        return x * axis.x() + y * axis.y() + z * axis.z();
    }
}
