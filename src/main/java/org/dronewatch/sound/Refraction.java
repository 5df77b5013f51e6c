package org.dronewatch.sound;

import java.util.OptionalDouble;

/**
 * Refraction of a plane wave at the flat interface between two fluids. Angles are measured from the normal, radians, 0
 * to pi/2.
 *
 * <p>For sound from air, the critical angle of solids is below 7 degrees, so this class does not model walls: a wall
 * has a transmission loss.
 */
public final class Refraction {
    private Refraction() {}

    /**
     * Angle of refraction t2 by Snell's law, {@code sin t2 / sin t1 = c2 / c1}, where t1 is the angle of incidence and
     * c1 and c2 are the speeds of sound in front of the interface and behind it.
     *
     * @param incidence angle of incidence, 0 to pi/2
     * @param speed speed of sound in front of the interface, above 0, m/s
     * @param speedBehind speed of sound behind it, above 0, m/s
     * @return 0 to pi/2; empty for total internal reflection
     */
    public static OptionalDouble angle(double incidence, double speed, double speedBehind) {
        double sine = speedBehind / speed * Math.sin(incidence);
        return sine < 1.0 ? OptionalDouble.of(Math.asin(sine)) : OptionalDouble.empty();
    }

    /**
     * Critical angle of incidence, at and above which everything is reflected.
     *
     * @param speed speed of sound in front of the interface, above 0, m/s
     * @param speedBehind speed of sound behind it, above 0, m/s
     * @return above 0 and below pi/2; empty unless sound is faster behind the interface
     */
    public static OptionalDouble criticalAngle(double speed, double speedBehind) {
        return speedBehind > speed ? OptionalDouble.of(Math.asin(speed / speedBehind)) : OptionalDouble.empty();
    }

    /**
     * The fraction of the energy that is transmitted: {@code 1 - r^2} with {@code r = (Z2 - Z1) / (Z2 + Z1)} and
     * {@code Z = rho c / cos t}, from the density rho, the speed of sound c and the angle t of the wave, Z1 in front of
     * the interface and Z2 behind it (Rayleigh's coefficient for two fluids; Kinsler and others, Fundamentals of
     * Acoustics, chapter 6).
     *
     * @param incidence angle of incidence, 0 to pi/2
     * @return 0 to 1; 0 for total internal reflection
     */
    public static double transmitted(double incidence, Medium from, Medium to) {
        OptionalDouble behind = angle(incidence, from.speed(), to.speed());
        if (behind.isEmpty()) {
            return 0.0;
        }
        // Both impedances times both cosines: grazing incidence does not divide by 0.
        double before = from.impedance() * Math.cos(behind.getAsDouble());
        double after = to.impedance() * Math.cos(incidence);
        double both = before + after;
        return 4.0 * before * after / (both * both);
    }
}
