package org.dronewatch.sensor.acoustic.imagesource;

import java.util.Arrays;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sensor.acoustic.propagation.PathCurvature;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.World;

/**
 * A path from one point via specular reflections to another, constructed from image sources: it must hit every wall at
 * the right point, unobstructed (Allen and Berkley, JASA 65, 1979; Borish, JASA 75, 1984, for rooms of any shape). The
 * path may pass through walls that transmit sound if {@link #throughWalls} allows it. For use by one thread.
 */
public final class SpecularPath {
    private static final int BANDS = OctaveBands.COUNT;

    private final WallPlanes planes;
    private final double[] reflected = new double[BANDS];
    private final FreeLegs free;
    private final LegsThroughWalls legs;
    private final Corners corners;
    private final boolean anyTransmits;
    private PathCurvature curvature = PathCurvature.NONE;

    /** Whether paths through walls count. */
    private boolean mayPassThrough;

    /** Whether the path is followed through walls. */
    private boolean isThrough;

    private double ahead;
    private double length;
    /** The beginning of the previous leg. */
    private final double[] before = new double[3];

    private final MetWalls metHere = new MetWalls();
    private final double[] metFirst = new double[3];
    private final double[] first = new double[3];
    private final double[] last = new double[3];

    /** A search for paths in a world; none has been found yet. */
    public SpecularPath(World world, WallPlanes planes, BandSurfaces surfaces) {
        this.planes = planes;
        this.free = new FreeLegs(world, planes, surfaces);
        this.corners = free.corners();
        this.anyTransmits = surfaces.anyTransmits();
        this.legs = new LegsThroughWalls(world, planes, surfaces);
    }

    /**
     * Sets whether subsequent paths may also pass through walls that transmit sound, attenuated like direct sound. By
     * default, they may not.
     */
    public void throughWalls(boolean isAllowed) {
        mayPassThrough = isAllowed && anyTransmits;
    }

    /**
     * Sets the curvature that the air gives to subsequent paths: each leg must be unobstructed as an arc, too. By
     * default, paths are straight.
     *
     * @param isSoundAhead whether sound travels from a path's beginning to its end, rather than the other way around
     */
    public void bend(PathCurvature ofAir, boolean isSoundAhead) {
        curvature = ofAir;
        ahead = isSoundAhead ? 1.0 : -1.0;
    }

    /**
     * Follows the path from a point to the one whose images are given. The first wall that reflects the path is the one
     * in which the image source was mirrored last.
     *
     * @param imageSources image sources of the other point
     * @param images positions of the image sources of the other point: {@link ImageSources#positions}
     * @param image index of the image source from which the path is constructed
     * @return whether there is a path, whose properties can then be queried
     */
    public boolean follow(
            ImageSources imageSources, double[] images, int image, double fromX, double fromY, double fromZ) {
        return follow(imageSources, images, image, fromX, fromY, fromZ, WallPlanes.NONE, WallPlanes.NONE);
    }

    /**
     * Follows the path from a point to the one whose images are given, where both may lie on surfaces. A wall reflects
     * no path that begins or ends in its own plane. Rounding may have put such a point on either side of the plane, so
     * the wall's number decides: otherwise sound would leak through a sheet by a reflection on its other side.
     *
     * @param fromWall the wall on which the path begins, or {@link WallPlanes#NONE}
     * @param toWall the wall on which it ends, or {@link WallPlanes#NONE}
     */
    public boolean follow(
            ImageSources imageSources,
            double[] images,
            int image,
            double fromX,
            double fromY,
            double fromZ,
            int fromWall,
            int toWall) {
        if (image != ImageSources.ORIGINAL
                && (isSame(fromWall, imageSources.wall(image)) || isSame(toWall, imageSources.firstWall(image)))) {
            return false;
        }
        isThrough = false;
        free.begin();
        if (isPath(imageSources, images, image, fromX, fromY, fromZ)) {
            return true;
        }
        isThrough = mayPassThrough && free.isBehindWall();
        return isThrough && isPath(imageSources, images, image, fromX, fromY, fromZ);
    }

    private boolean isPath(
            ImageSources imageSources, double[] images, int image, double fromX, double fromY, double fromZ) {
        double x = fromX;
        double y = fromY;
        double z = fromZ;
        int wall = WallPlanes.NONE;
        int corner = image;
        set(before, fromX, fromY, fromZ);
        metHere.clear();
        if (image == ImageSources.ORIGINAL) {
            begin(fromX, fromY, fromZ);
        }
        for (int rest = image; rest != ImageSources.ORIGINAL; rest = imageSources.parent(rest)) {
            int next = imageSources.wall(rest);
            double here = planes.height(next, x, y, z);
            double dx = images[3 * rest] - x;
            double dy = images[3 * rest + 1] - y;
            double dz = images[3 * rest + 2] - z;
            double there = planes.height(next, images[3 * rest], images[3 * rest + 1], images[3 * rest + 2]);
            // At the edge between two walls, a path meets both at once.
            boolean isThere = wall != WallPlanes.NONE && planes.meet(wall, next) && Math.abs(here) < planes.tolerance();
            double fraction = isThere ? 0.0 : here / (here - there);
            corner = isThere ? corner : rest;
            // The path must arrive on the side on which it goes on, even at an edge, which other walls may close.
            double seen = isThere ? planes.height(next, before[0], before[1], before[2]) : here;
            if (isMetTwice(imageSources, corner, rest)
                    || !(seen * there < 0.0)
                    || !planes.mayContain(next, x + fraction * dx, y + fraction * dy, z + fraction * dz)) {
                return false;
            }
            // Most images have already been ruled out at this point.
            if (rest == image) {
                begin(fromX, fromY, fromZ);
            }
            double legX = fraction * dx;
            double legY = fraction * dy;
            double legZ = fraction * dz;
            if (!isThere && !isThrough && free.isCut(before, x, y, z, legX, legY, legZ, metHere, next)
                    || isThrough && !isThere && !passes(x, y, z, legX, legY, legZ, wall, next)) {
                return false;
            }
            int triangle = isThere
                    ? corners.besideEdge(wall, next, x, y, z, before[0], before[1], before[2])
                    : isThrough
                            ? corners.inFront(next, x + legX, y + legY, z + legZ, x, y, z)
                            : free.met(x, y, z, dx, dy, dz, fraction, wall, next);
            if (triangle < 0) {
                return false;
            }
            double whole = Math.sqrt(dx * dx + dy * dy + dz * dz);
            if (rest == image) {
                length = whole;
                set(first, dx / whole, dy / whole, dz / whole);
            }
            double cosine = Math.abs(here - there) / whole;
            if (!legs.reflect(triangle, x + legX, y + legY, z + legZ, dx, dy, dz, cosine)
                    || !isThere && !isThrough && !isFreeAsArc(x, y, z, legX, legY, legZ)) {
                return false;
            }
            for (int band = 0; band < BANDS; band++) {
                reflected[band] *= legs.mirrored(band);
            }
            if (!isThere) {
                set(before, x, y, z);
                metHere.clear();
            }
            metHere.add(next);
            x += legX;
            y += legY;
            z += legZ;
            if (rest == image) {
                set(metFirst, x, y, z);
            }
            wall = next;
        }
        return isFreeToTheEnd(x, y, z, images, wall);
    }

    private void begin(double x, double y, double z) {
        Arrays.fill(reflected, 1.0);
        legs.begin(x, y, z);
    }

    private static boolean isSame(int wall, int other) {
        return wall != WallPlanes.NONE && wall == other;
    }

    /**
     * Whether a path would hit a wall twice in one corner.
     *
     * @param corner the image whose last wall is met first in the corner
     */
    private static boolean isMetTwice(ImageSources imageSources, int corner, int image) {
        for (int met = corner; met != image; met = imageSources.parent(met)) {
            if (imageSources.wall(met) == imageSources.wall(image)) {
                return true;
            }
        }
        return false;
    }

    private static void set(double[] vector, double x, double y, double z) {
        vector[0] = x;
        vector[1] = y;
        vector[2] = z;
    }

    private boolean isFreeToTheEnd(double x, double y, double z, double[] images, int wall) {
        double dx = images[0] - x;
        double dy = images[1] - y;
        double dz = images[2] - z;
        double leg = Math.sqrt(dx * dx + dy * dy + dz * dz);
        set(last, dx / leg, dy / leg, dz / leg);
        if (!isThrough) {
            return free.isFreeToTheEnd(x, y, z, dx, dy, dz, wall)
                    && !free.isCut(before, x, y, z, dx, dy, dz, metHere, WallPlanes.NONE)
                    && isFreeAsArc(x, y, z, dx, dy, dz);
        }
        if (!passes(x, y, z, dx, dy, dz, wall, WallPlanes.NONE)) {
            return false;
        }
        for (int band = 0; band < BANDS; band++) {
            reflected[band] *= legs.passed(band);
        }
        return true;
    }

    private boolean isFreeAsArc(double x, double y, double z, double dx, double dy, double dz) {
        return curvature.isNone() || free.isFreeAsArc(x, y, z, dx, dy, dz, bent(dx, dy, dz));
    }

    private boolean passes(double x, double y, double z, double dx, double dy, double dz, int wall, int next) {
        return legs.goOn(x, y, z, dx, dy, dz, curvature.isNone() ? 0.0 : bent(dx, dy, dz), wall, next);
    }

    private double bent(double dx, double dy, double dz) {
        return curvature.along(ahead * dx, ahead * dy, ahead * dz);
    }

    /** The fraction of a band's energy that remains after all reflections and transmissions along the path. */
    public double reflected(int band) {
        return reflected[band];
    }

    /** The x, y or z coordinate (axis 0, 1 or 2) of the first point at which the path is reflected, m. */
    public double metFirst(int axis) {
        return metFirst[axis];
    }

    /** The length of the whole path, m. */
    public double length() {
        return length;
    }

    /** Cosine of the angle between a unit vector and the direction in which the path leaves its beginning. */
    public double cosineAtBeginning(double[] unit) {
        return first[0] * unit[0] + first[1] * unit[1] + first[2] * unit[2];
    }

    /**
     * Cosine of the angle between a unit vector and the direction in which the path, traced backward, leaves its end.
     */
    public double cosineAtEnd(double x, double y, double z) {
        return -(last[0] * x + last[1] * y + last[2] * z);
    }

    /** Sine of the elevation at which sound leaves the path's beginning; negative downward. */
    public double riseFromBeginning() {
        return first[2];
    }

    /** Sine of the elevation at which sound that travels backward leaves the path's end; negative downward. */
    public double riseFromEnd() {
        return -last[2];
    }

    /**
     * A component of the unit vector along which the path leaves one of its ends.
     *
     * @param side positive for the beginning, negative for the end
     * @param axis 0 for x, 1 for y, 2 for z
     */
    public double leaving(double side, int axis) {
        return side > 0.0 ? first[axis] : -last[axis];
    }
}
