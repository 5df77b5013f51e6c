package org.dronewatch.drone.silhouette;

import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.stream.Stream;
import org.dronewatch.geometry.TriangleMesh;

/**
 * The silhouettes of a level drone from all directions, as {@linkplain SilhouetteMask masks}: each mask belongs to a
 * viewing direction, and holds for all directions within a few degrees of it and from every distance of at least
 * {@link #minRange()}. A mask is made only once it has been requested several times, or for one large picture, since
 * rendering a few small pictures costs less than a mask. Thread-safe.
 */
public final class SilhouetteTable {
    private static final int AZIMUTHS = 120;
    private static final int ELEVATIONS = 60;
    private static final double AZIMUTH_STEP = 2.0 * Math.PI / AZIMUTHS;
    private static final double ELEVATION_STEP = Math.PI / ELEVATIONS;

    /** Drawing a mask takes about as long as this number of small pictures. */
    private static final int SMALL_PICTURES = 4;

    /** Number of pixels of a small picture. */
    private static final int FEW_PIXELS = 256;

    private final SilhouetteRaster raster;
    private final AtomicReferenceArray<SilhouetteMask> masks = new AtomicReferenceArray<>(AZIMUTHS * ELEVATIONS);
    private final Object[] locks = Stream.generate(Object::new).limit(AZIMUTHS).toArray();
    private final AtomicIntegerArray requests = new AtomicIntegerArray(AZIMUTHS * ELEVATIONS);

    /** The silhouettes of a mesh in model space: x to the right, y ahead, z up, m. */
    public SilhouetteTable(TriangleMesh mesh) {
        this.raster = new SilhouetteRaster(mesh);
    }

    /** The largest distance of the mesh from its origin, m. */
    public double radius() {
        return raster.radius();
    }

    /** Half the side length of a mask, m. */
    public double halfWidth() {
        return raster.halfWidth();
    }

    /** The minimum distance of the camera from the drone's origin for which the masks hold, m. */
    public double minRange() {
        return raster.minRange();
    }

    /**
     * The mask for a direction.
     *
     * @param azimuth azimuth of the line of sight, from the camera to the drone, relative to the drone's nose,
     *     clockwise, rad
     * @param elevation elevation of the line of sight above the horizon, -pi/2 to pi/2, rad
     * @param pixels number of pixels of the picture whose rendering the mask may replace
     * @return the mask; null until this direction has been requested several times, or once for a large picture
     */
    public SilhouetteMask mask(double azimuth, double elevation, int pixels) {
        int column = Math.floorMod((int) Math.floor(azimuth / AZIMUTH_STEP), AZIMUTHS);
        int row = (int)
                Math.max(0.0, Math.min(ELEVATIONS - 1.0, Math.floor((elevation + 0.5 * Math.PI) / ELEVATION_STEP)));
        int index = row * AZIMUTHS + column;
        SilhouetteMask mask = masks.get(index);
        return mask == null && requests.addAndGet(index, 1 + pixels / FEW_PIXELS) >= SMALL_PICTURES
                ? make(column, row)
                : mask;
    }

    /**
     * The mask of a range of directions, drawn if necessary. Neighbouring cells of a field need the same mask at the
     * same time: one thread draws it, and the others wait.
     */
    private SilhouetteMask make(int column, int row) {
        int index = row * AZIMUTHS + column;
        synchronized (locks[index % locks.length]) {
            if (masks.get(index) == null) {
                masks.set(
                        index,
                        raster.mask(
                                (column + 0.5) * AZIMUTH_STEP,
                                (row + 0.5) * ELEVATION_STEP - 0.5 * Math.PI,
                                0.5 * AZIMUTH_STEP,
                                0.5 * ELEVATION_STEP));
            }
            return masks.get(index);
        }
    }
}
