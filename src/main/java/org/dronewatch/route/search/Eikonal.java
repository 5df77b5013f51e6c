package org.dronewatch.route.search;

/**
 * One simplex of {@link CubePaths}, with values at its corners in the order of its path. Successive edges are
 * perpendicular, so that a linear function's gradient has a component along each. Scratch memory of one thread.
 */
final class Eikonal {
    /** Values at the corners along the path. */
    final double[] values;

    /** The squared lengths of the edges up to each corner. */
    final double[] along;

    Eikonal(int dimensions) {
        this.values = new double[dimensions + 1];
        this.along = new double[dimensions + 1];
    }

    /** The square of the gradient's length. */
    double gradientSquared() {
        double sum = 0.0;
        for (int i = 1; i < values.length; i++) {
            double rise = values[i] - values[i - 1];
            sum += rise * rise / (along[i] - along[i - 1]);
        }
        return sum;
    }

    /**
     * The least value with which a corner is reached straight through the simplex, {@code min over the points y of the
     * opposite face (value at y + slope |corner - y|)}; infinite if no other corner is lower.
     *
     * @param slope squared
     */
    double arrival(int corner, double slope) {
        double least = Double.POSITIVE_INFINITY;
        int lower = 0;
        for (int i = 0; i < values.length; i++) {
            lower |= values[i] < values[corner] ? 1 << i : 0;
        }
        for (int face = lower; face > 0; face = face - 1 & lower) {
            least = Math.min(least, arrival(corner, face, slope));
        }
        return least;
    }

    /** The same through the inside of a face, given by the bits of its corners; infinite if the line misses it. */
    private double arrival(int corner, int face, double slope) {
        int before = -1;
        int after = -1;
        int last = -1;
        double others = 0.0;
        for (int i = 0; i < values.length; i++) {
            if ((face >> i & 1) == 0) {
                continue;
            }
            if (last >= 0 && (i < corner || last > corner)) {
                double rise = values[i] - values[last];
                others += rise * rise / (along[i] - along[last]);
            }
            before = i < corner ? i : before;
            after = i > corner && after < 0 ? i : after;
            last = i;
        }
        if (others > slope) {
            return Double.POSITIVE_INFINITY;
        }
        double value = solve(corner, before, after, slope - others);
        return isInside(corner, face, value) ? value : Double.POSITIVE_INFINITY;
    }

    /**
     * Whether the steepest descent from a corner leads into the simplex of that corner and a face: along the path, the
     * components of the gradient ascend from 0 up to the corner, and to 0 behind it.
     */
    private boolean isInside(int corner, int face, double value) {
        int last = -1;
        double component = 0.0;
        for (int i = 0; i < values.length; i++) {
            if (i != corner && (face >> i & 1) == 0) {
                continue;
            }
            if (last >= 0) {
                double rise = (i == corner ? value : values[i]) - (last == corner ? value : values[last]);
                double next = rise / (along[i] - along[last]);
                boolean isAscending = last == corner || next >= component;
                if (!isAscending || i > corner && next > 0.0) {
                    return false;
                }
                component = next;
            }
            last = i;
        }
        return true;
    }

    /** The largest value with {@code sum (value - known)^2 / edge^2 = left} over the one or two nearest corners. */
    private double solve(int corner, int before, int after, double left) {
        if (before < 0 || after < 0) {
            int known = before < 0 ? after : before;
            return values[known] + Math.sqrt(left * Math.abs(along[corner] - along[known]));
        }
        double first = along[corner] - along[before];
        double second = along[after] - along[corner];
        double rise = values[after] - values[before];
        // Measured from the corner before, so that no digits are lost between large values.
        double middle = rise * first / (first + second);
        double square = (left - rise * rise / (first + second)) * first * second / (first + second);
        return square < 0.0 ? Double.POSITIVE_INFINITY : values[before] + middle + Math.sqrt(square);
    }
}
