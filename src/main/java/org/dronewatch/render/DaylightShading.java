package org.dronewatch.render;

import org.dronewatch.render.canvas.Canvas;

/**
 * Daylight shading of surfaces and sky: the sun in the south-west, light from all of the sky, and some from the eye.
 */
final class DaylightShading {
    /** Unit vector to the sun. */
    static final double SUN_X = -0.46;

    static final double SUN_Y = -0.38;
    static final double SUN_Z = Math.sqrt(1.0 - SUN_X * SUN_X - SUN_Y * SUN_Y);

    private static final double SKY = 0.46;
    private static final double SUN = 0.52;
    private static final double EYE = 0.16;

    private static final int HORIZON = 0xf1f5f9;
    private static final int ZENITH = 0xa9c6e6;
    private static final int BELOW = 0xdbe1e6;

    private DaylightShading() {}

    /**
     * The colour of a surface.
     *
     * @param colour colour in full light
     * @param nx x of the unit normal, to either side
     * @param ny y of the unit normal
     * @param nz z of the unit normal
     * @param dx x of the unit vector from the eye to the surface
     * @param dy y of that vector
     * @param dz z of that vector
     * @param sun visible fraction of the sun, 0 to 1
     */
    static int shade(int colour, double nx, double ny, double nz, double dx, double dy, double dz, double sun) {
        double facing = nx * dx + ny * dy + nz * dz;
        double side = facing > 0.0 ? -1.0 : 1.0;
        double sky = 0.62 + 0.38 * side * nz;
        double direct = Math.max(0.0, side * (nx * SUN_X + ny * SUN_Y + nz * SUN_Z));
        return scaled(colour, SKY * sky + SUN * sun * direct + EYE * Math.abs(facing));
    }

    /** Whether the side of a surface that is seen along a direction is turned to the sun. */
    static boolean isTurnedToSun(double nx, double ny, double nz, double dx, double dy, double dz) {
        boolean front = nx * dx + ny * dy + nz * dz < 0.0;
        return nx * SUN_X + ny * SUN_Y + nz * SUN_Z > 0.0 == front;
    }

    /** A colour scaled by a fraction of its light. */
    static int scaled(int colour, double light) {
        int weight = (int) (256.0 * light);
        int r = Math.min(255, (colour >> 16 & 255) * weight >> 8);
        int g = Math.min(255, (colour >> 8 & 255) * weight >> 8);
        int b = Math.min(255, (colour & 255) * weight >> 8);
        return r << 16 | g << 8 | b;
    }

    /** The colour of the sky in a direction, given the vertical component of its unit vector. */
    static int sky(double up) {
        return up >= 0.0
                ? Canvas.mix(HORIZON, ZENITH, Math.min(1.0, 1.4 * up))
                : Canvas.mix(HORIZON, BELOW, Math.min(1.0, -6.0 * up));
    }
}
