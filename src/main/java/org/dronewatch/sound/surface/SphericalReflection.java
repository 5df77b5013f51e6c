package org.dronewatch.sound.surface;

/**
 * The reflection of a spherical wave by flat ground: the Weyl-van der Pol solution {@code Q = Rp + (1 - Rp) F(w)}, with
 * the plane wave's {@code Rp = (cos t - 1/Z) / (cos t + 1/Z)}, the boundary loss factor
 * {@code F = 1 + i sqrt(pi) w erfcx(-i w)} and the numerical distance {@code w = sqrt(i k R2 / 2) (cos t + 1/Z)} (K.
 * Attenborough, S. I. Hayek and J. M. Lawther, JASA 68, 1493, 1980; C. F. Chien and W. W. Soroka, JSV 43, 9, 1975). The
 * time dependence is {@code exp(-i w t)}, where w is the angular frequency here.
 */
final class SphericalReflection {
    private static final double ROOT_PI = Math.sqrt(Math.PI);

    private SphericalReflection() {}

    /**
     * The amplitude of the reflected wave relative to that of the image source on rigid ground.
     *
     * @param ground impedance of the reflecting ground
     * @param frequency frequency, above 0, Hz
     * @param soundSpeed speed of sound, above 0, m/s
     * @param length length of the reflected path, above 0, m
     * @param cosine cosine of the angle of incidence, from the normal of the ground, 0 to 1
     */
    static Complex coefficient(
            GroundImpedance ground, double frequency, double soundSpeed, double length, double cosine) {
        Complex admittance = ground.admittance(frequency);
        if (ground.isRigid()) {
            return Complex.ONE;
        }
        Complex sum = admittance.plus(cosine);
        Complex plane = new Complex(cosine, 0.0).minus(admittance).over(sum);
        // sqrt(i x / 2) is sqrt(x) (1 + i) / 2.
        double half = 0.5 * Math.sqrt(2.0 * Math.PI * frequency / soundSpeed * length);
        Complex distance = new Complex(half, half).times(sum);
        Complex loss =
                distance.times(Faddeeva.w(distance)).timesI().times(ROOT_PI).plus(1.0);
        return Complex.ONE.minus(plane).times(loss).plus(plane);
    }
}
