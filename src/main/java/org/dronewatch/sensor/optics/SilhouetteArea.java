package org.dronewatch.sensor.optics;

import org.dronewatch.drone.Drone;
import org.dronewatch.drone.SilhouetteMask;
import org.dronewatch.drone.SilhouetteTable;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.jogamp.vecmath.Matrix4d;

/**
 * Bounds on the {@link VisibleArea} of a level drone if nothing hides it: the rays of its bundle are looked up in a
 * mask of its silhouette instead of being traced. Not thread-safe.
 */
public final class SilhouetteArea {
    /** Rounding of sums, and of distances. */
    private static final double ROUNDING = 1e-9;

    /** Up to this sine of the elevation, the bundle's frame is that of the masks. */
    private static final double STEEPEST = 0.9;

    /** A mask saves several pictures of about this number of pixels: see {@link SilhouetteTable#mask}. */
    private static final int PIXELS_SAVED = 512;

    private final CameraObject camera;
    private final VisibleArea area;
    private final byte[] kinds = new byte[RayBundle.RAYS];
    private final Matrix4d model = new Matrix4d();
    private final Matrix4d asked = new Matrix4d();
    private boolean isKnown;
    private double least;
    private double most;

    /** Bounds on the areas in an image. */
    public SilhouetteArea(VisibleArea area) {
        this.area = area;
        this.camera = area.camera();
    }

    /**
     * Bounds the area of a drone.
     *
     * @param drone the drone, in that state
     * @param state state of flight of the drone, which is level
     * @return false where no bounds are known: close to the camera, far above or below it, not entirely between the
     *     near and far planes, and until a mask is worthwhile
     */
    public boolean bound(Drone drone, FlightState state) {
        isKnown = false;
        Position at = state.position();
        Position vector = at.minus(camera.position());
        double range = vector.length();
        double reach = drone.reach();
        SilhouetteTable table = drone.silhouettes();
        double depth = vector.dot(camera.outline().forward());
        if (!(range > table.minRange())
                || !(Math.abs(vector.z()) < STEEPEST * range)
                || !(depth - reach > Math.max(camera.near(), CameraObject.NEAR))
                || !(depth + reach < camera.far())) {
            return false;
        }
        double level = Math.sqrt(vector.x() * vector.x() + vector.y() * vector.y());
        SilhouetteMask mask = table.mask(
                Math.atan2(vector.x(), vector.y()) - state.heading(), Math.atan2(vector.z(), level), PIXELS_SAVED);
        if (mask == null) {
            return false;
        }
        least = 0.0;
        most = 0.0;
        RayBundle bundle = area.bundle();
        bundle.set(vector, range, reach);
        double texelsPerUnit = 0.5 * SilhouetteMask.TEXELS / table.halfWidth();
        double scale = bundle.half() * range * texelsPerUnit;
        double middle = table.halfWidth() * texelsPerUnit;
        for (int i = 0; i < RayBundle.RAYS; i++) {
            int column = (int) Math.floor(RayBundle.across(i) * scale + middle);
            int row = (int) Math.floor(RayBundle.upwards(i) * scale + middle);
            kinds[i] = SilhouetteMask.OUTSIDE;
            if (((column | row) & -SilhouetteMask.TEXELS) == 0) {
                byte kind = mask.kind(column + SilhouetteMask.TEXELS * row);
                kinds[i] = kind;
                if (kind != SilhouetteMask.OUTSIDE) {
                    double part = bundle.part(i);
                    most += part;
                    least += kind == SilhouetteMask.INSIDE ? part : 0.0;
                }
            }
        }
        least *= 1.0 - ROUNDING;
        most *= 1.0 + ROUNDING;
        drone.modelMatrix(model);
        isKnown = true;
        return true;
    }

    /** Whether the bounds are those of a drone in its present pose. */
    public boolean isOf(Drone drone) {
        drone.modelMatrix(asked);
        return isKnown && model.equals(asked);
    }

    /** What the mask states about a ray of the bundle: {@link SilhouetteMask#kind}. */
    byte kind(int ray) {
        return kinds[ray];
    }

    /** A lower bound on the area in the image, pixels. */
    public double least() {
        return least;
    }

    /** An upper bound on the area in the image, pixels. */
    public double most() {
        return most;
    }
}
