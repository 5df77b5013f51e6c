package org.dronewatch.render.photo;

import org.dronewatch.geometry.Position;

/**
 * Irradiance of an unobstructed surface by the sky and the sunlit ground, as a function of its normal: nine
 * coefficients of spherical harmonics for each channel, which give the irradiance within a few percent (Ramamoorthi
 * and Hanrahan, "An efficient representation for irradiance environment maps", SIGGRAPH 2001). Immutable.
 */
final class AmbientLight {
    /** Fraction of the light that ordinary ground reflects. */
    static final double ALBEDO = 0.2;

    private static final int TERMS = 9;

    /** Irradiance over radiance by order, divided by pi. */
    private static final double[] ORDERS = {1.0, 2.0 / 3.0, 0.25};

    private final double[] coefficients = new double[TERMS * Daylight.CHANNELS];

    AmbientLight(Sky sky) {
        double[] rgb = new double[Daylight.CHANNELS];
        double[] terms = new double[TERMS];
        for (int step = 0; step < SkyDirections.STEPS; step++) {
            for (int around = 0; around < SkyDirections.AROUND; around++) {
                Position to = SkyDirections.upper(step, around);
                sky.radiance(to.x(), to.y(), to.z(), rgb);
                set(terms, to.x(), to.y(), to.z());
                add(terms, rgb);
                for (int i = 0; i < Daylight.CHANNELS; i++) {
                    rgb[i] = ALBEDO;
                }
                set(terms, to.x(), to.y(), -to.z());
                add(terms, rgb);
            }
        }
    }

    private void add(double[] terms, double[] rgb) {
        for (int term = 0; term < TERMS; term++) {
            double order = ORDERS[term == 0 ? 0 : term < 4 ? 1 : 2];
            for (int i = 0; i < Daylight.CHANNELS; i++) {
                coefficients[term * Daylight.CHANNELS + i] += order * terms[term] * rgb[i] * SkyDirections.SOLID_ANGLE;
            }
        }
    }

    private static void set(double[] terms, double x, double y, double z) {
        terms[0] = 0.282095;
        terms[1] = 0.488603 * y;
        terms[2] = 0.488603 * z;
        terms[3] = 0.488603 * x;
        terms[4] = 1.092548 * x * y;
        terms[5] = 1.092548 * y * z;
        terms[6] = 0.315392 * (3.0 * z * z - 1.0);
        terms[7] = 1.092548 * x * z;
        terms[8] = 0.546274 * (x * x - y * y);
    }

    /** Adds the irradiance of a surface to a colour, relative to the illuminance of level ground. */
    void addTo(double[] rgb, double weight, double[] normal, double[] terms) {
        set(terms, normal[0], normal[1], normal[2]);
        for (int i = 0; i < Daylight.CHANNELS; i++) {
            double sum = 0.0;
            for (int term = 0; term < TERMS; term++) {
                sum += coefficients[term * Daylight.CHANNELS + i] * terms[term];
            }
            rgb[i] += weight * Math.max(0.0, sum);
        }
    }

    /** Scratch memory for {@link #addTo}. */
    static double[] newTerms() {
        return new double[TERMS];
    }
}
