package org.dronewatch.sensor.acoustic.imagesource;

import org.dronewatch.world.Visibility;

/**
 * Where walls meet, rounding decides on which side of the other walls a point in one of them lies, and where two
 * surfaces of one plane coincide, which of them is met. This class tests points slightly away from there, or moved to
 * the nearest point of a grid. For use by one thread.
 */
final class Corners {
    /** How far away, as a multiple of the planes' tolerance. */
    static final double BESIDE = 30.0;

    /** Points per metre of the grid, a power of two: about a micrometre. */
    private static final double GRID = 1 << 20;

    /** A face whose normal is at least this far from that of a wall, as a cosine, stands on it. */
    private static final double STEEP = 0.9;

    private final WallPlanes planes;
    private final Visibility visibility;
    private final double[] normal = new double[3];

    Corners(WallPlanes planes, Visibility visibility) {
        this.planes = planes;
        this.visibility = visibility;
    }

    /**
     * Whether another wall stands in the corner in which a leg begins: rounding may have put its beginning behind that
     * wall, so that the leg does not cross it. The last leg came from the right side.
     *
     * @param before where the last leg began, m
     * @param x of the beginning, on a wall, m
     * @param dx along the leg to its end, m
     * @param here the walls on which it begins
     * @param next on which it ends, or {@link WallPlanes#NONE}
     */
    boolean isCut(
            double[] before, double x, double y, double z, double dx, double dy, double dz, MetWalls here, int next) {
        if (here.isEmpty()) {
            return false;
        }
        double step = BESIDE * planes.tolerance();
        double back = part(step, before[0] - x, before[1] - y, before[2] - z);
        double on = part(step, dx, dy, dz);
        double startX = x + back * (before[0] - x);
        double startY = y + back * (before[1] - y);
        double startZ = z + back * (before[2] - z);
        boolean found = visibility.findFirstAlong(
                startX, startY, startZ, x + on * dx - startX, y + on * dy - startY, z + on * dz - startZ, 1.0);
        while (found && isOf(visibility.triangle(), here, next)) {
            found = visibility.findNext();
        }
        return found;
    }

    private boolean isOf(int triangle, MetWalls here, int next) {
        int met = planes.wallOf(triangle);
        return met != WallPlanes.NONE && (met == next || here.contains(met));
    }

    /** The part of a vector that is not longer than a step, nor than half of it. */
    private static double part(double step, double x, double y, double z) {
        return Math.min(0.5, step / Math.sqrt(x * x + y * y + z * z));
    }

    /**
     * Of several triangles that coincide in one plane, the same one for all paths that are reflected at a point, from
     * either end: rounding would make that a matter of the direction.
     *
     * @param triangle one of them
     * @param wall the plane
     * @param x of the point, m
     * @param seenX of a point on the side from which the plane is seen, m
     */
    int uppermost(int triangle, int wall, double x, double y, double z, double seenX, double seenY, double seenZ) {
        double off = Math.copySign(BESIDE * planes.tolerance(), planes.height(wall, seenX, seenY, seenZ));
        double nx = off * planes.normal(wall, 0);
        double ny = off * planes.normal(wall, 1);
        double nz = off * planes.normal(wall, 2);
        boolean found = visibility.findFirstAlong(
                onGrid(x) + nx, onGrid(y) + ny, onGrid(z) + nz, -2.0 * nx, -2.0 * ny, -2.0 * nz, 1.0);
        return found && planes.wallOf(visibility.triangle()) == wall ? visibility.triangle() : triangle;
    }

    /**
     * The triangle of a wall at a point in it.
     *
     * @param wall the plane
     * @param x of the point, m
     * @param seenX of a point on the side from which the plane is seen, m
     * @return its number; negative if the wall is not there, or if something lies just in front of it
     */
    int inFront(int wall, double x, double y, double z, double seenX, double seenY, double seenZ) {
        double off = Math.copySign(BESIDE * planes.tolerance(), planes.height(wall, seenX, seenY, seenZ));
        double nx = off * planes.normal(wall, 0);
        double ny = off * planes.normal(wall, 1);
        double nz = off * planes.normal(wall, 2);
        boolean found = visibility.findFirstAlong(
                onGrid(x) + nx, onGrid(y) + ny, onGrid(z) + nz, -2.0 * nx, -2.0 * ny, -2.0 * nz, 1.0);
        // What stands on the wall, and reaches the point by rounding alone, is crossed elsewhere.
        while (found && planes.wallOf(visibility.triangle()) != wall && stands(visibility.triangle(), wall)) {
            found = visibility.findNext();
        }
        return found && planes.wallOf(visibility.triangle()) == wall ? visibility.triangle() : -1;
    }

    private boolean stands(int triangle, int wall) {
        visibility.world().mesh().normal(triangle, normal);
        double along = normal[0] * planes.normal(wall, 0)
                + normal[1] * planes.normal(wall, 1)
                + normal[2] * planes.normal(wall, 2);
        double size = Math.sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
        return Math.abs(along) < STEEP * size;
    }

    /** The nearest multiple of a length that is far above the rounding of a point and far below the tolerance. */
    private static double onGrid(double coordinate) {
        return Math.rint(coordinate * GRID) / GRID;
    }

    /**
     * The triangle of a wall beside its edge with another one.
     *
     * @param other the other wall
     * @param wall the wall
     * @param x of a point in the edge, m
     * @param seenX of a point on that side of both walls from which they are seen, m
     * @return its number; negative if the wall is not there
     */
    int besideEdge(int other, int wall, double x, double y, double z, double seenX, double seenY, double seenZ) {
        double step = BESIDE * planes.tolerance();
        double up = Math.copySign(step, planes.height(other, seenX, seenY, seenZ));
        double off = Math.copySign(step, planes.height(wall, seenX, seenY, seenZ));
        double startX = x + up * planes.normal(other, 0) + off * planes.normal(wall, 0);
        double startY = y + up * planes.normal(other, 1) + off * planes.normal(wall, 1);
        double startZ = z + up * planes.normal(other, 2) + off * planes.normal(wall, 2);
        boolean found = visibility.findFirstAlong(
                startX,
                startY,
                startZ,
                -2.0 * off * planes.normal(wall, 0),
                -2.0 * off * planes.normal(wall, 1),
                -2.0 * off * planes.normal(wall, 2),
                1.0);
        return found && planes.wallOf(visibility.triangle()) == wall ? visibility.triangle() : -1;
    }
}
