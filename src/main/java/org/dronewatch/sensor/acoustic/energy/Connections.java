package org.dronewatch.sensor.acoustic.energy;

/**
 * How paths count that can be found in several ways. Sound from a drone to a sensor that is scattered n times follows n +
 * 1 legs. Rays from the sensor may find the path up to any of these legs, rays from the source the rest, and the leg is
 * where both are connected. Each way counts with its fraction of the probability with which all of them find the path
 * (Veach and Guibas, SIGGRAPH 1995, the balance heuristic), so that together they count once, and no path is rare, whether
 * its surfaces lie near the sensor or near the source.
 *
 * <p>By Lambert's law a ray from one end of a leg finds the other end with the same density both ways. So the density of
 * a way is the product of those of all legs but the one at which it connects, and its weight is in proportion to the
 * reciprocal of that leg's density: the <em>reluctance</em> here, m2.
 */
final class Connections {
    /** The most times that a ray from the source is scattered, or connected where it is, in the open. */
    static final int FROM_SOURCE = 3;

    /** A leg that rays cannot connect. */
    static final double NEVER = 0.0;

    private static final double SPHERE = 4.0 * Math.PI;

    /** A leg through a wall is connected: rays hardly ever get through. */
    private static final double THROUGH_WALLS = 1e6;

    private Connections() {}

    /**
     * The reluctance of a leg from a source or a sensor, from which rays leave in all directions alike.
     *
     * @param arriving cosine of the angle between the leg and the normal of the surface at which it ends
     * @param length of the leg, m
     */
    static double fromPoint(double arriving, double length) {
        return SPHERE * length * length / arriving;
    }

    /**
     * The reluctance of a leg between two surfaces.
     *
     * @param leaving cosine of the angle between the leg and the normal of one surface
     * @param arriving cosine of the angle between the leg and the normal of the other one
     * @param length of the leg, m
     */
    static double betweenSurfaces(double leaving, double arriving, double length) {
        return Math.PI * length * length / (leaving * arriving);
    }

    /** The reluctance of a leg that goes through walls instead of air alone. */
    static double throughWalls(double reluctance) {
        return THROUGH_WALLS * reluctance;
    }

    /**
     * The weight of a way.
     *
     * @param mine the reluctance of the leg where it connects
     * @param others the sum of those of all other legs at which the same path could be connected
     */
    static double weight(double mine, double others) {
        return mine / (mine + others);
    }
}
