package org.dronewatch.sensor.optics;

import java.util.function.BooleanSupplier;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.silhouette.SilhouetteMask;
import org.dronewatch.drone.silhouette.SilhouetteTable;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.RayTracer;
import org.jogamp.vecmath.Matrix4d;

/**
 * Bounds on the {@link VisibleArea} of a level drone if nothing hides it: the rays that sample the drone are looked up
 * in a mask of its silhouette instead of being traced. Not thread-safe.
 */
public final class SilhouetteArea {
    /** Tolerance for the rounding of sums and of distances. */
    private static final double ROUNDING = 1e-9;

    /** Up to this sine of the elevation, the bundle's frame is that of the masks. */
    private static final double STEEPEST = 0.9;

    /** A mask makes several pictures of about this number of pixels unnecessary: see {@link SilhouetteTable#mask}. */
    private static final int PIXELS_SAVED = 512;

    /** Number of rays whose tracing takes about as long as checking whether the bounds are decisive. */
    private static final int RAYS_AT_A_TIME = 8;

    private final CameraObject camera;
    private final VisibleArea area;
    private final byte[] kinds = new byte[RayBundle.RAYS];
    private final BundleTexels rays = new BundleTexels();
    private final Matrix4d model = new Matrix4d();
    private final Matrix4d asked = new Matrix4d();
    private boolean isKnown;
    private double least;
    private double likely;
    private double most;

    /** Bounds on the areas in an image. */
    public SilhouetteArea(VisibleArea area) {
        this.area = area;
        this.camera = area.camera();
    }

    /**
     * Bounds the area of a drone.
     *
     * @param drone the drone, in the given state
     * @param state state of flight of the drone, which is level
     * @return false where no bounds are known: close to the camera, far above or below it, not entirely between the
     *     near and far planes, and until a mask is worthwhile
     */
    public boolean bound(Drone drone, FlightState state) {
        isKnown = false;
        Position at = state.position();
        Position vector = at.minus(camera.position());
        double range = vector.length();
        double radius = drone.radius();
        SilhouetteTable table = drone.silhouettes();
        double depth = vector.dot(camera.outline().forward());
        if (!(range > table.minRange())
                || !(Math.abs(vector.z()) < STEEPEST * range)
                || !(depth - radius > Math.max(camera.near(), CameraObject.NEAR))
                || !(depth + radius < camera.far())) {
            return false;
        }
        double level = Math.sqrt(vector.x() * vector.x() + vector.y() * vector.y());
        SilhouetteMask mask = table.mask(
                Math.atan2(vector.x(), vector.y()) - state.heading(), Math.atan2(vector.z(), level), PIXELS_SAVED);
        if (mask == null) {
            return false;
        }
        least = 0.0;
        likely = 0.0;
        most = 0.0;
        RayBundle bundle = area.bundle();
        bundle.set(vector, range, radius);
        double texelsPerUnit = 0.5 * SilhouetteMask.TEXELS / table.halfWidth();
        rays.look(mask, bundle.half() * range * texelsPerUnit, radius * texelsPerUnit, kinds);
        for (int i = 0; i < RayBundle.RAYS; i++) {
            byte kind = kinds[i];
            if (kind != SilhouetteMask.OUTSIDE) {
                double part = bundle.part(i);
                most += part;
                likely += kind != SilhouetteMask.UNLIKELY ? part : 0.0;
                least += kind == SilhouetteMask.INSIDE ? part : 0.0;
            }
        }
        least *= 1.0 - ROUNDING;
        most *= 1.0 + ROUNDING;
        drone.modelMatrix(model);
        isKnown = true;
        return true;
    }

    /**
     * Narrows the bounds until they are decisive, for a drone that nothing hides: traces rays that the mask leaves in
     * doubt. In the end, the bounds are equal apart from rounding.
     *
     * @param drone the drone that was bounded last
     * @param isLarge whether the decision is expected to be the one for a large area: rays that raise the lower bound
     *     are then traced first, otherwise those that lower the upper one
     * @param isDecisive whether the bounds as they are now suffice; if they do, narrower ones must as well
     * @return whether they are decisive
     */
    public boolean narrow(Drone drone, boolean isLarge, BooleanSupplier isDecisive) {
        RayTracer model = area.tracer(drone);
        byte first = isLarge ? SilhouetteMask.LIKELY : SilhouetteMask.UNLIKELY;
        byte second = isLarge ? SilhouetteMask.UNLIKELY : SilhouetteMask.LIKELY;
        return narrow(model, first, isDecisive) || narrow(model, second, isDecisive) || isDecisive.getAsBoolean();
    }

    private boolean narrow(RayTracer model, byte kind, BooleanSupplier isDecisive) {
        int traced = 0;
        for (int number = 0; number < RayBundle.RAYS; number++) {
            int ray = VisibleArea.inOrder(number);
            double part = kinds[ray] == kind ? area.bundle().part(ray) * (1.0 - ROUNDING) : 0.0;
            if (part == 0.0) {
                continue;
            }
            if (area.meets(model, ray)) {
                least += part;
            } else {
                most -= part;
            }
            traced++;
            if (traced % RAYS_AT_A_TIME == 0 && isDecisive.getAsBoolean()) {
                return true;
            }
        }
        return false;
    }

    /** Whether the bounds are those of a drone in its present pose. */
    public boolean isOf(Drone drone) {
        drone.modelMatrix(asked);
        return isKnown && model.equals(asked);
    }

    /** The kind of the texel at which a ray of the bundle meets the mask: {@link SilhouetteMask#kind}. */
    byte kind(int ray) {
        return kinds[ray];
    }

    /** A lower bound on the area in the image, pixels. */
    public double least() {
        return least;
    }

    /** The best estimate of the area in the image from the mask alone, between the two bounds, pixels. */
    public double likely() {
        return likely;
    }

    /** An upper bound on the area in the image, pixels. */
    public double most() {
        return most;
    }

    /**
     * The texels at which the rays of a {@link RayBundle} meet the masks of a drone's silhouette. From afar, the rays
     * meet all masks of a drone at the same texels, whose kinds each mask keeps; from nearer, a few rays meet a
     * neighbouring texel instead. Not thread-safe.
     */
    static final class BundleTexels {
        private static final int BEYOND = -1;

        private final int[] moved = new int[RayBundle.RAYS];
        private final int[] movedTexels = new int[RayBundle.RAYS];
        private int count;
        private double scale = Double.NaN;

        // The texels as seen from infinitely far away. Another size requires a new array, since masks keep the last
        // one.
        private int[] far = new int[0];
        private double farScale = Double.NaN;

        /**
         * Looks up all rays in a mask.
         *
         * @param half half the side of the bundle's square, in the plane of the mask, texels
         * @param halfFromAfar the same from infinitely far away, texels
         * @param kinds receives the kind for each ray, {@link SilhouetteMask#OUTSIDE} outside the mask
         */
        void look(SilhouetteMask mask, double half, double halfFromAfar, byte[] kinds) {
            set(half, halfFromAfar);
            mask.copyKinds(far, kinds);
            for (int i = 0; i < count; i++) {
                int texel = movedTexels[i];
                kinds[moved[i]] = texel == BEYOND ? SilhouetteMask.OUTSIDE : mask.kind(texel);
            }
        }

        private void set(double half, double halfFromAfar) {
            if (half == scale && halfFromAfar == farScale) {
                return;
            }
            if (halfFromAfar != farScale) {
                farScale = halfFromAfar;
                far = new int[RayBundle.RAYS];
                for (int ray = 0; ray < RayBundle.RAYS; ray++) {
                    far[ray] = texel(ray, halfFromAfar);
                }
            }
            scale = half;
            count = 0;
            for (int ray = 0; ray < RayBundle.RAYS; ray++) {
                int texel = texel(ray, half);
                if (texel != far[ray]) {
                    moved[count] = ray;
                    movedTexels[count] = texel;
                    count++;
                }
            }
        }

        private static int texel(int ray, double half) {
            double middle = 0.5 * SilhouetteMask.TEXELS;
            int column = (int) Math.floor(RayBundle.across(ray) * half + middle);
            int row = (int) Math.floor(RayBundle.upwards(ray) * half + middle);
            return ((column | row) & -SilhouetteMask.TEXELS) == 0 ? column + SilhouetteMask.TEXELS * row : BEYOND;
        }
    }
}
