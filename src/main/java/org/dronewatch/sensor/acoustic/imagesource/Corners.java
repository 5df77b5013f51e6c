package org.dronewatch.sensor.acoustic.imagesource;

import org.dronewatch.world.Visibility;

/**
 * Tests the corners of walls in spite of rounding. Where walls meet, rounding decides on which side of the other walls
 * a point in one of them lies; where two surfaces in one plane coincide, it decides which of them is met. So this class
 * tests points slightly away from there, or moved to the nearest point of a grid. For use by one thread.
 */
final class Corners {
    /** The distance of the tested points from a corner, as a multiple of the planes' tolerance. */
    static final double BESIDE = 30.0;

    /** The number of points per metre of the grid, a power of two; their spacing is about a micrometre. */
    private static final double GRID = 1 << 20;

    /** A face stands on a wall if the cosine of the angle between their normals is smaller than this in magnitude. */
    private static final double STEEP = 0.9;

    private final WallPlanes planes;
    private final Visibility visibility;
    private final double[] normal = new double[3];

    Corners(WallPlanes planes, Visibility visibility) {
        this.planes = planes;
        this.visibility = visibility;
    }

    /**
     * Whether another wall stands in the corner in which a leg begins: rounding may have put the beginning of the leg
     * behind that wall, so that the leg does not cross it. The previous leg came from the right side.
     *
     * @param before beginning of the previous leg, m
     * @param x x coordinate of the beginning, on a wall, m
     * @param dx x component of the vector along the leg to its end, m
     * @param here the walls on which the leg begins
     * @param next the wall on which the leg ends, or {@link WallPlanes#NONE}
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

    /** The fraction of a vector at which its length is that of a step, but at most half. */
    private static double part(double step, double x, double y, double z) {
        return Math.min(0.5, step / Math.sqrt(x * x + y * y + z * z));
    }

    /**
     * One of several triangles that coincide in a plane: the same one for all paths that are reflected at a point, from
     * either end. Otherwise, rounding would make it depend on the direction.
     *
     * @param triangle one of them
     * @param wall the plane
     * @param x x coordinate of the point, m
     * @param seenX x coordinate of a point on the side from which the plane is seen, m
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
     * @param x x coordinate of the point, m
     * @param seenX x coordinate of a point on the side from which the plane is seen, m
     * @return number of the triangle; negative if the wall is not there, or if something lies just in front of it
     */
    int inFront(int wall, double x, double y, double z, double seenX, double seenY, double seenZ) {
        double off = Math.copySign(BESIDE * planes.tolerance(), planes.height(wall, seenX, seenY, seenZ));
        double nx = off * planes.normal(wall, 0);
        double ny = off * planes.normal(wall, 1);
        double nz = off * planes.normal(wall, 2);
        boolean found = visibility.findFirstAlong(
                onGrid(x) + nx, onGrid(y) + ny, onGrid(z) + nz, -2.0 * nx, -2.0 * ny, -2.0 * nz, 1.0);
        // A face that stands on the wall, and reaches the point only because of rounding, is crossed elsewhere.
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

    /**
     * The coordinate rounded to the nearest multiple of a length that is far above the rounding error of a point and
     * far below the tolerance.
     */
    private static double onGrid(double coordinate) {
        return Math.rint(coordinate * GRID) / GRID;
    }

    /**
     * The triangle of a wall beside its edge with another wall.
     *
     * @param other the other wall
     * @param wall the wall
     * @param x x coordinate of a point in the edge, m
     * @param seenX x coordinate of a point on that side of both walls from which they are seen, m
     * @return number of the triangle; negative if the wall is not there
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
