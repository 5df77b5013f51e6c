package org.dronewatch.sensor.acoustic.propagation;

import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/** Whether arcs of sound between two points meet something. One per thread. */
public final class ArcSight {
    private static final double OVERLAP = 4.0 * Visibility.MARGIN;

    private final Visibility visibility;

    /** In a world, between points that may lie on surfaces. */
    public ArcSight(World world) {
        this.visibility = new Visibility(world);
    }

    /**
     * Whether nothing stands in the arc from one point to another; a straight line is an arc, too.
     *
     * @param curvature of sound on it, either way: {@link PathCurvature#along}, 1/m
     */
    public boolean isFree(
            double fromX, double fromY, double fromZ, double toX, double toY, double toZ, double curvature) {
        double x = toX - fromX;
        double y = toY - fromY;
        double z = toZ - fromZ;
        double length = Math.sqrt(x * x + y * y + z * z);
        int corners = PathCurvature.corners(curvature, length);
        double beforeX = fromX;
        double beforeY = fromY;
        double beforeZ = fromZ;
        for (int corner = 1; corner <= corners + 1; corner++) {
            double share = PathCurvature.shareAt(corner, corners);
            double nextX = fromX + share * x;
            double nextY = fromY + share * y;
            double nextZ = fromZ + share * z - PathCurvature.sagAt(corner, corners, curvature, length);
            if (!visibility.isFree(beforeX, beforeY, beforeZ, nextX, nextY, nextZ)) {
                return false;
            }
            // The next piece begins before this one ends: at both ends of each something may be missed.
            double back = OVERLAP / length;
            beforeX = nextX - back * x;
            beforeY = nextY - back * y;
            beforeZ = nextZ - back * z;
        }
        return true;
    }
}
