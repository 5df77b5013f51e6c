package org.dronewatch.sensor.acoustic.energy;

import org.dronewatch.sensor.acoustic.imagesource.EnteredSolids;
import org.dronewatch.sensor.acoustic.imagesource.ImageSources;
import org.dronewatch.sensor.acoustic.imagesource.SpecularPath;
import org.dronewatch.sensor.acoustic.imagesource.WallPlanes;
import org.dronewatch.sensor.acoustic.imagesource.WallTransmission;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sensor.acoustic.propagation.PathCurvature;
import org.dronewatch.world.World;

/**
 * A leg that connects two points: straight, through the walls between them, or by the specular reflections of an image
 * source. For use by one thread.
 */
final class ConnectingLeg {
    private final WallTransmission walls;
    private final SpecularPath path;
    private boolean isStraight;
    private double x;
    private double y;
    private double z;
    private double length;
    private int traced;

    ConnectingLeg(World world, WallPlanes planes, BandSurfaces surfaces) {
        this.walls = new WallTransmission(world, planes, surfaces);
        this.path = new SpecularPath(world, planes, surfaces);
    }

    /**
     * Searches for a leg from one point to another, whose images are given.
     *
     * @param image image of the other point to which the leg leads; for {@link ImageSources#ORIGINAL}, the leg is
     *     straight, and only {@link #isOpen} determines whether it is open
     * @param fromWall the wall on which the leg begins, or {@link WallPlanes#NONE}
     * @param toWall the wall on which the other point lies, or {@link WallPlanes#NONE}
     * @return whether there is such a leg
     */
    boolean find(
            ImageSources imageSources,
            double[] images,
            int image,
            double fromX,
            double fromY,
            double fromZ,
            int fromWall,
            int toWall) {
        isStraight = image == ImageSources.ORIGINAL;
        if (isStraight) {
            x = images[0] - fromX;
            y = images[1] - fromY;
            z = images[2] - fromZ;
            length = Math.sqrt(x * x + y * y + z * z);
            return true;
        }
        if (!path.follow(imageSources, images, image, fromX, fromY, fromZ, fromWall, toWall)) {
            return false;
        }
        traced += imageSources.order(image) + 1;
        length = path.length();
        return true;
    }

    /**
     * Whether any sound passes. A straight leg is traced only here, since surfaces that face away need no tracing.
     *
     * @param x x coordinate of the end from which the leg is traced, m
     * @param toX x coordinate of the other end, m
     * @param solids the solids within which the end lies from which the leg is traced
     * @param curvature curvature of sound along the leg, 1/m
     */
    boolean isOpen(
            double x, double y, double z, double toX, double toY, double toZ, EnteredSolids solids, double curvature) {
        if (!isStraight) {
            return true;
        }
        traced++;
        return walls.trace(x, y, z, toX, toY, toZ, solids, curvature);
    }

    /**
     * Sets the curvature that the air gives to subsequent reflected legs.
     *
     * @param isSoundAhead whether sound travels from their beginning to their end, rather than the other way around
     */
    void bend(PathCurvature curvature, boolean isSoundAhead) {
        path.bend(curvature, isSoundAhead);
    }

    /** Whether the leg passes through walls. */
    boolean isThroughWalls() {
        return isStraight && !walls.isFree();
    }

    /** The fraction of a band's energy that the walls along the leg transmit or reflect. */
    double passed(int band) {
        return isStraight ? walls.passed(band) : path.reflected(band);
    }

    /** The length of the leg, m. */
    double length() {
        return length;
    }

    /** Cosine of the angle between a unit vector and the direction in which the leg leaves its beginning. */
    double cosineAtBeginning(double[] unit) {
        return isStraight ? (x * unit[0] + y * unit[1] + z * unit[2]) / length : path.cosineAtBeginning(unit);
    }

    /**
     * Cosine of the angle between a unit vector and the direction in which the leg, traced backward, leaves its end.
     */
    double cosineAtEnd(double[] unit) {
        return isStraight
                ? -(x * unit[0] + y * unit[1] + z * unit[2]) / length
                : path.cosineAtEnd(unit[0], unit[1], unit[2]);
    }

    /** Sine of the elevation at which sound that travels backward leaves the end of the leg. */
    double riseFromEnd() {
        return isStraight ? -z / length : path.riseFromEnd();
    }

    /** The number of segments traced since the last call. */
    int takeTraced() {
        int count = traced;
        traced = 0;
        return count;
    }
}
