package org.dronewatch.sensor.optics;

import java.util.Arrays;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Outline;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * The rays of a {@link VisibleArea}: a bundle over the square around a drone's bounding sphere. Everything that does
 * not depend on how the drone turns is found once for each ray and position: how many pixels the ray represents, and
 * whether the site obstructs it. Not thread-safe.
 */
final class RayBundle {
    /**
     * Number of rays over the square around a drone, as a Fibonacci lattice: no edge of a drone runs along its rows, as
     * edges run along those of a grid.
     */
    static final int RAYS = 987;

    /** The site hides all of the drone that a ray may show. */
    static final byte HIDDEN = 1;

    /** The site may hide some of the drone that a ray may show. */
    static final byte UNCERTAIN = 2;

    /** The site hides no part of the drone that a ray may show. */
    static final byte FREE = 3;

    private static final byte UNKNOWN = 0;
    private static final int STEP = 610;

    /** Tolerance for the rounding of distances to the drone, which are of single precision. */
    private static final double ROUNDING = 1e-6;

    private static final double[] ACROSS = new double[RAYS];
    private static final double[] UPWARDS = new double[RAYS];

    static {
        for (int ray = 0; ray < RAYS; ray++) {
            ACROSS[ray] = 2.0 * (ray + 0.5) / RAYS - 1.0;
            UPWARDS[ray] = 2.0 * ((long) ray * STEP % RAYS + 0.5) / RAYS - 1.0;
        }
    }

    private final CameraObject camera;
    private final Visibility visibility;
    private final Outline.Frustum outline;
    private final double[] parts = new double[RAYS];
    private final byte[] sights = new byte[RAYS];

    // The bundle: its middle, which has length 1, its axes, and the area that a ray represents in the plane 1 m away.
    private Position vector;
    private double range;
    private double reach;
    private Position ahead;
    private Position aside;
    private Position above;
    private double half;
    private double cellArea;

    // The ray at which the bundle was last aimed, and its component along the axis of the camera.
    private double x;
    private double y;
    private double z;
    private double depth;

    RayBundle(CameraObject camera, World world) {
        this.camera = camera;
        this.visibility = new Visibility(world);
        this.outline = camera.outline();
    }

    /** The world. */
    World world() {
        return visibility.world();
    }

    /** The position of a ray in the square, to the side, from -1 to 1. */
    static double across(int ray) {
        return ACROSS[ray];
    }

    /** The position of a ray in the square, upwards, from -1 to 1. */
    static double upwards(int ray) {
        return UPWARDS[ray];
    }

    /**
     * Sets the bundle around a vector from the camera.
     *
     * @param to the vector, m
     * @param distance length of the vector, m
     * @param radius largest distance of the drone's mesh from its origin, less than that length, m
     */
    void set(Position to, double distance, double radius) {
        if (to.equals(vector) && radius == reach) {
            return;
        }
        vector = to;
        range = distance;
        reach = radius;
        ahead = to.times(1.0 / distance);
        Position top = Math.abs(ahead.z()) < 0.9 ? new Position(0, 0, 1) : new Position(0, 1, 0);
        aside = ahead.cross(top).unit();
        above = aside.cross(ahead);
        half = radius / Math.sqrt(distance * distance - radius * radius);
        cellArea = 4.0 * half * half / RAYS;
        Arrays.fill(parts, Double.NaN);
        Arrays.fill(sights, UNKNOWN);
    }

    /** Half the side of the square that the drone's bounding sphere covers 1 m in front of the camera, m. */
    double half() {
        return half;
    }

    /** Sets the ray to which {@link #depth} and {@link #isFree} refer. */
    void aim(int ray) {
        double u = half * ACROSS[ray];
        double v = half * UPWARDS[ray];
        x = v * above.x() + (u * aside.x() + ahead.x());
        y = v * above.y() + (u * aside.y() + ahead.y());
        z = v * above.z() + (u * aside.z() + ahead.z());
        depth = along(outline.forward());
    }

    /** The x coordinate of the ray that was aimed last. */
    double x() {
        return x;
    }

    double y() {
        return y;
    }

    double z() {
        return z;
    }

    /** The component of the ray that was aimed last along the axis of the camera. */
    double depth() {
        return depth;
    }

    private double along(Position axis) {
        return x * axis.x() + y * axis.y() + z * axis.z();
    }

    /** Whether the site leaves the ray that was aimed last unobstructed, from the near plane on. */
    boolean isFree(double end) {
        Position at = camera.position();
        double start = camera.near() / depth;
        return visibility.isFreeAlong(at.x() + start * x, at.y() + start * y, at.z() + start * z, x, y, z, end - start);
    }

    /** Whether the site is already known to hide all of the drone that a ray may show. */
    boolean isKnownHidden(int ray) {
        return sights[ray] == HIDDEN;
    }

    /** Whether the site hides the part of the drone that a ray may show; it must be the ray that was aimed last. */
    byte sight(int ray) {
        if (sights[ray] == UNKNOWN) {
            sights[ray] = find();
        }
        return sights[ray];
    }

    private byte find() {
        Position at = camera.position();
        double start = camera.near() / depth;
        double far = (range + reach) * (1.0 + ROUNDING);
        if (!visibility.findFirstAlong(
                at.x() + start * x, at.y() + start * y, at.z() + start * z, x, y, z, far - start)) {
            return FREE;
        }
        double length = Math.sqrt(x * x + y * y + z * z);
        double nearest = ((range - reach) * (1.0 - ROUNDING) - 2.0 * Visibility.MARGIN) / length;
        return start + visibility.distance() < nearest ? HIDDEN : UNCERTAIN;
    }

    /** The number of pixels that a ray represents if it shows the drone; 0 outside the image. */
    double part(int ray) {
        if (Double.isNaN(parts[ray])) {
            aim(ray);
            parts[ray] = pixels();
        }
        return parts[ray];
    }

    private double pixels() {
        if (depth <= 0.0) {
            return 0.0;
        }
        double right = along(outline.right()) / depth;
        double up = along(outline.up()) / depth;
        double focal = camera.focalLength();
        double fromMiddle = Math.abs(right - outline.middleRight());
        double overMiddle = Math.abs(up - outline.middleUp());
        if (fromMiddle * focal > 0.5 * camera.width() || overMiddle * focal > 0.5 * camera.height()) {
            return 0.0;
        }
        // The solid angle of the ray's cell is divided by that of a pixel there: both shrink with the cube of the
        // length.
        double length = Math.sqrt(x * x + y * y + z * z);
        double solid = cellArea / (length * length * length);
        double oblique = Math.sqrt(1.0 + right * right + up * up);
        return solid * focal * focal * oblique * oblique * oblique;
    }
}
