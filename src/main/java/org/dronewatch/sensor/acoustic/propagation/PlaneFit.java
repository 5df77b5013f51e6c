package org.dronewatch.sensor.acoustic.propagation;

/** The plane {@code z = level + slopeU u + slopeV v} that fits points best, by least squares of z. One per thread. */
final class PlaneFit {
    /** Of points on one line there is no plane: the least square of the sine between their directions. */
    private static final double FLATTEST = 1e-9;

    private final double[] us;
    private final double[] vs;
    private final double[] zs;
    private int count;
    private double level;
    private double slopeU;
    private double slopeV;

    /** A fit to a number of points at most. */
    PlaneFit(int most) {
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

    /** Fits the plane to the points; gives false if they are on one line. */
    boolean fit() {
        double meanU = mean(us);
        double meanV = mean(vs);
        double meanZ = mean(zs);
        double uu = 0.0;
        double uv = 0.0;
        double vv = 0.0;
        double uz = 0.0;
        double vz = 0.0;
        for (int i = 0; i < count; i++) {
            double u = us[i] - meanU;
            double v = vs[i] - meanV;
            double z = zs[i] - meanZ;
            uu += u * u;
            uv += u * v;
            vv += v * v;
            uz += u * z;
            vz += v * z;
        }
        double determinant = uu * vv - uv * uv;
        if (!(determinant > FLATTEST * uu * vv)) {
            return false;
        }
        slopeU = (uz * vv - vz * uv) / determinant;
        slopeV = (vz * uu - uz * uv) / determinant;
        level = meanZ - slopeU * meanU - slopeV * meanV;
        return true;
    }

    private double mean(double[] values) {
        double sum = 0.0;
        for (int i = 0; i < count; i++) {
            sum += values[i];
        }
        return sum / count;
    }

    double level() {
        return level;
    }

    double slopeU() {
        return slopeU;
    }

    double slopeV() {
        return slopeV;
    }

    /** Root of the mean square of the points' distances from the plane. */
    double standardDeviation() {
        double squares = 0.0;
        for (int i = 0; i < count; i++) {
            double off = zs[i] - level - slopeU * us[i] - slopeV * vs[i];
            squares += off * off;
        }
        return Math.sqrt(squares / count / (1.0 + slopeU * slopeU + slopeV * slopeV));
    }
}
