package org.dronewatch.sensor.radar;

import org.dronewatch.setting.Check;
import org.dronewatch.setting.Quantity;

/** Attenuation of a wave by rain (Recommendation ITU-R P.838-3, 2005), and backscatter by rain. */
public final class Rain {
    private static final double LEAST_FREQUENCY = 1e9;
    private static final double MAX_FREQUENCY = 1000e9;

    private static final Fit K_HORIZONTAL = new Fit(
            new double[] {-5.33980, -0.35351, -0.23789, -0.94158},
            new double[] {-0.10008, 1.26970, 0.86036, 0.64552},
            new double[] {1.13098, 0.45400, 0.15354, 0.16817},
            -0.18961,
            0.71147);
    private static final Fit K_VERTICAL = new Fit(
            new double[] {-3.80595, -3.44965, -0.39902, 0.50167},
            new double[] {0.56934, -0.22911, 0.73042, 1.07319},
            new double[] {0.81061, 0.51059, 0.11899, 0.27195},
            -0.16398,
            0.63297);
    private static final Fit ALPHA_HORIZONTAL = new Fit(
            new double[] {-0.14318, 0.29591, 0.32177, -5.37610, 16.1721},
            new double[] {1.82442, 0.77564, 0.63773, -0.96230, -3.29980},
            new double[] {-0.55187, 0.19822, 0.13164, 1.47828, 3.43990},
            0.67849,
            -1.95537);
    private static final Fit ALPHA_VERTICAL = new Fit(
            new double[] {-0.07771, 0.56727, -0.20238, -48.2991, 48.5833},
            new double[] {2.33840, 0.95545, 1.14520, 0.791669, 0.791459},
            new double[] {-0.76284, 0.54039, 0.26809, 0.116226, 0.116479},
            -0.053739,
            0.83433);

    /** The dielectric factor of water, squared. */
    private static final double WATER = 0.93;

    private Rain() {}

    /** Polarisation of the wave. */
    public enum Polarisation {
        /** Horizontal. */
        HORIZONTAL(0.0),
        /** Vertical. */
        VERTICAL(0.5 * Math.PI),
        /** Circular. */
        CIRCULAR(0.25 * Math.PI);

        private final double tilt;

        Polarisation(double tilt) {
            this.tilt = tilt;
        }
    }

    /**
     * Specific attenuation, one way, dB/m.
     *
     * @param frequency carrier frequency, 1e9 to 1e12 Hz (1 to 1000 GHz)
     * @param rate rain rate, 0 or more, mm/h
     * @param elevation elevation of the path above the horizon, rad
     * @throws IllegalArgumentException when the frequency is outside its limits
     */
    public static double attenuation(double frequency, double rate, double elevation, Polarisation polarisation) {
        Check.between("frequency", frequency, LEAST_FREQUENCY, MAX_FREQUENCY, Quantity.FREQUENCY);
        if (rate == 0.0) {
            return 0.0;
        }
        double x = Math.log10(1e-9 * frequency);
        double kh = Math.pow(10.0, K_HORIZONTAL.at(x));
        double kv = Math.pow(10.0, K_VERTICAL.at(x));
        double ah = ALPHA_HORIZONTAL.at(x);
        double av = ALPHA_VERTICAL.at(x);
        double mix = Math.pow(Math.cos(elevation), 2) * Math.cos(2.0 * polarisation.tilt);
        double k = 0.5 * (kh + kv + (kh - kv) * mix);
        double alpha = (kh * ah + kv * av + (kh * ah - kv * av) * mix) / (2.0 * k);
        return 1e-3 * k * Math.pow(rate, alpha);
    }

    /**
     * Radar cross-section per unit volume, m2/m3: {@code pi^5 |K|^2 Z / lambda^4} for drops that are small compared
     * with the wavelength lambda, where the dielectric factor of water is {@code |K|^2 = 0.93} and the reflectivity
     * factor at a rain rate of R mm/h is {@code Z = 200 R^1.6 mm6/m3} (J. S. Marshall, W. Mc K. Palmer, Journal of
     * Meteorology 5, 1948; D. K. Barton, S. A. Leonov, Radar Technology Encyclopedia, "clutter, rain"). Compared with
     * Mie sums over the drop-size distribution of Marshall and Palmer, the error is at most 3.2 dB from 5.6 to 35 GHz
     * and 1 to 25 mm/h; at millimetre wavelengths the cross-section is far too high.
     *
     * @param frequency carrier frequency, Hz
     * @param rate rain rate, 0 or more, mm/h
     */
    public static double reflectivity(double frequency, double rate) {
        double wavelength = LinkBudget.LIGHT / frequency;
        double z = 1e-18 * 200.0 * Math.pow(rate, 1.6);
        return Math.pow(Math.PI, 5) * WATER * z / (wavelength * wavelength * wavelength * wavelength);
    }

    /**
     * Equations (2) and (3): the sum of a straight line and Gaussian curves in the logarithm of the frequency in GHz.
     */
    private record Fit(double[] heights, double[] centres, double[] widths, double slope, double constant) {
        double at(double x) {
            double sum = slope * x + constant;
            for (int j = 0; j < heights.length; j++) {
                double off = (x - centres[j]) / widths[j];
                sum += heights[j] * Math.exp(-off * off);
            }
            return sum;
        }
    }
}
