package org.dronewatch.route.search;

import java.util.Arrays;
import java.util.BitSet;
import org.dronewatch.parallel.Workers;

/**
 * A certified lower bound on the exposure along all routes to the goals, not only of those over nodes. A function of
 * the position that is 0 at the goals, and whose gradient nowhere exceeds the least exposure per metre, is such a
 * bound, since along any route it falls by no more than the exposure. Here it is linear on the simplices of
 * {@link CubePaths}, in coordinates in which the third is the height above the ground, and the least exposure is that
 * of a whole cube, all headings and all modes; limits on turns and climbs are left out, which only lowers the bound.
 *
 * <p>Gauss-Seidel sweeps in all orders (H. Zhao, Mathematics of Computation 74, 2005) give the function up to small
 * excesses of the gradient, mostly at corners of the field. Its values are then compressed, level by level, by the
 * greatest excess there, which makes the bound strict however far the sweeps have come. For use by one thread.
 */
final class ExposureBound {
    private static final int ROUNDS = 30;
    private static final double CONVERGED = 1e-7;
    private static final int BINS = 20_000;

    /** Against rounding in the sums of this class. */
    private static final double SAFETY = 1.0 - 1e-9;

    private final RouteGrid grid;
    private final int[][] orders;
    private final int[] strides;

    private final CubeSlopes cubes;

    /** By cube: whether a corner has changed since its simplices were last looked at. */
    private final boolean[] isActive;

    private final double[] values;
    private final Eikonal simplex;
    private final int[] corners;

    private ExposureBound(RouteProblem problem, BitSet goals) {
        this.grid = problem.grid();
        int dimensions = grid.levels() > 1 ? 3 : 2;
        this.orders = CubePaths.orders(dimensions);
        this.strides = new int[] {1, grid.columns(), grid.columns() * grid.rows()};
        this.cubes = new CubeSlopes(problem);
        this.isActive = new boolean[cubes.size()];
        this.values = new double[grid.size()];
        this.simplex = new Eikonal(dimensions);
        this.corners = new int[dimensions + 1];
        Arrays.fill(values, Double.POSITIVE_INFINITY);
        goals.stream().forEach(node -> values[node] = 0.0);
        for (int cube = 0; cube < isActive.length; cube++) {
            isActive[cube] = !cubes.isSolid(cube);
        }
    }

    /**
     * Computes the bound.
     *
     * @param goals the nodes of all cubes in which a route may end
     */
    static ExposureBound of(RouteProblem problem, BitSet goals) {
        ExposureBound bound = new ExposureBound(problem, goals);
        bound.sweep();
        return bound;
    }

    private void sweep() {
        int directions = 1 << simplex.values.length - 1;
        boolean isChanged = true;
        for (int round = 0; isChanged && round < ROUNDS; round++) {
            isChanged = false;
            for (int direction = 0; direction < directions; direction++) {
                Workers.checkInterrupted();
                isChanged |= sweep(direction);
            }
        }
    }

    /** One pass over all active cubes; returns whether there was one. */
    private boolean sweep(int direction) {
        boolean isChanged = false;
        for (int k = 0; k < cubes.levels(); k++) {
            int level = (direction & 4) == 0 ? k : cubes.levels() - 1 - k;
            for (int j = 0; j < cubes.rows(); j++) {
                int row = (direction & 2) == 0 ? j : cubes.rows() - 1 - j;
                for (int i = 0; i < cubes.columns(); i++) {
                    int column = (direction & 1) == 0 ? i : cubes.columns() - 1 - i;
                    int cube = cubes.cube(column, row, level);
                    if (isActive[cube]) {
                        isActive[cube] = false;
                        relax(column, row, level, cubes.squared(cube));
                        isChanged = true;
                    }
                }
            }
        }
        return isChanged;
    }

    /** Lowers the corners of a cube to the values with which they are reached through it. */
    private void relax(int column, int row, int level, double bound) {
        for (int[] order : orders) {
            walk(order, column, row, level);
            for (int corner = 0; corner < corners.length; corner++) {
                double now = simplex.values[corner];
                double arrival = simplex.arrival(corner, bound);
                if (arrival < now) {
                    simplex.values[corner] = arrival;
                    values[corners[corner]] = arrival;
                    if (arrival < (1.0 - CONVERGED) * now) {
                        activate(corners[corner]);
                    }
                }
            }
        }
    }

    /** Marks all cubes at a node, except for solid ones. */
    private void activate(int node) {
        int column = node % grid.columns();
        int row = node / grid.columns() % grid.rows();
        int level = node / (grid.columns() * grid.rows());
        for (int k = Math.max(0, level - 1); k <= Math.min(cubes.levels() - 1, level); k++) {
            for (int j = Math.max(0, row - 1); j <= Math.min(cubes.rows() - 1, row); j++) {
                for (int i = Math.max(0, column - 1); i <= Math.min(cubes.columns() - 1, column); i++) {
                    int cube = cubes.cube(i, j, k);
                    isActive[cube] = !cubes.isSolid(cube);
                }
            }
        }
    }

    /** Loads one simplex of a cube. */
    private void walk(int[] order, int column, int row, int level) {
        int node = grid.node(column, row, level);
        double along = 0.0;
        for (int i = 0; i < corners.length; i++) {
            if (i > 0) {
                node += strides[order[i - 1]];
                double edge = order[i - 1] < 2 ? grid.spacing() : grid.height(level + 1) - grid.height(level);
                along += edge * edge;
            }
            corners[i] = node;
            simplex.values[i] = values[node];
            simplex.along[i] = along;
        }
    }

    /** A lower bound on the exposure along all routes from a set of nodes, and from the faces between them. */
    double from(BitSet starts) {
        double least = starts.stream().mapToDouble(node -> values[node]).min().orElse(Double.POSITIVE_INFINITY);
        if (least == 0.0 || least == Double.POSITIVE_INFINITY) {
            return least;
        }
        double bound = 0.0;
        for (double piece : compressed(least)) {
            bound += piece;
        }
        return SAFETY * bound;
    }

    /**
     * The nodes of all cubes in which the function, certified, is at most a value somewhere.
     *
     * @param value above 0
     */
    BitSet within(double value) {
        double top = 2.0 * value;
        double[] pieces = compressed(top);
        double below = 0.0;
        int bin = 0;
        while (bin < BINS && SAFETY * (below + pieces[bin]) <= value) {
            below += pieces[bin++];
        }
        double limit = bin == BINS ? Double.POSITIVE_INFINITY : (bin + 1.0) / BINS * top;
        BitSet inside = new BitSet();
        for (int node = 0; node < values.length; node++) {
            inside.set(node, values[node] <= limit);
        }
        return CubeSlopes.around(grid, inside);
    }

    /** By how much the certified function rises in each of equal intervals of values up to a greatest one. */
    private double[] compressed(double top) {
        double[] excess = new double[BINS];
        for (int cube = 0; cube < cubes.size(); cube++) {
            if (!cubes.isSolid(cube)) {
                for (int[] order : orders) {
                    walk(
                            order,
                            cube % cubes.columns(),
                            cube / cubes.columns() % cubes.rows(),
                            cube / (cubes.columns() * cubes.rows()));
                    mark(excess, top, cubes.squared(cube));
                }
            }
        }
        double[] pieces = new double[BINS];
        for (int bin = 0; bin < BINS; bin++) {
            pieces[bin] = top / BINS / (excess[bin] > 0.0 ? excess[bin] : 1.0);
        }
        return pieces;
    }

    /**
     * Notes by how much the gradient of the loaded simplex exceeds its bound at the values that it takes. All values
     * above the greatest one count as equal to it: the function remains a bound where it is cut off.
     */
    private void mark(double[] excess, double top, double bound) {
        double low = Double.POSITIVE_INFINITY;
        double high = 0.0;
        for (int i = 0; i < simplex.values.length; i++) {
            double value = Math.min(simplex.values[i], top);
            simplex.values[i] = value;
            low = Math.min(low, value);
            high = Math.max(high, value);
        }
        if (low == high) {
            return;
        }
        double ratio = Math.sqrt(simplex.gradientSquared() / bound);
        int last = (int) Math.min(BINS - 1.0, high / top * BINS);
        for (int bin = (int) (low / top * BINS); bin <= last; bin++) {
            excess[bin] = Math.max(excess[bin], ratio);
        }
    }
}
