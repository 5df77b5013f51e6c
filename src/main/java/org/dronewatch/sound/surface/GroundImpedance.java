package org.dronewatch.sound.surface;

/**
 * The acoustic impedance of ground from one number, its effective flow resistivity sigma, by the fit of M. E. Delany
 * and E. N. Bazley (Applied Acoustics 3, 105, 1970): {@code Z = 1 + 9.08 X^-0.75 + i 11.9 X^-0.73}, relative to that of
 * air, with {@code X = f / sigma}, the frequency f in Hz, sigma in kPa s/m2, and the time dependence
 * {@code exp(-i w t)} at the angular frequency w. For ground, the fit is used at values of X far below those of the
 * fibrous absorbents to which it was fitted, with a sigma that was itself fitted to sound measured over that ground (T.
 * F. W. Embleton, J. E. Piercy and G. A. Daigle, JASA 74, 1239, 1983).
 *
 * @param flowResistivity sigma, kPa s/m2, above 0; infinite for rigid ground
 */
public record GroundImpedance(double flowResistivity) {
    /** Rigid ground, which reflects everything in phase. */
    public static final GroundImpedance RIGID = new GroundImpedance(Double.POSITIVE_INFINITY);

    /**
     * Checks the limit.
     *
     * @throws IllegalArgumentException when the flow resistivity is not above 0
     */
    public GroundImpedance {
        if (!(flowResistivity > 0.0)) {
            throw new IllegalArgumentException("flow resistivity " + flowResistivity + " kPa s/m2 must be above 0");
        }
    }

    /** Whether this ground reflects everything. */
    public boolean isRigid() {
        return flowResistivity == Double.POSITIVE_INFINITY;
    }

    /** The admittance, one over the impedance, relative to that of air; 0 for rigid ground. */
    Complex admittance(double frequency) {
        double x = frequency / flowResistivity;
        if (x == 0.0) {
            return new Complex(0.0, 0.0);
        }
        return Complex.ONE.over(new Complex(1.0 + 9.08 * Math.pow(x, -0.75), 11.9 * Math.pow(x, -0.73)));
    }
}
