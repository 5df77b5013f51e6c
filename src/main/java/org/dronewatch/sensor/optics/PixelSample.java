package org.dronewatch.sensor.optics;

import java.util.Arrays;
import org.dronewatch.drone.silhouette.SilhouetteMask;
import org.dronewatch.drone.silhouette.SilhouetteTable;
import org.dronewatch.geometry.Position;

/**
 * The pixels around a drone at a position, or a sample of them: which pixels' rays meet the drone's bounding sphere,
 * where these rays pass the drone, and whether the site hides it from them. Reused for many positions; allocates only
 * if it needs more memory than before. For use by one thread.
 */
final class PixelSample {
    static final byte HIDDEN = 1;
    static final byte UNCERTAIN = 2;
    static final byte FREE = 3;

    /** {@link SilhouetteMask#INSIDE} and {@link #FREE} have all bits below this set, and are the greatest values. */
    private static final int INSIDE_BIT = 2;

    /** If there are more pixels around a drone than this, only those of every n-th row and column are examined. */
    private static final int MOST_PIXELS = 1 << 12;

    /** As {@link #MOST_PIXELS}, but after a sample that was not sufficient. */
    private static final int MOST_PIXELS_ON_REQUEST = 1 << 20;

    /**
     * If there are even more, only about this number of pixels, in the middle rows, are examined: a drone that is so
     * near shows its body there.
     */
    private static final int MIDDLE_PIXELS = 1 << 17;

    /** Tolerance for the rounding of distances, which are of single precision, and of projections. */
    private static final double ROUNDING = 1e-6;

    /** The pixels of a camera nearer than this number of radii are not examined: the drone would fill its image. */
    private static final double NEAREST = 2.0;

    private final CameraObject camera;
    private final Position from;
    private final SightFrame frame;
    private final double[] view = new double[3];
    private final PixelRectangle rectangle = new PixelRectangle();

    // The pixels around the drone, from the middle row outwards.
    private int[] columns = new int[64];
    private int[] rows = new int[64];
    private int[] texels = new int[64];
    private byte[] sights = new byte[64];
    private int around;

    /** The pixels of every n-th row and column are examined. */
    private int stride;

    /** The number of pixels of which these are a sample, or an upper bound on it. */
    private int sampled;

    /** The middle row of the rectangle around the drone, and the distance from it of the next rows to be examined. */
    private int middle;

    private int away;

    private Background background;
    private SilhouetteTable silhouettes;
    private double range;

    PixelSample(CameraObject camera) {
        this.camera = camera;
        this.from = camera.position();
        this.frame = new SightFrame(camera);
    }

    /**
     * Sets the position of a drone.
     *
     * @param site the site without drones
     * @param at origin of the drone, m
     * @return false where no bounds are known: close to the camera, and at the near and far planes
     */
    boolean set(Background site, SilhouetteTable table, Position at) {
        background = site;
        silhouettes = table;
        double dx = at.x() - from.x();
        double dy = at.y() - from.y();
        double dz = at.z() - from.z();
        double radius = table.radius() * (1.0 + ROUNDING);
        range = Math.sqrt(dx * dx + dy * dy + dz * dz);
        camera.toView(at.x(), at.y(), at.z(), view, 0);
        around = 0;
        stride = 1;
        sampled = 0;
        if (!(range > NEAREST * radius)
                || !(view[2] - radius > Math.max(camera.near(), CameraObject.NEAR))
                || !(view[2] + radius < camera.far())) {
            return false;
        }
        frame.set(dx, dy, dz, range);
        if (!begin(radius, MOST_PIXELS)) {
            return false;
        }
        while (stride == 1 && hasMoreRows()) {
            findRows();
        }
        return true;
    }

    /** Begins to find pixels whose rays meet the drone's bounding sphere; false if there are too many. */
    private boolean begin(double radius, int mostPixels) {
        double depth = view[2];
        double square = depth * depth - radius * radius;
        double acrossRim = radius * Math.sqrt(view[0] * view[0] + square);
        double aboveRim = radius * Math.sqrt(view[1] * view[1] + square);
        int left = first(camera.column(view[0] * depth - acrossRim, square));
        int right = last(camera.column(view[0] * depth + acrossRim, square), camera.width());
        int upper = first(camera.row(view[1] * depth + aboveRim, square));
        int lower = last(camera.row(view[1] * depth - aboveRim, square), camera.height());
        rectangle.set(left, upper, right, lower);
        middle = (upper + lower) / 2;
        away = 0;
        if (rectangle.isEmpty()) {
            return true;
        }
        long pixels = (long) (right - left + 1) * (lower - upper + 1);
        stride = (int) Math.ceil(Math.sqrt((double) pixels / mostPixels));
        sampled = (int) Math.min(Integer.MAX_VALUE, pixels);
        return stride == 1 || range >= silhouettes.minRange();
    }

    private boolean hasMoreRows() {
        return !rectangle.isEmpty()
                && away <= rectangle.bottom() - middle
                && (sampled <= MOST_PIXELS_ON_REQUEST || around < MIDDLE_PIXELS);
    }

    /** Examines the next rows, above and below the middle one. */
    private void findRows() {
        findRow(middle + away);
        if (away > 0 && middle - away >= rectangle.top()) {
            findRow(middle - away);
        }
        away += stride;
    }

    /**
     * Whether there is another pixel around the drone. Rows that are not needed are not examined.
     *
     * @param pixel number of pixels before it
     */
    boolean has(int pixel) {
        while (pixel >= around && hasMoreRows()) {
            findRows();
        }
        return pixel < around;
    }

    /**
     * From now on, all pixels around the drone are examined, if only a sample has been; if there are too many, all of
     * the middle rows.
     *
     * @return false if that has been done before
     */
    boolean examineAll() {
        if (stride == 1) {
            return false;
        }
        around = 0;
        return begin(silhouettes.radius() * (1.0 + ROUNDING), Integer.MAX_VALUE);
    }

    private static int first(double edge) {
        return (int) Math.max(0.0, Math.min(Integer.MAX_VALUE / 2, Math.ceil(edge - 0.5 - ROUNDING)));
    }

    private static int last(double edge, int pixels) {
        return (int) Math.max(-1.0, Math.min(pixels - 1.0, Math.floor(edge - 0.5 + ROUNDING)));
    }

    /** Makes room for more pixels, but not for all of them, since the first rows are often sufficient. */
    private void reserve(int pixels) {
        if (texels.length < pixels) {
            columns = Arrays.copyOf(columns, 2 * pixels);
            rows = Arrays.copyOf(rows, 2 * pixels);
            texels = Arrays.copyOf(texels, 2 * pixels);
            sights = Arrays.copyOf(sights, 2 * pixels);
        }
    }

    private void findRow(int row) {
        double radius = silhouettes.radius() * (1.0 + ROUNDING);
        int left = rectangle.left();
        reserve(around + (rectangle.right() - left) / stride + 1);
        double half = silhouettes.halfWidth();
        double scale = 0.5 * SilhouetteMask.TEXELS / half;
        // A ray that touches the sphere passes the plane through its centre a little farther out.
        double limit = radius * radius * range * range / (range * range - radius * radius) * (1.0 + ROUNDING);
        frame.beginRow(left, row);
        for (int column = left; column <= rectangle.right(); column += stride) {
            frame.setColumn(column - left);
            double across = frame.across();
            double above = frame.above();
            if (frame.isAhead() && across * across + above * above <= limit) {
                columns[around] = column;
                rows[around] = row;
                texels[around] = texel(across, half, scale) + SilhouetteMask.TEXELS * texel(above, half, scale);
                sights[around++] = sight(background.distance(column, row), radius);
            }
        }
    }

    private byte sight(float distance, double radius) {
        if (distance < (range - radius) * (1.0 - ROUNDING)) {
            return HIDDEN;
        }
        return distance > (range + radius) * (1.0 + ROUNDING) ? FREE : UNCERTAIN;
    }

    /** Whether the site hides all of the drone that a pixel may show, or none of it, or neither is certain. */
    byte sight(int pixel) {
        return sights[pixel];
    }

    /** The number of pixels around the drone that have been examined so far. */
    int examined() {
        return around;
    }

    /**
     * The number of pixels that certainly show the drone among those from the first up to, but not including, the last.
     */
    int countCertain(SilhouetteMask mask, int first, int last) {
        int count = 0;
        for (int i = first; i < last; i++) {
            // Without branches, since this loop takes most of the time of a field. If the pixel counts, both values
            // have all bits set; otherwise, a bit is missing.
            count += (mask.kind(texels[i]) & sights[i]) + 1 >> INSIDE_BIT;
        }
        return count;
    }

    private static int texel(double coordinate, double half, double scale) {
        return Math.max(0, Math.min(SilhouetteMask.TEXELS - 1, (int) ((coordinate + half) * scale)));
    }

    /**
     * Whether it is certain that the site hides the drone, however it turns, or that the drone lies between the rays of
     * the pixels.
     */
    boolean isInvisible() {
        for (int i = 0; has(i); i++) {
            if (sight(i) != HIDDEN) {
                return false;
            }
        }
        return isComplete()
                || rectangle.isHidden(background, (range - silhouettes.radius() * (1.0 + ROUNDING)) * (1.0 - ROUNDING));
    }

    /** An upper bound on the number of pixels that show the drone, however it turns. */
    int mostAround() {
        return isComplete() && !hasMoreRows() ? around : sampled;
    }

    /** The number of pixels in the rectangle around the drone: no others can show it. */
    int mostInRectangle() {
        return sampled;
    }

    /** Whether all pixels around the drone are examined, not only a sample of them or some rows. */
    boolean isComplete() {
        return stride == 1 && sampled <= MOST_PIXELS_ON_REQUEST;
    }

    int column(int pixel) {
        return columns[pixel];
    }

    int row(int pixel) {
        return rows[pixel];
    }

    /** The distance of the site along the ray of a pixel, m. */
    float siteDistance(int pixel) {
        return background.distance(columns[pixel], rows[pixel]);
    }

    /** The kind of the texel at which the ray of a pixel meets a mask. */
    byte kind(SilhouetteMask mask, int pixel) {
        return mask.kind(texels[pixel]);
    }

    /** The mask of the drone on a heading, clockwise from north, rad; null for none. */
    SilhouetteMask mask(double heading) {
        return range >= silhouettes.minRange()
                ? silhouettes.mask(frame.azimuth() - heading, frame.elevation(), mostAround())
                : null;
    }
}
