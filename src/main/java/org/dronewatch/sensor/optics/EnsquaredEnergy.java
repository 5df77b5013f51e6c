package org.dronewatch.sensor.optics;

/**
 * The fraction of the light of a point that falls on the pixel on whose centre the point is imaged; lens and air spread
 * the rest over the neighbouring pixels. The image of the point and a square pixel are integrated over spatial
 * frequency, where both are known:
 *
 * <pre>
 * integral M(f) sinc(fx) sinc(fy) dfx dfy,  f = sqrt(fx^2 + fy^2) in cycles per pixel, sinc(x) = sin(pi x) / (pi x)
 * </pre>
 *
 * <p>Since M depends on f only, the sincs are averaged over all directions once and for all.
 */
final class EnsquaredEnergy {
    private static final double STEP = 0.02;

    /** The number of steps in frequency, up to 50 cycles per pixel: the contribution of finer detail is below 0.01. */
    private static final int STEPS = 2500;

    /** The number of directions over an eighth of a turn; the rest follows by symmetry. */
    private static final int DIRECTIONS = 128;

    /** Detail whose transfer is below this is ignored. */
    private static final double NOTHING = 1e-9;

    /** For each ring of frequencies, the sincs summed over it. */
    private static final double[] PIXEL = pixel();

    private EnsquaredEnergy() {}

    /**
     * The fraction of a point's light that falls on its pixel.
     *
     * @param transfer modulation transfer of lens and air
     * @param focalLength focal length, pixels
     * @return 0 to 1
     */
    static double of(ImageTransfer transfer, double focalLength) {
        double sum = 0.0;
        for (int i = 0; i < STEPS; i++) {
            double left = transfer.transfer(frequency(i) * focalLength);
            if (left < NOTHING) {
                break;
            }
            sum += left * PIXEL[i];
        }
        return Math.max(0.0, Math.min(1.0, sum));
    }

    private static double frequency(int step) {
        return (step + 0.5) * STEP;
    }

    private static double[] pixel() {
        double[] rings = new double[STEPS];
        for (int i = 0; i < STEPS; i++) {
            double frequency = frequency(i);
            double mean = 0.0;
            for (int j = 0; j < DIRECTIONS; j++) {
                double angle = (j + 0.5) * Math.PI / 4.0 / DIRECTIONS;
                mean += sinc(frequency * Math.cos(angle)) * sinc(frequency * Math.sin(angle)) / DIRECTIONS;
            }
            rings[i] = 2.0 * Math.PI * frequency * STEP * mean;
        }
        return rings;
    }

    private static double sinc(double x) {
        return x == 0.0 ? 1.0 : Math.sin(Math.PI * x) / (Math.PI * x);
    }
}
