package org.dronewatch.sensor.radar;

import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/** A model of the backscatter of radar waves by the surface of a site. */
public sealed interface SurfaceReflectivity {
    /**
     * Radar cross-section of a part of the surface, m2.
     *
     * @param frequency carrier frequency, Hz
     * @param facing its visible area, projected onto a plane perpendicular to the line of sight, m2: the area times the
     *     sine of the grazing angle
     * @param cell area of the part of the resolution cell in which some of the surface is visible, m2
     */
    double crossSection(double frequency, double facing, double cell);

    /**
     * Constant gamma: {@code sigma0 = gamma sin(psi)}, where sigma0 is the radar cross-section per unit area of the
     * surface, psi the grazing angle, and gamma depends on the land cover. The figures hold at 10 GHz and increase with
     * the square root of the frequency (D. K. Barton, "Land clutter models for radar design and analysis", Proceedings
     * of the IEEE 73, 1985; as in MathWorks' {@code surfacegamma}).
     *
     * @param cover the land cover
     */
    record LandCover(Cover cover) implements SurfaceReflectivity {
        private static final double REFERENCE = 10e9;

        /**
         * A land cover, with gamma at 10 GHz. [N]: F. E. Nathanson, Radar Design Principles, 2nd edition 1999; [L]: M.
         * W. Long, Radar Reflectivity of Land and Sea, 3rd edition 2001; both as quoted by MathWorks'
         * {@code surfacegamma}.
         */
        public enum Cover {
            /** Flat land without trees: -20 dB [N]. */
            FLATLAND(-20.0),
            /** Fields and farms: -15 dB [N]. */
            FARMLAND(-15.0),
            /** Woods: -15 dB [L]. */
            WOODS(-15.0),
            /** Wooded hills: -10 dB [N]. */
            WOODED_HILLS(-10.0),
            /** A city: 0 dB [L]. */
            METROPOLITAN(0.0),
            /** Rugged mountains: 0 dB [L]. */
            MOUNTAINS(0.0);

            private final double gamma;

            Cover(double gamma) {
                this.gamma = gamma;
            }

            /** Gamma at 10 GHz, dB. */
            public double gamma() {
                return gamma;
            }
        }

        /**
         * Checks that there is a cover.
         *
         * @throws IllegalArgumentException when it is missing
         */
        public LandCover {
            Limits.check(LandCover.class, cover);
        }

        @Override
        public double crossSection(double frequency, double facing, double cell) {
            return Math.pow(10.0, 0.1 * cover.gamma()) * Math.sqrt(frequency / REFERENCE) * facing;
        }
    }

    /**
     * Constant gamma: {@code sigma0 = gamma sin(psi)}, where sigma0 is the radar cross-section per unit area of the
     * surface and psi the grazing angle.
     *
     * @param gamma gamma at the radar's frequency, -100 to 30 dB
     */
    record ConstantGamma(@In(value = Quantity.LEVEL, from = -100, to = 30) double gamma)
            implements SurfaceReflectivity {
        /**
         * Checks the limit.
         *
         * @throws IllegalArgumentException when it is out of range
         */
        public ConstantGamma {
            Limits.check(ConstantGamma.class, gamma);
        }

        @Override
        public double crossSection(double frequency, double facing, double cell) {
            return Math.pow(10.0, 0.1 * gamma) * facing;
        }
    }

    /**
     * A surface with the same sigma0 at all grazing angles.
     *
     * @param sigma0 radar cross-section per unit area of the surface at the radar's frequency, -100 to 30 dB
     */
    record ConstantSigma0(@In(value = Quantity.LEVEL, from = -100, to = 30) double sigma0)
            implements SurfaceReflectivity {
        /**
         * Checks the limit.
         *
         * @throws IllegalArgumentException when it is out of range
         */
        public ConstantSigma0 {
            Limits.check(ConstantSigma0.class, sigma0);
        }

        @Override
        public double crossSection(double frequency, double facing, double cell) {
            return Math.pow(10.0, 0.1 * sigma0) * cell;
        }
    }
}
