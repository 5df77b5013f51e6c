package org.dronewatch.sensor.acoustic.propagation;

import java.util.Arrays;

/**
 * The surface {@code z = level + slopeU u + slopeV v + bend u^2} that best fits given points, by least squares of z: a
 * plane or, if that fits better, a surface that is convex along u. For use by one thread.
 */
final class SurfaceFit {
    private static final int PLANE = 3;
    private static final int BENT = 4;

    /** The least pivot, as a fraction of the largest one: points on one line do not determine a plane. */
    private static final double SINGULAR = 1e-9;

    private final double[] us;
    private final double[] vs;
    private final double[] zs;
    private final double[][] equations = new double[BENT][BENT + 1];
    private final double[] terms = new double[BENT];
    private final double[] factors = new double[BENT];
    private int count;
    private double middleU;
    private double middleZ;
    private double scaleU;
    private double middleV;
    private double scaleV;

    /** A fit to at most this many points. */
    SurfaceFit(int most) {
        this.us = new double[most];
        this.vs = new double[most];
        this.zs = new double[most];
    }

    void clear() {
        count = 0;
    }

    void add(double u, double v, double z) {
        us[count] = u;
        vs[count] = v;
        zs[count] = z;
        count++;
    }

    int count() {
        return count;
    }

    /**
     * Fits the surface to the points.
     *
     * @param fromU beginning of the interval of u
     * @param toU end of the interval of u
     * @param midV middle of the interval of v
     * @param halfV half the length of the interval of v
     * @return false if the points are on one line
     */
    boolean fit(double fromU, double toU, double midV, double halfV) {
        middleU = 0.5 * (fromU + toU);
        scaleU = 0.5 * (toU - fromU);
        middleV = midV;
        scaleV = halfV;
        middleZ = zs[0];
        return solve(BENT) && factors[BENT - 1] < 0.0 || solve(PLANE);
    }

    /** Solves the normal equations, in numbers of the order of one, by elimination. */
    private boolean solve(int unknowns) {
        for (double[] equation : equations) {
            Arrays.fill(equation, 0.0);
        }
        for (int i = 0; i < count; i++) {
            setTerms(us[i], vs[i]);
            for (int row = 0; row < unknowns; row++) {
                for (int column = 0; column < unknowns; column++) {
                    equations[row][column] += terms[row] * terms[column];
                }
                equations[row][unknowns] += terms[row] * (zs[i] - middleZ);
            }
        }
        for (int pivot = 0; pivot < unknowns; pivot++) {
            // A matrix of sums of squares needs no exchange of rows for elimination.
            if (!(equations[pivot][pivot] > SINGULAR * count)) {
                return false;
            }
            for (int row = pivot + 1; row < unknowns; row++) {
                double factor = equations[row][pivot] / equations[pivot][pivot];
                for (int column = pivot; column <= unknowns; column++) {
                    equations[row][column] -= factor * equations[pivot][column];
                }
            }
        }
        Arrays.fill(factors, 0.0);
        for (int row = unknowns - 1; row >= 0; row--) {
            double rest = equations[row][unknowns];
            for (int column = row + 1; column < unknowns; column++) {
                rest -= equations[row][column] * factors[column];
            }
            factors[row] = rest / equations[row][row];
        }
        return true;
    }

    private void setTerms(double u, double v) {
        double scaled = (u - middleU) / scaleU;
        terms[0] = 1.0;
        terms[1] = scaled;
        terms[2] = (v - middleV) / scaleV;
        terms[3] = scaled * scaled;
    }

    /** The surface's height. */
    double z(double u, double v) {
        setTerms(u, v);
        double sum = middleZ;
        for (int i = 0; i < BENT; i++) {
            sum += factors[i] * terms[i];
        }
        return sum;
    }

    /** Slope of the surface along u. */
    double slopeU(double u) {
        return (factors[1] + 2.0 * factors[3] * (u - middleU) / scaleU) / scaleU;
    }

    /** Slope of the surface along v. */
    double slopeV() {
        return factors[2] / scaleV;
    }

    /** Root of the mean square of the points' distances from the surface. */
    double standardDeviation() {
        double squares = 0.0;
        for (int i = 0; i < count; i++) {
            double off = zs[i] - z(us[i], vs[i]);
            double slope = slopeU(us[i]);
            squares += off * off / (1.0 + slope * slope + slopeV() * slopeV());
        }
        return Math.sqrt(squares / count);
    }
}
