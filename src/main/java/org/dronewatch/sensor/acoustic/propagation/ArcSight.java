package org.dronewatch.sensor.acoustic.propagation;

import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/** Tests whether arcs of sound between two points are unobstructed. For use by one thread. */
public final class ArcSight {
    private static final double OVERLAP = 4.0 * Visibility.MARGIN;

    private final Visibility visibility;
    private final ArcLine line = new ArcLine();

    /** A test in a world, between points that may lie on surfaces. */
    public ArcSight(World world) {
        this.visibility = new Visibility(world);
    }

    /**
     * Whether the arc, or straight line, from one point to another is unobstructed.
     *
     * @param curvature curvature of the arc, 1/m: {@link PathCurvature#along} in the direction in which the sound
     *     travels, from the first point to the second or the reverse; 0 for a straight line
     */
    public boolean isFree(
            double fromX, double fromY, double fromZ, double toX, double toY, double toZ, double curvature) {
        line.lay(fromX, fromY, fromZ, toX, toY, toZ, curvature, false);
        double back = OVERLAP / line.length();
        double beforeX = fromX;
        double beforeY = fromY;
        double beforeZ = fromZ;
        for (int piece = 0; piece < line.pieces(); piece++) {
            double nextX = line.x(piece);
            double nextY = line.y(piece);
            double nextZ = line.z(piece);
            if (!visibility.isFree(beforeX, beforeY, beforeZ, nextX, nextY, nextZ)) {
                return false;
            }
            // The next piece begins before this one ends, since surfaces do not count near the ends of pieces.
            beforeX = nextX - back * (toX - fromX);
            beforeY = nextY - back * (toY - fromY);
            beforeZ = nextZ - back * (toZ - fromZ);
        }
        return true;
    }
}
