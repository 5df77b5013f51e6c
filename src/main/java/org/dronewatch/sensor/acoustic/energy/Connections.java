package org.dronewatch.sensor.acoustic.energy;

/**
 * The weights of paths that can be found in several ways. Sound from a drone to a sensor that is scattered n times
 * follows n + 1 legs. Rays from one end, the start, may find the path up to any of these legs, and rays from the other
 * end, the target, may find the rest of the path; that leg then connects the two parts. Each of these strategies is
 * weighted by its fraction of the probability density with which all of them find the path (Veach and Guibas, SIGGRAPH
 * 1995, the balance heuristic), so that the path counts once, and no path is found only rarely, whether its surfaces
 * lie near the start or near the target.
 *
 * <p>By Lambert's law, a ray from either end of a leg finds the other end with the same density. So the density of a
 * strategy is the product of the densities of all legs but the one at which it connects, and its weight is proportional
 * to the reciprocal of that leg's density, here called the <em>inverse density</em>, m2.
 */
final class Connections {
    /** In the open, the maximum number of times that a ray from the target is scattered, and connected there. */
    static final int FROM_TARGET = 3;

    /** The inverse density of a leg that rays cannot connect. */
    static final double NEVER = 0.0;

    private static final double SPHERE = 4.0 * Math.PI;

    /**
     * The factor by which a wall increases the inverse density, so that a leg through a wall is connected: rays hardly
     * ever get through.
     */
    private static final double THROUGH_WALLS = 1e6;

    private Connections() {}

    /**
     * The inverse density of a leg from one of the ends, from which rays leave isotropically.
     *
     * @param arriving cosine of the angle between the leg and the normal of the surface at which it ends
     * @param length length of the leg, m
     */
    static double fromPoint(double arriving, double length) {
        return SPHERE * length * length / arriving;
    }

    /**
     * The inverse density of a leg between two surfaces.
     *
     * @param leaving cosine of the angle between the leg and the normal of one surface
     * @param arriving cosine of the angle between the leg and the normal of the other one
     * @param length length of the leg, m
     */
    static double betweenSurfaces(double leaving, double arriving, double length) {
        return Math.PI * length * length / (leaving * arriving);
    }

    /** The inverse density of a leg that passes through walls instead of through air alone. */
    static double throughWalls(double inverseDensity) {
        return THROUGH_WALLS * inverseDensity;
    }

    /**
     * The weight of a strategy.
     *
     * @param mine the inverse density of the leg at which the strategy connects
     * @param others the sum of the inverse densities of all other legs at which the same path could be connected
     */
    static double weight(double mine, double others) {
        return mine / (mine + others);
    }
}
