package org.dronewatch.sensor.radio;

/**
 * Reflection from the earth as a sphere with 4/3 of its radius, above which waves in the standard atmosphere travel in
 * straight lines (ITU-R P.834; L. V. Blake, Radar Range-Performance Analysis, chapter 6). For distances and heights
 * that are small compared with the radius.
 */
final class RoundEarth {
    /** m. */
    static final double RADIUS = 4.0 / 3.0 * 6_371_000.0;

    private RoundEarth() {}

    /**
     * How far from the first of two places the reflected path meets the surface: the middle root of the cubic equation
     * for equal angles, in its trigonometric form.
     *
     * @param one height of the first, above 0, m
     * @param other height of the second, above 0, m
     * @param distance between them, above 0, m
     * @return m
     */
    static double reflection(double one, double other, double distance) {
        double p = 2.0 / Math.sqrt(3.0) * Math.sqrt(RADIUS * (one + other) + 0.25 * distance * distance);
        double sine = 2.0 * RADIUS * distance * (other - one) / (p * p * p);
        return 0.5 * distance - p * Math.sin(Math.asin(Math.max(-1.0, Math.min(1.0, sine))) / 3.0);
    }

    /** How far the surface lies below the tangent at a distance, m. */
    static double drop(double distance) {
        return distance * distance / (2.0 * RADIUS);
    }

    /**
     * How much weaker the reflected field is than on a plane, because the sphere spreads it (D. E. Kerr, Propagation of
     * Short Radio Waves, section 2.2): {@code (1 + 2 d1 d2 / (R (d1 + d2) sin(psi)))^(-1/2)}.
     *
     * @param before distance from the first place to the reflection, m
     * @param beyond distance from there to the second, m
     * @param sine of the grazing angle, above 0
     * @return 0 to 1
     */
    static double divergence(double before, double beyond, double sine) {
        return 1.0 / Math.sqrt(1.0 + 2.0 * before * beyond / (RADIUS * (before + beyond) * sine));
    }
}
