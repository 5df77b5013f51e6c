package org.dronewatch.sensor.acoustic.propagation;

import org.dronewatch.sound.Atmosphere;

/**
 * The curvature of sound paths due to wind and temperature: if the effective speed of sound, that in still air plus the
 * speed of the wind along the path, changes linearly with height at the rate g, a path at an elevation gamma is an arc
 * of radius {@code c / (g cos gamma)}, where c is the speed of sound (A. D. Pierce, Acoustics, section 8.3). The wind's
 * profile is assumed linear between the heights of the source and the microphone. Curvatures are positive where sound
 * bends up. Immutable.
 *
 * @param everywhere curvature in all directions, due to temperature, 1/m
 * @param eastward curvature of sound that travels east, due to wind, 1/m
 * @param northward curvature of sound that travels north, due to wind, 1/m
 */
public record PathCurvature(double everywhere, double eastward, double northward) {
    /** The curvature in still air of uniform temperature: straight paths. */
    public static final PathCurvature NONE = new PathCurvature(0.0, 0.0, 0.0);

    /**
     * The greatest curvature, in reciprocals of an arc's length; sharper arcs are given this one, since the formulas
     * hold for flat arcs.
     */
    private static final double SHARPEST = 1.0;

    /** The maximum distance of an arc's straight pieces from the arc, m. */
    public static final double EXACT = 0.02;

    /**
     * The curvature between two heights.
     *
     * @param sourceHeight height of the source above the ground, m
     * @param sensorHeight height of the sensor above the ground, m
     */
    public static PathCurvature of(Atmosphere air, double sourceHeight, double sensorHeight) {
        if (air.isUniform()) {
            return NONE;
        }
        double byWind = -air.wind().shear(sourceHeight, sensorHeight) / air.speedOfSound();
        // The speed of sound is proportional to the square root of the temperature.
        return new PathCurvature(
                -0.5 * air.temperatureGradient() / air.temperature(),
                byWind * air.wind().eastward(),
                byWind * air.wind().northward());
    }

    /** Whether all paths are straight. */
    public boolean isNone() {
        return everywhere == 0.0 && eastward == 0.0 && northward == 0.0;
    }

    /**
     * The curvature of sound that travels along a vector, 1/m: positive if the sound bends up; in magnitude, at most
     * the reciprocal of the vector's length.
     */
    public double along(double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        if (isNone() || !(length > 0.0)) {
            return 0.0;
        }
        double curvature = everywhere + (eastward * x + northward * y) / length;
        return Math.max(-SHARPEST / length, Math.min(SHARPEST / length, curvature));
    }

    /**
     * The height of the straight line above an arc that bends up, or, equivalently, the rise of the ground if arcs are
     * drawn as straight lines, m: {@code k s (L - s) / 2}, where k is the curvature, L the length of the line and s the
     * distance along it. This holds at any elevation if lengths are measured along the line.
     *
     * @param curvature curvature, 1/m; negative if the arc bends down, and runs above the line
     * @param length length of the straight line, m
     * @param at distance along the straight line, m
     */
    public static double sag(double curvature, double length, double at) {
        return at > 0.0 && at < length ? 0.5 * curvature * at * (length - at) : 0.0;
    }

    /**
     * The length of an arc with a given chord, m.
     *
     * @param curvature curvature, 1/m
     * @param chord length of the chord, m
     */
    public static double arc(double curvature, double chord) {
        double half = 0.5 * Math.abs(curvature) * chord;
        return half > 0.0 ? chord * Math.asin(half) / half : chord;
    }

    /**
     * An upper bound on the sum of a point's distances from the two ends of an arc, m, given an upper limit on that sum
     * in coordinates in which arcs are straight lines and the ground is raised by the {@link #sag}.
     *
     * @param curvature curvature, 1/m
     * @param length length of the straight line, m
     * @param limit limit of the sum in these coordinates, at least the length of the straight line, m
     */
    public static double reach(double curvature, double length, double limit) {
        double sag = sag(Math.abs(curvature), length, 0.5 * length);
        double across = 0.5 * Math.sqrt(Math.max(0.0, limit * limit - length * length));
        return sag > 0.0 ? Math.hypot(length, 2.0 * (across + sag)) : limit;
    }

    /**
     * The number of straight pieces that approximate an arc to within {@link #EXACT}.
     *
     * @param curvature curvature, 1/m
     * @param length length of the straight line, m
     */
    public static int pieces(double curvature, double length) {
        return (int) Math.max(1.0, Math.ceil(length * Math.sqrt(Math.abs(curvature) / (8.0 * EXACT))));
    }
}
