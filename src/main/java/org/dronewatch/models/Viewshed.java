package org.dronewatch.models;

/** The part of the ground that is visible from a point above the plan origin. */
public final class Viewshed {

    private static final int AZIMUTHS = 1440;
    private static final double STEP_METRES = 2.5;

    private final HillTerrain terrain;

    /** The view over a terrain. */
    public Viewshed(HillTerrain terrain) {
        this.terrain = terrain;
    }

    /**
     * Fraction of the ground within a radius of the plan origin, by plan area, that the terrain hides from the eye.
     *
     * @param eyeAboveGround height of the eye above the ground at the plan origin, metres
     * @param radius metres, at most half the terrain's edge
     * @return 0 (all seen) to 1 (all hidden)
     */
    public double hiddenFraction(double eyeAboveGround, double radius) {
        double hidden = 0;
        double total = 0;
        int steps = (int) (radius / STEP_METRES);
        for (int k = 0; k < AZIMUTHS; k++) {
            double azimuth = 2 * StrictMath.PI * k / AZIMUTHS;
            double sin = StrictMath.sin(azimuth);
            double cos = StrictMath.cos(azimuth);
            double eye = terrain.groundHeight(0, 0) + eyeAboveGround;
            double horizon = Double.NEGATIVE_INFINITY;
            for (int n = 1; n <= steps; n++) {
                double distance = n * STEP_METRES;
                double rise = (terrain.groundHeight(distance * sin, distance * cos) - eye) / distance;
                hidden += rise < horizon ? distance : 0;
                total += distance;
                horizon = Math.max(horizon, rise);
            }
        }
        return hidden / total;
    }

    /**
     * Least height of a level flight path above the ground below it.
     *
     * @param aboveTop height of the path above the ground at the plan origin, metres
     * @param northFrom where the path begins, metres north of the origin; it ends at the origin
     * @return clearance, metres; negative where the path would enter the ground
     */
    public double clearanceOnApproachFromNorth(double aboveTop, double northFrom) {
        double path = terrain.groundHeight(0, 0) + aboveTop;
        double clearance = Double.POSITIVE_INFINITY;
        for (double north = 0; north <= northFrom; north += 1) {
            clearance = Math.min(clearance, path - terrain.groundHeight(0, north));
        }
        return clearance;
    }
}
