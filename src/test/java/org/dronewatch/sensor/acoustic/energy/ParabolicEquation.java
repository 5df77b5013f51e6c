package org.dronewatch.sensor.acoustic.energy;

import java.util.SplittableRandom;

/**
 * Sound over flat ground in air whose speed of sound changes linearly with height and which is turbulent: the
 * wide-angle parabolic equation by finite differences (Crank and Nicolson), one step of the range after another, with
 * the turbulence as phase screens (M. West, K. Gilbert and R. A. Sack, Applied Acoustics 37, 31, 1992; K. E. Gilbert,
 * R. Raspet and X. Di, JASA 87, 2428, 1990). It knows neither rays nor images nor shadows. Time goes as exp(-i w t).
 *
 * @param waveNumber 1/m
 * @param curvature of rays that bend up, 1/m
 * @param admittanceRe of the ground, relative to that of air
 * @param admittanceIm of the ground
 * @param strength variance of the refractive index, whose correlation is {@code exp(-r^2 / scale^2)}
 * @param scale m
 */
record ParabolicEquation(
        double waveNumber, double curvature, double admittanceRe, double admittanceIm, double strength, double scale) {
    /** Of a wavelength: from height to height, and from step to step. */
    private static final double FINE = 0.125;

    private static final double COARSE = 0.2;

    /** From one phase screen to the next, m. */
    private static final double SCREEN = 0.5;

    private static final int MODES = 80;

    /** Heights of the turbulence per height of the sound. */
    private static final int SPARSE = 8;

    /**
     * The energy at a height over that in the free field, at multiples of {@value #SCREEN} m, the mean over
     * realizations of the turbulence.
     *
     * @param source height, m
     * @param receiver height, m
     * @param distance up to which, m
     */
    double[] gains(double source, double receiver, double distance, int realizations, SplittableRandom random) {
        double[] gains = new double[(int) (distance / SCREEN)];
        for (int i = 0; i < realizations; i++) {
            new March(source, receiver, random).addTo(gains, 1.0 / realizations);
        }
        return gains;
    }

    static int index(double distance) {
        return (int) Math.round(distance / SCREEN) - 1;
    }

    /** One realization. */
    private final class March {
        private final double source;
        private final double receiver;
        private final double spacing;
        private final double step;
        private final int substeps;
        private final int top;
        private final double[] re;
        private final double[] im;
        private final double[] rightRe;
        private final double[] rightIm;

        /** The operator, and the factors of the implicit half of a step. */
        private final double[] mainRe;

        private final double[] mainIm;
        private final double[] factorRe;
        private final double[] factorIm;
        private final double[] inverseRe;
        private final double[] inverseIm;

        private final double[] along = new double[MODES];
        private final double[] up = new double[MODES];
        private final double[] phase = new double[MODES];
        private final double[] amplitude = new double[MODES];

        March(double source, double receiver, SplittableRandom random) {
            this.source = source;
            this.receiver = receiver;
            // The receiver is at one of the heights.
            spacing = receiver / Math.ceil(receiver / (FINE * 2 * Math.PI / waveNumber));
            double free = Math.max(source, receiver) + 13;
            top = (int) (1.5 * free / spacing);
            substeps = (int) Math.max(1, Math.round(SCREEN / (COARSE * 2 * Math.PI / waveNumber)));
            step = SCREEN / substeps;
            re = new double[top];
            im = new double[top];
            rightRe = new double[top];
            rightIm = new double[top];
            mainRe = new double[top];
            mainIm = new double[top];
            factorRe = new double[top];
            factorIm = new double[top];
            inverseRe = new double[top];
            inverseIm = new double[top];
            setOperator(free);
            factorize();
            drawTurbulence(random);
            start();
        }

        private double off(int row) {
            double square = waveNumber * spacing * waveNumber * spacing;
            return (row == 0 ? 2 : 1) / square;
        }

        private void setOperator(double free) {
            double square = waveNumber * spacing * waveNumber * spacing;
            for (int j = 0; j < top; j++) {
                double z = j * spacing;
                double index = 1 + curvature * Math.min(z, free);
                double beyond = Math.max(0, (z - free) / (top * spacing - free));
                mainRe[j] = index * index - 1 - 2 / square;
                mainIm[j] = 0.2 * beyond * beyond;
            }
            // The derivative at the ground is -i k admittance: the point below it is that above it less this.
            mainRe[0] -= 2 * waveNumber * spacing * admittanceIm / square;
            mainIm[0] += 2 * waveNumber * spacing * admittanceRe / square;
        }

        /** Elimination without exchange of rows of 1 + a s, with a = (1 - i k dx) / 4. */
        private void factorize() {
            double a = 0.25;
            double b = -0.25 * waveNumber * step;
            for (int j = 0; j < top; j++) {
                double dRe = 1 + a * mainRe[j] - b * mainIm[j];
                double dIm = a * mainIm[j] + b * mainRe[j];
                if (j > 0) {
                    double lowRe = a * off(1);
                    double lowIm = b * off(1);
                    factorRe[j] = lowRe * inverseRe[j - 1] - lowIm * inverseIm[j - 1];
                    factorIm[j] = lowRe * inverseIm[j - 1] + lowIm * inverseRe[j - 1];
                    double upRe = a * off(j - 1);
                    double upIm = b * off(j - 1);
                    dRe -= factorRe[j] * upRe - factorIm[j] * upIm;
                    dIm -= factorRe[j] * upIm + factorIm[j] * upRe;
                }
                double size = dRe * dRe + dIm * dIm;
                inverseRe[j] = dRe / size;
                inverseIm[j] = -dIm / size;
            }
        }

        /** Modes of random direction and phase, with the spectrum of the correlation in two dimensions. */
        private void drawTurbulence(SplittableRandom random) {
            double width = 6 / scale / MODES;
            for (int mode = 0; mode < MODES; mode++) {
                double wave = (mode + 0.5) * width;
                double angle = random.nextDouble(2 * Math.PI);
                along[mode] = wave * Math.cos(angle);
                up[mode] = wave * Math.sin(angle);
                phase[mode] = random.nextDouble(2 * Math.PI);
                amplitude[mode] =
                        Math.sqrt(strength * scale * scale * width * wave * Math.exp(-wave * wave * scale * scale / 4));
            }
        }

        /** Gaussian starter of second order (E. M. Salomons), and its image. */
        private void start() {
            double square = Math.pow(admittanceRe + 1, 2) + admittanceIm * admittanceIm;
            double imageRe = (1 - admittanceRe * admittanceRe - admittanceIm * admittanceIm) / square;
            double imageIm = -2 * admittanceIm / square;
            for (int j = 0; j < top; j++) {
                double image = starter(waveNumber * (j * spacing + source));
                re[j] = Math.sqrt(waveNumber) * (starter(waveNumber * (j * spacing - source)) + imageRe * image);
                im[j] = Math.sqrt(waveNumber) * imageIm * image;
            }
        }

        private double starter(double z) {
            return (1.3717 - 0.3701 * z * z) * Math.exp(-z * z / 3);
        }

        void addTo(double[] gains, double weight) {
            int at = (int) Math.round(receiver / spacing);
            for (int i = 0; i < gains.length; i++) {
                for (int substep = 0; substep < substeps; substep++) {
                    advance();
                }
                if (strength > 0) {
                    passScreen((i + 0.5) * SCREEN);
                }
                double range = (i + 1) * SCREEN;
                double spread = range * range + (source - receiver) * (source - receiver);
                gains[i] += weight * (re[at] * re[at] + im[at] * im[at]) / range * spread;
            }
        }

        /** A step: 1 + a s of the new field is 1 + b s of the old one, with b = (1 + i k dx) / 4. */
        private void advance() {
            double a = 0.25;
            double b = 0.25 * waveNumber * step;
            for (int j = 0; j < top; j++) {
                double sRe = mainRe[j] * re[j] - mainIm[j] * im[j];
                double sIm = mainRe[j] * im[j] + mainIm[j] * re[j];
                if (j > 0) {
                    sRe += off(1) * re[j - 1];
                    sIm += off(1) * im[j - 1];
                }
                if (j < top - 1) {
                    sRe += off(j) * re[j + 1];
                    sIm += off(j) * im[j + 1];
                }
                rightRe[j] = re[j] + a * sRe - b * sIm;
                rightIm[j] = im[j] + a * sIm + b * sRe;
                if (j > 0) {
                    rightRe[j] -= factorRe[j] * rightRe[j - 1] - factorIm[j] * rightIm[j - 1];
                    rightIm[j] -= factorRe[j] * rightIm[j - 1] + factorIm[j] * rightRe[j - 1];
                }
            }
            for (int j = top - 1; j >= 0; j--) {
                double leftRe = rightRe[j];
                double leftIm = rightIm[j];
                if (j < top - 1) {
                    leftRe -= off(j) * (a * re[j + 1] + b * im[j + 1]);
                    leftIm -= off(j) * (a * im[j + 1] - b * re[j + 1]);
                }
                re[j] = leftRe * inverseRe[j] - leftIm * inverseIm[j];
                im[j] = leftRe * inverseIm[j] + leftIm * inverseRe[j];
            }
        }

        private void passScreen(double range) {
            double before = index(range, 0);
            for (int from = 0; from < top; from += SPARSE) {
                double after = index(range, from + SPARSE);
                for (int j = from; j < Math.min(top, from + SPARSE); j++) {
                    double turn = waveNumber * SCREEN * (before + (after - before) * (j - from) / SPARSE);
                    double cos = Math.cos(turn);
                    double sin = Math.sin(turn);
                    double was = re[j];
                    re[j] = cos * was - sin * im[j];
                    im[j] = sin * was + cos * im[j];
                }
                before = after;
            }
        }

        /** What turbulence adds to the refractive index. */
        private double index(double range, int row) {
            double sum = 0;
            for (int mode = 0; mode < MODES; mode++) {
                sum += amplitude[mode] * Math.cos(along[mode] * range + up[mode] * row * spacing + phase[mode]);
            }
            return sum;
        }
    }
}
