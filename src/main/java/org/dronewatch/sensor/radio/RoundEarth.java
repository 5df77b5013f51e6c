package org.dronewatch.sensor.radio;

/**
 * Reflection from the earth, which is represented by a sphere with 4/3 of its radius: above such a sphere, waves in the
 * standard atmosphere travel in straight lines (ITU-R P.834; L. V. Blake, Radar Range-Performance Analysis, chapter 6).
 * Valid for distances and heights that are small compared with the radius.
 */
final class RoundEarth {
    /** The radius of the sphere, m. */
    static final double RADIUS = 4.0 / 3.0 * 6_371_000.0;

    private RoundEarth() {}

    /**
     * The distance from the first of two positions at which the reflected path meets the surface: the middle root of
     * the cubic equation for equal angles, in its trigonometric form.
     *
     * @param one height of the first position, above 0, m
     * @param other height of the second position, above 0, m
     * @param distance distance between them, above 0, m
     * @return the distance, m
     */
    static double reflection(double one, double other, double distance) {
        double p = 2.0 / Math.sqrt(3.0) * Math.sqrt(RADIUS * (one + other) + 0.25 * distance * distance);
        double sine = 2.0 * RADIUS * distance * (other - one) / (p * p * p);
        return 0.5 * distance - p * Math.sin(Math.asin(Math.max(-1.0, Math.min(1.0, sine))) / 3.0);
    }

    /** The depth of the surface below its tangent plane, at a distance from the point of contact, m. */
    static double drop(double distance) {
        return distance * distance / (2.0 * RADIUS);
    }

    /**
     * The reflected field relative to that of a plane; it is weaker because the sphere spreads it (D. E. Kerr,
     * Propagation of Short Radio Waves, section 2.2): {@code (1 + 2 d1 d2 / (R (d1 + d2) sin(psi)))^(-1/2)}.
     *
     * @param before distance from the first position to the point of reflection, m
     * @param beyond distance from there to the second position, m
     * @param sine sine of the grazing angle, above 0
     * @return 0 to 1
     */
    static double divergence(double before, double beyond, double sine) {
        return 1.0 / Math.sqrt(1.0 + 2.0 * before * beyond / (RADIUS * (before + beyond) * sine));
    }
}
