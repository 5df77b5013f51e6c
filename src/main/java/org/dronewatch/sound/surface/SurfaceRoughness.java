package org.dronewatch.sound.surface;

/**
 * The fraction of the reflected energy that a rough surface scatters, as a function of the angle of incidence.
 * Materials state it for a diffuse field (ISO 17497-1); at grazing incidence a rough surface acts as a mirror
 * (Rayleigh's criterion).
 */
public final class SurfaceRoughness {
    private static final int HALVINGS = 50;
    private static final double ROUGHEST = 1e3;

    private SurfaceRoughness() {}

    /**
     * The fraction that is scattered: {@code min(s, 1 - exp(-g cos^2 t))}, where s is the given fraction, t the angle
     * of incidence, and g the roughness parameter for which the mean of {@code 1 - exp(-g cos^2 t)} in a diffuse field,
     * {@code 1 - (1 - exp(-g)) / g}, is s. The cap at s takes effect near normal incidence.
     *
     * @param randomIncidence fraction s that is scattered in a diffuse field, 0 to 1
     * @param cosine cosine of the angle of incidence, from the normal, 0 to 1
     */
    public static double scattered(double randomIncidence, double cosine) {
        if (randomIncidence == 0.0) {
            return 0.0;
        }
        double low = 0.0;
        double high = ROUGHEST;
        for (int i = 0; i < HALVINGS; i++) {
            double middle = 0.5 * (low + high);
            if (mean(middle) < randomIncidence) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return Math.min(randomIncidence, -Math.expm1(-high * cosine * cosine));
    }

    private static double mean(double g) {
        return 1.0 + Math.expm1(-g) / g;
    }
}
