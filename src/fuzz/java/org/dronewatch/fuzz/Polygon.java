package org.dronewatch.fuzz;

/** A polygon in space, measured in a simple way. */
final class Polygon {
    /** More corners are not searched for crossings of sides. */
    private static final int MOST_SEARCHED = 300;

    private static final double FLAT = 1e-6;
    private static final double LEAST_SHARE = 1e-9;

    private final double[][] corners;
    private final double[] normal;

    Polygon(double[][] corners) {
        this.corners = corners;
        this.normal = newell(corners);
    }

    /**
     * Newell's sum: the normal, as long as twice the area. Taken from the first corner, so that it keeps its digits.
     */
    private static double[] newell(double[][] corners) {
        double[] sum = new double[3];
        double[] first = corners[0];
        for (int i = 0; i < corners.length; i++) {
            double[] a = corners[i];
            double[] b = corners[(i + 1) % corners.length];
            for (int k = 0; k < 3; k++) {
                int l = (k + 1) % 3;
                int m = (k + 2) % 3;
                sum[k] += (a[l] - first[l]) * (b[m] - first[m]) - (a[m] - first[m]) * (b[l] - first[l]);
            }
        }
        return sum;
    }

    boolean isTriangle() {
        return corners.length == 3;
    }

    boolean isConcave() {
        return !isTriangle() && !isConvex();
    }

    double area() {
        return 0.5 * length(normal);
    }

    double low(int axis) {
        double low = Double.MAX_VALUE;
        for (double[] corner : corners) {
            low = Math.min(low, corner[axis]);
        }
        return low;
    }

    double high(int axis) {
        double high = -Double.MAX_VALUE;
        for (double[] corner : corners) {
            high = Math.max(high, corner[axis]);
        }
        return high;
    }

    /**
     * Whether its area and its extent are beyond doubt: flat, without crossings, and not so thin that rounding decides.
     */
    boolean isPlain() {
        double size = Math.max(high(0) - low(0), Math.max(high(1) - low(1), high(2) - low(2)));
        if (length(normal) < LEAST_SHARE * size * size) {
            return false;
        }
        return isTriangle() || isFlat(size) && (isConvex() || corners.length <= MOST_SEARCHED && isSimple());
    }

    private boolean isFlat(double size) {
        double length = length(normal);
        for (double[] corner : corners) {
            double height = 0;
            for (int k = 0; k < 3; k++) {
                height += normal[k] / length * (corner[k] - corners[0][k]);
            }
            if (Math.abs(height) > FLAT * size) {
                return false;
            }
        }
        return true;
    }

    /** All corners turn to the same side, once round. */
    private boolean isConvex() {
        int axis = mainAxis();
        double turned = 0;
        for (int i = 0; i < corners.length; i++) {
            double[] a = across(i, axis);
            double[] b = across(i + 1, axis);
            double turn = Math.atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
            if (turn * Math.signum(normal[axis]) <= 0) {
                return false;
            }
            turned += Math.abs(turn);
        }
        return Math.abs(turned - 2 * Math.PI) < 1e-3;
    }

    /** A side, seen along an axis. */
    private double[] across(int side, int axis) {
        double[] a = corners[side % corners.length];
        double[] b = corners[(side + 1) % corners.length];
        int l = (axis + 1) % 3;
        int m = (axis + 2) % 3;
        return new double[] {b[l] - a[l], b[m] - a[m]};
    }

    private int mainAxis() {
        int axis = Math.abs(normal[0]) > Math.abs(normal[1]) ? 0 : 1;
        return Math.abs(normal[axis]) > Math.abs(normal[2]) ? axis : 2;
    }

    /** No two sides touch that are not neighbours, and no neighbours fold back. */
    private boolean isSimple() {
        int n = corners.length;
        int axis = mainAxis();
        for (int i = 0; i < n; i++) {
            double[] a = across(i, axis);
            double[] b = across(i + 1, axis);
            boolean foldsBack = a[0] * b[1] - a[1] * b[0] == 0 && a[0] * b[0] + a[1] * b[1] <= 0;
            if (foldsBack) {
                return false;
            }
            for (int k = i + 2; k < n; k++) {
                if ((k + 1) % n != i && touch(i, k, axis)) {
                    return false;
                }
            }
        }
        return true;
    }

    private boolean touch(int first, int second, int axis) {
        int l = (axis + 1) % 3;
        int m = (axis + 2) % 3;
        double[] p = corners[first];
        double[] q = corners[second];
        double[] a = across(first, axis);
        double[] b = across(second, axis);
        double[] between = {q[l] - p[l], q[m] - p[m]};
        double across = a[0] * b[1] - a[1] * b[0];
        if (across == 0) {
            // Parallel sides touch only if they are on one line; then the result is left open.
            return a[0] * between[1] - a[1] * between[0] == 0;
        }
        double s = (between[0] * b[1] - between[1] * b[0]) / across;
        double t = (between[0] * a[1] - between[1] * a[0]) / across;
        return s >= -FLAT && s <= 1 + FLAT && t >= -FLAT && t <= 1 + FLAT;
    }

    private static double length(double[] v) {
        return Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
}
