package org.dronewatch.sensor.optics;

/**
 * The modulation transfer of a lens and of the air, and the finest detail that a camera resolves with them.
 *
 * @param lens lens of the camera
 * @param air turbulence of the air between the lens and the target
 */
public record ImageTransfer(Lens lens, Turbulence air) {
    /** Number of halvings of the interval, which is then no wider than the rounding error of a double. */
    private static final int HALVINGS = 53;

    /**
     * The transfer through a lens and turbulent air.
     *
     * @param structure refractive-index structure constant Cn2 of the air, 0 or more, m^(-2/3)
     * @param range range of the target, m
     */
    public static ImageTransfer through(Lens lens, double structure, double range) {
        return new ImageTransfer(lens, Turbulence.of(structure, lens.wavelength(), range));
    }

    /** Whether neither the lens nor the air blurs the image. */
    private boolean isPerfect() {
        return lens.aperture().isEmpty() && Double.isInfinite(air.coherenceDiameter());
    }

    /**
     * The modulation transfer for a pattern: the product of the transfer functions of the lens and the air.
     *
     * @param frequency frequency of the pattern, 0 or more, cycles per radian
     * @return 0 to 1
     */
    public double transfer(double frequency) {
        return lens.transfer(frequency) * air.transfer(frequency);
    }

    /**
     * For a point imaged on the centre of a pixel, the fraction of its light or heat that this pixel receives; blur
     * spreads the rest over its neighbours.
     *
     * @param focalLength focal length, pixels
     * @return 0 to 1; 1 without blur, otherwise accurate to about 0.01
     */
    public double ensquaredEnergy(double focalLength) {
        return isPerfect() ? 1.0 : EnsquaredEnergy.of(this, focalLength);
    }

    /**
     * The highest spatial frequency that a camera resolves, as a fraction u of the Nyquist frequency of its pixels (one
     * line pair per two pixels). Without blur, a pattern at the fraction u requires the contrast
     * {@code needed / (1 - u)}: a straight line in place of the measured curve of minimum resolvable contrast. Patterns
     * are resolved up to the frequency at which the remaining contrast, {@code seen * transfer}, falls to the required
     * contrast, as when Johnson's criteria are applied with a measured curve (Ratches, "Static performance model for
     * thermal imaging systems", Optical Engineering 15, 525, 1976). Without blur, u is {@code 1 - needed / seen}.
     *
     * @param needed the least contrast, or signal-to-noise ratio, at which anything is resolved, above 0
     * @param seen contrast, or signal-to-noise ratio, of a large object of the same kind, 0 or more
     * @param focalLength focal length, pixels
     * @return 0 to 1; 0 when nothing is resolved
     */
    public double resolved(double needed, double seen, double focalLength) {
        if (!(seen > needed)) {
            return 0.0;
        }
        double unblurred = 1.0 - needed / seen;
        if (isPerfect()) {
            return unblurred;
        }
        double finest = 0.5 * focalLength;
        double low = 0.0;
        double high = unblurred;
        for (int i = 0; i < HALVINGS; i++) {
            double middle = 0.5 * (low + high);
            if (seen * transfer(finest * middle) * (1.0 - middle) >= needed) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }
}
