package org.dronewatch.sensor.acoustic.propagation;

import org.dronewatch.sound.Atmosphere;

/**
 * How wind and temperature bend the paths of sound: where the effective speed of sound, that of the air and of the wind
 * along the path, changes linearly with height by g, a path at an elevation gamma is an arc of the radius
 * {@code c / (g cos gamma)} (A. D. Pierce, Acoustics, section 8.3). The wind's profile is taken as linear between the
 * heights of source and microphone. Immutable.
 *
 * @param everywhere curvature by temperature, positive where it bends sound up, 1/m
 * @param eastward curvature by wind of sound that travels east, 1/m
 * @param northward of sound that travels north, 1/m
 */
public record PathCurvature(double everywhere, double eastward, double northward) {
    /** That of still air of uniform temperature: straight paths. */
    public static final PathCurvature NONE = new PathCurvature(0.0, 0.0, 0.0);

    /** Sharper arcs, in reciprocals of their length, are taken for this: the formulas hold for flat ones. */
    private static final double SHARPEST = 1.0;

    /** How far the straight pieces of which an arc is made may lie off it, m. */
    public static final double EXACT = 0.02;

    /**
     * Between two heights.
     *
     * @param sourceHeight of the source over the ground, m
     * @param sensorHeight of the sensor over the ground, m
     */
    public static PathCurvature of(Atmosphere air, double sourceHeight, double sensorHeight) {
        if (air.isUniform()) {
            return NONE;
        }
        double byWind = -air.wind().shear(sourceHeight, sensorHeight) / air.speedOfSound();
        // The speed of sound is proportional to the root of the temperature.
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
     * The curvature of sound that travels along a vector, 1/m: positive where it bends up, at most the reciprocal of
     * the vector's length.
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
     * How much lower than the straight line an arc that bends up runs, or, the other way round, how much higher the
     * ground is where arcs are drawn as straight lines, m: {@code k s (L - s) / 2}. That holds at any elevation, with
     * lengths along the line.
     *
     * @param curvature 1/m; negative where the arc bends down, and runs higher
     * @param length of the straight line, m
     * @param at how far along it, m
     */
    public static double sag(double curvature, double length, double at) {
        return at > 0.0 && at < length ? 0.5 * curvature * at * (length - at) : 0.0;
    }

    /**
     * The length of an arc over a chord, m.
     *
     * @param curvature 1/m
     * @param chord m
     */
    public static double arc(double curvature, double chord) {
        double half = 0.5 * Math.abs(curvature) * chord;
        return half > 0.0 ? chord * Math.asin(half) / half : chord;
    }

    /**
     * The sum of distances from both ends within which the surfaces lie that are within another sum where arcs are
     * drawn straight, m.
     *
     * @param curvature 1/m
     * @param length of the straight line, m
     * @param limit the other sum, at least that length, m
     */
    public static double reach(double curvature, double length, double limit) {
        double sag = sag(Math.abs(curvature), length, 0.5 * length);
        double across = 0.5 * Math.sqrt(Math.max(0.0, limit * limit - length * length));
        return sag > 0.0 ? Math.hypot(length, 2.0 * (across + sag)) : limit;
    }

    /**
     * Of how many straight pieces an arc is made.
     *
     * @param curvature 1/m
     * @param length m
     */
    public static int pieces(double curvature, double length) {
        return (int) Math.max(1.0, Math.ceil(length * Math.sqrt(Math.abs(curvature) / (8.0 * EXACT))));
    }
}
