package org.dronewatch.sensor.acoustic.imagesource;

import java.util.Arrays;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.World;

/**
 * The fraction of sound that the walls on a path of specular reflections transmit and reflect: each leg passes through
 * walls like direct sound, and solids that the path has entered before a reflection are left after it. At a reflection,
 * the path is followed a little in front of the wall, across its corners: anything that stands on the wall there is
 * crossed once, no matter on which side of the reflection rounding has put it. For use by one thread.
 */
final class LegsThroughWalls {
    private static final int BANDS = OctaveBands.COUNT;

    /** The distance in front of walls at which the path is followed, as a multiple of the planes' tolerance. */
    private static final double BEFORE = 3.0;

    /** The largest fraction of a leg that is cut off at either end. */
    private static final double MOST = 0.4;

    private final World world;
    private final WallPlanes planes;
    private final BandSurfaces surfaces;
    private final WallTransmission walls;
    private final CrossedFaces faces;
    private final double[] left = new double[BANDS];
    private final double[] mirrored = new double[BANDS];
    private double x;
    private double y;
    private double z;

    /** The wall that first reflects the path in the corner before the current leg, or NONE. */
    private int corner;

    LegsThroughWalls(World world, WallPlanes planes, BandSurfaces surfaces) {
        this.world = world;
        this.planes = planes;
        this.surfaces = surfaces;
        this.walls = new WallTransmission(world, planes, surfaces);
        this.faces = new CrossedFaces(world, surfaces);
    }

    /** Begins a path at a point, m. */
    void begin(double fromX, double fromY, double fromZ) {
        x = fromX;
        y = fromY;
        z = fromZ;
        corner = WallPlanes.NONE;
        walls.begin(EnteredSolids.NONE);
    }

    /**
     * Follows a leg of the path.
     *
     * @param fromX x coordinate of its beginning, m
     * @param dx x component of the vector along it to its end, m
     * @param curvature curvature of sound along it, 1/m
     * @param from the wall on which it begins, or {@link WallPlanes#NONE}
     * @param to the wall on which it ends, or NONE
     * @return whether any of the sound arrives
     */
    boolean goOn(
            double fromX,
            double fromY,
            double fromZ,
            double dx,
            double dy,
            double dz,
            double curvature,
            int from,
            int to) {
        if (from != WallPlanes.NONE) {
            double on = part(planes.height(from, fromX + dx, fromY + dy, fromZ + dz));
            if (!moveTo(fromX + on * dx, fromY + on * dy, fromZ + on * dz, 0.0, corner, from)) {
                return false;
            }
        }
        corner = to;
        double end = to == WallPlanes.NONE ? 1.0 : 1.0 - part(planes.height(to, fromX, fromY, fromZ));
        return moveTo(fromX + end * dx, fromY + end * dy, fromZ + end * dz, curvature, from, to);
    }

    /** The fraction of a leg that lies near the wall at one end. */
    private double part(double heightOfOtherEnd) {
        return Math.min(MOST, BEFORE * planes.tolerance() / Math.abs(heightOfOtherEnd));
    }

    private boolean moveTo(double toX, double toY, double toZ, double curvature, int one, int other) {
        boolean passes = walls.goOn(x, y, z, toX, toY, toZ, curvature, one, other);
        x = toX;
        y = toY;
        z = toZ;
        return passes;
    }

    /**
     * Reflects the path, as far as it has been followed, specularly at the faces at a point: if several faces coincide,
     * each of them reflects the sound that those before it transmit. A solid that the path is inside does not reflect
     * it back.
     *
     * @param triangle the first of the faces
     * @param atX x coordinate of the point, m
     * @param alongX x component of the direction of the path
     * @param cosine cosine of the angle between the path and the normal
     * @return whether anything is reflected
     */
    boolean reflect(
            int triangle,
            double atX,
            double atY,
            double atZ,
            double alongX,
            double alongY,
            double alongZ,
            double cosine) {
        int first = world.material(triangle, atX, atY);
        if (!surfaces.transmits(first)) {
            for (int band = 0; band < BANDS; band++) {
                mirrored[band] = surfaces.mirrored(first, band, cosine);
            }
            return true;
        }
        faces.find(triangle, first, atX, atY, atZ, alongX, alongY, alongZ);
        Arrays.fill(left, 1.0);
        Arrays.fill(mirrored, 0.0);
        boolean isAny = false;
        for (int i = 0; i < faces.count(); i++) {
            if (faces.begins(i, walls.within())) {
                int material = faces.material(i);
                isAny = true;
                for (int band = 0; band < BANDS; band++) {
                    mirrored[band] += left[band] * surfaces.mirrored(material, band, cosine);
                    left[band] *= surfaces.transmitted(material, band);
                }
            }
        }
        return isAny;
    }

    /** The fraction of a band's energy that the faces at the last point of reflection reflect specularly. */
    double mirrored(int band) {
        return mirrored[band];
    }

    /** The fraction of a band's energy that walls have transmitted so far. */
    double passed(int band) {
        return walls.passed(band);
    }
}
