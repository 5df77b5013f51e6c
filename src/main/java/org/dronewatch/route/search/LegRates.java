package org.dronewatch.route.search;

import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import org.dronewatch.parallel.Workers;
import org.dronewatch.route.exposure.LegMotion;

/**
 * The mean rates of a field along the shortest level legs from all nodes, in all modes and directions, where the rate
 * is bilinear between nodes; and the rates at the nodes on vertical legs. Immutable.
 */
final class LegRates {
    private final int directions;

    /** By mode and direction, then node at which the leg begins. */
    private final float[][] rates;

    /** By mode, down and then up, and node; empty where no leg is vertical. */
    private final float[][] vertical;

    /** Evaluates the field on the {@link Workers} of the calling thread. */
    LegRates(RouteProblem problem) {
        this.directions = problem.directions().count();
        this.rates =
                new float[problem.modes().size() * directions][problem.grid().size()];
        RouteGrid grid = problem.grid();
        // Whatever needs room to turn cannot stop in the air.
        boolean isVertical = problem.headings() == 1 && grid.levels() > 1;
        this.vertical = new float[isVertical ? 2 * problem.modes().size() : 0][grid.size()];
        LegMotion[] motions = new LegMotion[rates.length];
        Arrays.setAll(motions, i -> problem.modes()
                .get(i / directions)
                .motion(problem.directions().heading(i % directions)));
        Workers.forEach(grid.rows() * grid.levels(), row -> {
            for (int node = row * grid.columns(); node < (row + 1) * grid.columns(); node++) {
                set(problem, node, motions);
            }
        });
        Workers.forEach(rates.length, i -> rates[i] = alongLegs(problem, i % directions, rates[i]));
    }

    /** Sets the rates at a node, infinite where a drone cannot be. */
    private void set(RouteProblem problem, int node, LegMotion... motions) {
        RouteGrid grid = problem.grid();
        if (!grid.isOpen(node)) {
            for (float[] one : rates) {
                one[node] = Float.POSITIVE_INFINITY;
            }
            for (float[] one : vertical) {
                one[node] = Float.POSITIVE_INFINITY;
            }
            return;
        }
        double x = grid.x(node);
        double y = grid.y(node);
        double z = grid.z(node);
        for (int i = 0; i < rates.length; i++) {
            rates[i][node] = finite(problem.field().rate(x, y, z, motions[i], i / directions));
        }
        for (int i = 0; i < vertical.length; i++) {
            RouteMode mode = problem.modes().get(i / 2);
            vertical[i][node] = mode.isGlide()
                    ? Float.POSITIVE_INFINITY
                    : finite(problem.field().rate(x, y, z, mode.vertical((i & 1) == 1), i / 2));
        }
    }

    /** A node may coincide with a sensor; no leg through it is worth its price. */
    private static float finite(double rate) {
        return rate < Float.MAX_VALUE ? (float) rate : Float.MAX_VALUE;
    }

    private static float[] alongLegs(RouteProblem problem, int direction, float[] atNodes) {
        RouteGrid grid = problem.grid();
        int east = problem.directions().east(direction);
        int north = problem.directions().north(direction);
        Stencil stencil = new Stencil(east, north, grid.columns());
        float[] means = new float[atNodes.length];
        for (int level = 0; level < grid.levels(); level++) {
            for (int row = Math.max(0, -north); row < grid.rows() - Math.max(0, north); row++) {
                for (int column = Math.max(0, -east); column < grid.columns() - Math.max(0, east); column++) {
                    int node = grid.node(column, row, level);
                    float mean = stencil.mean(atNodes, node);
                    means[node] = stencil.isOpen(atNodes, node) ? mean : Math.min(-Float.MIN_VALUE, -mean);
                }
            }
        }
        return means;
    }

    /**
     * The mean rates by the node at which the leg begins, 1/s: negative if a drone cannot be at a node that the leg
     * passes, infinite if it can be at no node around the leg. Where the leg leaves the grid, they mean nothing. Not to
     * be changed.
     */
    float[] of(int mode, int direction) {
        return rates[mode * directions + direction];
    }

    /** Whether a leg may be vertical: there are several levels, and turns need no room. */
    boolean hasVertical() {
        return vertical.length > 0;
    }

    /** The rate at a node on a vertical leg, 1/s; infinite where the drone cannot be or cannot fly such a leg. */
    float vertical(int mode, boolean isUp, int node) {
        return vertical[2 * mode + (isUp ? 1 : 0)][node];
    }

    /**
     * What the nodes around a level leg contribute to the mean along it of a value that is bilinear between nodes.
     * Immutable.
     */
    private static final class Stencil {
        /** The nodes, relative to the one at which the leg begins. */
        private final int[] nodes;

        /** What each contributes; these numbers add up to 1. */
        private final float[] weights;

        /** The nodes that the leg passes, and that at which it begins. */
        private final int[] passed;

        /** The node at which it ends. */
        private final int end;

        /**
         * The stencil of a leg.
         *
         * @param east nodes that it leads to the east
         * @param north nodes that it leads to the north
         * @param columns columns of the grid
         */
        Stencil(int east, int north, int columns) {
            TreeSet<Double> crossings = new TreeSet<>();
            for (int along : new int[] {Math.abs(east), Math.abs(north)}) {
                for (int i = 0; i <= along; i++) {
                    crossings.add(along == 0 ? 0.0 : (double) i / along);
                }
            }
            Map<Integer, Double> sums = new TreeMap<>();
            double from = 0.0;
            for (double to : crossings) {
                // The value is a quadratic function within a square: Simpson's rule is exact.
                for (int point = 0; point <= 2; point++) {
                    double share = from + 0.5 * point * (to - from);
                    double weight = (to - from) * (point == 1 ? 4.0 : 1.0) / 6.0;
                    add(sums, share * east, share * north, weight, columns);
                }
                from = to;
            }
            sums.values().removeIf(weight -> weight < 1e-9);
            this.nodes = sums.keySet().stream().mapToInt(Integer::intValue).toArray();
            this.weights = new float[nodes.length];
            for (int i = 0; i < nodes.length; i++) {
                weights[i] = (float) (double) sums.get(nodes[i]);
            }
            this.passed = RouteEdges.passed(east, north, columns);
            this.end = north * columns + east;
        }

        private static void add(Map<Integer, Double> sums, double x, double y, double weight, int columns) {
            int west = (int) Math.floor(x);
            int south = (int) Math.floor(y);
            double u = x - west;
            double v = y - south;
            for (int corner = 0; corner < 4; corner++) {
                int node = (south + (corner >> 1)) * columns + west + (corner & 1);
                double share = ((corner & 1) == 0 ? 1.0 - u : u) * ((corner & 2) == 0 ? 1.0 - v : v);
                sums.merge(node, weight * share, Double::sum);
            }
        }

        /**
         * The mean along a leg. Nodes whose value is infinite contribute nothing, and the others proportionally more.
         *
         * @param values the value at each node
         * @param from node at which the leg begins
         * @return the mean, finite; infinite if the values of all nodes are
         */
        float mean(float[] values, int from) {
            float sum = 0.0F;
            float weight = 0.0F;
            for (int i = 0; i < nodes.length; i++) {
                float value = values[from + nodes[i]];
                if (value < Float.POSITIVE_INFINITY) {
                    sum += weights[i] * value;
                    weight += weights[i];
                }
            }
            return weight > 0.0F ? Math.min(Float.MAX_VALUE, sum / weight) : Float.POSITIVE_INFINITY;
        }

        /**
         * Whether the values of all nodes that a leg passes are finite.
         *
         * @param values the value at each node
         * @param from node at which the leg begins
         */
        boolean isOpen(float[] values, int from) {
            for (int node : passed) {
                if (values[from + node] == Float.POSITIVE_INFINITY) {
                    return false;
                }
            }
            return values[from + end] < Float.POSITIVE_INFINITY;
        }
    }
}
