package org.dronewatch.sensor.acoustic.imagesource;

import org.dronewatch.sensor.acoustic.propagation.ArcSight;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sensor.acoustic.propagation.PathCurvature;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * Tests whether the legs of a path of specular reflections are clear, and finds the triangles that they hit. For use by
 * one thread.
 */
final class FreeLegs {
    /** The largest fraction of a leg, at either end, along which an arc need not be clear. */
    private static final double MOST_OFF = 0.01;

    private final WallPlanes planes;
    private final BandSurfaces surfaces;
    private final Visibility visibility;
    private final Corners corners;
    private final ArcSight arcs;
    private boolean isBehindWall;

    FreeLegs(World world, WallPlanes planes, BandSurfaces surfaces) {
        this.planes = planes;
        this.surfaces = surfaces;
        this.visibility = Visibility.ofClearPoints(world);
        this.corners = new Corners(planes, visibility);
        this.arcs = new ArcSight(world);
    }

    /** Begins a path. */
    void begin() {
        isBehindWall = false;
    }

    /**
     * Whether the last obstacle may transmit sound; what lies beyond it has not been examined.
     */
    boolean isBehindWall() {
        return isBehindWall;
    }

    /** The tests of corners, where walls meet. */
    Corners corners() {
        return corners;
    }

    /** Whether another wall stands in the corner in which a leg begins: see {@link Corners#isCut}. */
    boolean isCut(
            double[] before, double x, double y, double z, double dx, double dy, double dz, MetWalls here, int next) {
        boolean isCut = corners.isCut(before, x, y, z, dx, dy, dz, here, next);
        if (isCut) {
            noteObstacle();
        }
        return isCut;
    }

    private void noteObstacle() {
        isBehindWall = surfaces.anyTransmits() && surfaces.transmits(visibility.material());
    }

    /**
     * Whether a leg that is clear as a straight line is also clear as an arc.
     *
     * @param bent curvature of the arc, 1/m
     */
    boolean isFreeAsArc(double x, double y, double z, double dx, double dy, double dz, double bent) {
        double whole = Math.sqrt(dx * dx + dy * dy + dz * dz);
        if (PathCurvature.pieces(bent, whole) == 1) {
            return true;
        }
        // Rounding may have put the ends behind the walls on which they lie.
        double off = Math.min(MOST_OFF, Corners.BESIDE * planes.tolerance() / whole);
        double end = 1.0 - off;
        boolean isFree =
                arcs.isFree(x + off * dx, y + off * dy, z + off * dz, x + end * dx, y + end * dy, z + end * dz, bent);
        isBehindWall |= !isFree && surfaces.anyTransmits();
        return isFree;
    }

    /**
     * The triangle at which a leg of a path hits a wall.
     *
     * @param fraction fraction of the vector at which it should hit the wall
     * @return number of the triangle; negative if something else is hit first
     */
    int met(double x, double y, double z, double dx, double dy, double dz, double fraction, int from, int to) {
        if (!findFirst(x, y, z, dx, dy, dz, Double.POSITIVE_INFINITY, from)) {
            return -1;
        }
        int triangle = visibility.triangle();
        int met = planes.wallOf(triangle);
        if (met == to) {
            return planes.isMixed(to)
                    ? corners.uppermost(triangle, to, x + fraction * dx, y + fraction * dy, z + fraction * dz, x, y, z)
                    : triangle;
        }
        noteObstacle();
        if (met == WallPlanes.NONE || !planes.meet(met, to)) {
            return -1;
        }
        // At the edge between two walls, rounding decides which of them is met first.
        double off = Math.abs(visibility.distance() - fraction) * Math.sqrt(dx * dx + dy * dy + dz * dz);
        return off < planes.tolerance()
                ? corners.besideEdge(met, to, x + fraction * dx, y + fraction * dy, z + fraction * dz, x, y, z)
                : -1;
    }

    /** Whether the last leg of a path, from a wall to the path's end, is clear. */
    boolean isFreeToTheEnd(double x, double y, double z, double dx, double dy, double dz, int wall) {
        boolean found = findFirst(x, y, z, dx, dy, dz, 1.0, wall);
        if (found) {
            noteObstacle();
        }
        return !found;
    }

    /**
     * Finds what a leg of a path hits first. The wall from which the leg comes is flat and hides nothing in front of
     * it, though rounding may have put the leg's beginning behind one of the wall's triangles.
     */
    private boolean findFirst(double x, double y, double z, double dx, double dy, double dz, double end, int wall) {
        boolean found = visibility.findFirstAlong(x, y, z, dx, dy, dz, end);
        while (found && wall != WallPlanes.NONE && planes.wallOf(visibility.triangle()) == wall) {
            found = visibility.findNext();
        }
        return found;
    }
}
