package org.dronewatch.sensor.optics;

import java.util.function.BooleanSupplier;
import java.util.function.IntPredicate;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.SilhouetteMask;
import org.dronewatch.drone.SilhouetteTable;
import org.dronewatch.geometry.Position;

/**
 * Bounds on the number of pixels that show a level drone at a place, on any heading: the rays of the pixels around it
 * are looked up in masks of its silhouette, and in the image of the site; only those for which neither is certain are
 * traced to the drone, and only on request. Reused for many places; allocates only if it needs more memory than before.
 * One per thread.
 */
public final class PixelBounds {
    /** More pixels around a drone than this are not examined. */
    private static final int MOST_PIXELS = 1 << 14;

    /** Rounding of distances, which are of single precision, and of projections. */
    private static final double ROUNDING = 1e-6;

    /** A camera nearer than this many radii is not examined: the drone would fill its image. */
    private static final double NEAREST = 2.0;

    /** Rays that are traced before the bounds are checked again. */
    private static final int TRACED_AT_ONCE = 6;

    private static final byte HIDDEN = 0;
    private static final byte UNCERTAIN = 1;
    private static final byte FREE = 2;

    private final CameraObject camera;
    private final Position from;
    private final double[] view = new double[3];

    // The pixels around the drone, from the middle row outwards.
    private int[] columns = new int[64];
    private int[] rows = new int[64];
    private int[] texels = new int[64];
    private byte[] sights = new byte[64];
    private int around;

    private SilhouetteTable silhouettes;
    private double range;
    private final SightFrame frame;

    /** The mask of the last count; null for none. */
    private SilhouetteMask mask;

    /** Whether that count ended early. */
    private boolean isCutShort;

    private int least;
    private int most;
    private int leastInTheOpen;
    private int mostInTheOpen;

    PixelBounds(CameraObject camera) {
        this.camera = camera;
        this.from = camera.position();
        this.frame = new SightFrame(camera);
    }

    /**
     * Sets the place of a drone.
     *
     * @param background the site without drones
     * @param at origin of the drone, m
     * @return false where no bounds are known: close to the camera, and at the planes of its projection
     */
    boolean set(Background background, SilhouetteTable table, Position at) {
        silhouettes = table;
        double dx = at.x() - from.x();
        double dy = at.y() - from.y();
        double dz = at.z() - from.z();
        double radius = table.radius() * (1.0 + ROUNDING);
        range = Math.sqrt(dx * dx + dy * dy + dz * dz);
        camera.toView(at.x(), at.y(), at.z(), view, 0);
        around = 0;
        if (!(range > NEAREST * radius)
                || !(view[2] - radius > Math.max(camera.near(), CameraObject.NEAR))
                || !(view[2] + radius < camera.far())) {
            return false;
        }
        frame.set(dx, dy, dz, range);
        return find(background, radius);
    }

    /** Finds the pixels whose rays meet the drone's bounding sphere; false if there are too many. */
    private boolean find(Background background, double radius) {
        double depth = view[2];
        double square = depth * depth - radius * radius;
        double acrossRim = radius * Math.sqrt(view[0] * view[0] + square);
        double aboveRim = radius * Math.sqrt(view[1] * view[1] + square);
        int left = first(camera.column(view[0] * depth - acrossRim, square));
        int right = last(camera.column(view[0] * depth + acrossRim, square), camera.width());
        int upper = first(camera.row(view[1] * depth + aboveRim, square));
        int lower = last(camera.row(view[1] * depth - aboveRim, square), camera.height());
        if (right < left || lower < upper) {
            return true;
        }
        if ((long) (right - left + 1) * (lower - upper + 1) > MOST_PIXELS) {
            return false;
        }
        reserve((right - left + 1) * (lower - upper + 1));
        int middle = (upper + lower) / 2;
        for (int away = 0; away <= lower - middle; away++) {
            findRow(background, radius, left, right, middle + away);
            if (away > 0 && middle - away >= upper) {
                findRow(background, radius, left, right, middle - away);
            }
        }
        return true;
    }

    private static int first(double edge) {
        return (int) Math.max(0.0, Math.min(Integer.MAX_VALUE / 2, Math.ceil(edge - 0.5 - ROUNDING)));
    }

    private static int last(double edge, int pixels) {
        return (int) Math.max(-1.0, Math.min(pixels - 1.0, Math.floor(edge - 0.5 + ROUNDING)));
    }

    private void reserve(int pixels) {
        if (texels.length < pixels) {
            columns = new int[2 * pixels];
            rows = new int[2 * pixels];
            texels = new int[2 * pixels];
            sights = new byte[2 * pixels];
        }
    }

    private void findRow(Background background, double radius, int left, int right, int row) {
        double half = silhouettes.halfWidth();
        double scale = 0.5 * SilhouetteMask.TEXELS / half;
        double near = (range - radius) * (1.0 - ROUNDING);
        double far = (range + radius) * (1.0 + ROUNDING);
        // A ray that touches the sphere passes the plane through its centre a little farther out.
        double limit = radius * radius * range * range / (range * range - radius * radius) * (1.0 + ROUNDING);
        frame.beginRow(left, row);
        for (int column = left; column <= right; column++) {
            frame.setColumn(column - left);
            double across = frame.across();
            double above = frame.above();
            if (frame.isAhead() && across * across + above * above <= limit) {
                float distance = background.distance(column, row);
                columns[around] = column;
                rows[around] = row;
                texels[around] = texel(across, half, scale) + SilhouetteMask.TEXELS * texel(above, half, scale);
                sights[around++] = distance < near ? HIDDEN : distance > far ? FREE : UNCERTAIN;
            }
        }
    }

    private static int texel(double coordinate, double half, double scale) {
        return Math.max(0, Math.min(SilhouetteMask.TEXELS - 1, (int) ((coordinate + half) * scale)));
    }

    /** Whether the site certainly hides the drone, however it turns, or it is between the rays of the pixels. */
    public boolean isInvisible() {
        for (int i = 0; i < around; i++) {
            if (sights[i] != HIDDEN) {
                return false;
            }
        }
        return true;
    }

    /**
     * Counts the pixels of the drone on a heading.
     *
     * @param heading of its nose, clockwise from north, rad
     * @param enough whether a number of pixels is sufficient; if it is, every larger number must be as well. Counting
     *     stops there, and the upper bounds are higher
     */
    public void count(double heading, IntPredicate enough) {
        least = 0;
        leastInTheOpen = 0;
        isCutShort = false;
        mask = range >= silhouettes.minRange() ? silhouettes.mask(frame.azimuth() - heading, frame.elevation()) : null;
        if (mask == null) {
            countAround();
            return;
        }
        most = 0;
        mostInTheOpen = 0;
        int asked = 1;
        for (int i = 0; i < around; i++) {
            byte kind = mask.kind(texels[i]);
            if (kind != SilhouetteMask.OUTSIDE) {
                byte sight = sights[i];
                boolean isInside = kind == SilhouetteMask.INSIDE;
                mostInTheOpen++;
                leastInTheOpen += isInside ? 1 : 0;
                most += sight == HIDDEN ? 0 : 1;
                least += isInside && sight == FREE ? 1 : 0;
                if (least >= asked) {
                    if (enough.test(least)) {
                        isCutShort = true;
                        countAround();
                        return;
                    }
                    asked = 2 * least;
                }
            }
        }
    }

    /**
     * Traces pixels about which the last count left a doubt, until the bounds suffice or are exact.
     *
     * @param isSufficient whether the bounds suffice as they are
     * @return false where a picture of the drone is drawn faster
     */
    boolean refine(Background background, DynamicView drawing, Drone drone, BooleanSupplier isSufficient) {
        if (isCutShort || !drawing.beginSingly(drone)) {
            return false;
        }
        int traced = 0;
        for (int i = 0; i < around; i++) {
            byte kind = mask == null ? SilhouetteMask.UNCERTAIN : mask.kind(texels[i]);
            boolean isInside = kind == SilhouetteMask.INSIDE;
            if (kind == SilhouetteMask.UNCERTAIN || isInside && sights[i] == UNCERTAIN) {
                float distance = drawing.distanceSingly(columns[i], rows[i]);
                boolean isHit = distance < Float.POSITIVE_INFINITY;
                boolean isSeen = isHit && distance < background.distance(columns[i], rows[i]);
                leastInTheOpen += isHit && !isInside ? 1 : 0;
                mostInTheOpen -= isHit ? 0 : 1;
                least += isSeen ? 1 : 0;
                most -= isSeen || sights[i] == HIDDEN ? 0 : 1;
                traced++;
                if (traced % TRACED_AT_ONCE == 0 && isSufficient.getAsBoolean()) {
                    return true;
                }
            }
        }
        return true;
    }

    /** The upper bounds are the numbers of pixels that meet the sphere. */
    private void countAround() {
        most = 0;
        for (int i = 0; i < around; i++) {
            most += sights[i] == HIDDEN ? 0 : 1;
        }
        mostInTheOpen = around;
    }

    /** At least this many pixels show the drone. */
    public int least() {
        return least;
    }

    /** At most this many pixels show it. */
    public int most() {
        return most;
    }

    /** At least this many would show it if nothing hid it. */
    public int leastInTheOpen() {
        return leastInTheOpen;
    }

    /** At most this many would show it if nothing hid it. */
    public int mostInTheOpen() {
        return mostInTheOpen;
    }
}
