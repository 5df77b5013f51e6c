package org.dronewatch.sensor.acoustic.propagation;

import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/** Whether arcs of sound between two points meet something. One per thread. */
public final class ArcSight {
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
        int pieces = PathCurvature.pieces(curvature, length);
        double beforeX = fromX;
        double beforeY = fromY;
        double beforeZ = fromZ;
        for (int piece = 1; piece <= pieces; piece++) {
            double share = (double) piece / pieces;
            double nextX = fromX + share * x;
            double nextY = fromY + share * y;
            double nextZ = fromZ + share * z - PathCurvature.sag(curvature, length, share * length);
            if (!visibility.isFree(beforeX, beforeY, beforeZ, nextX, nextY, nextZ)) {
                return false;
            }
            beforeX = nextX;
            beforeY = nextY;
            beforeZ = nextZ;
        }
        return true;
    }
}
