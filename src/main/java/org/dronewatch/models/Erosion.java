package org.dronewatch.models;

import java.util.Arrays;
import java.util.Comparator;
import java.util.PriorityQueue;

/**
 * Lets water cut valleys and soil creep around the crests. Each step drains every cell to its lowest neighbour, lowers
 * it in proportion to slope and to the square root of the area drained through it (the stream power law, solved
 * implicitly from the outlets upward as Braun and Willett describe), and then diffuses the heights a little.
 */
final class Erosion {

    private record Spill(double level, int index) {}

    private static final int[] COLUMN_STEPS = {-1, 0, 1, -1, 1, -1, 0, 1};
    private static final int[] ROW_STEPS = {-1, -1, -1, 0, 0, 1, 1, 1};
    private static final double DRY_FALL = 1e-3;

    private final HeightGrid grid;
    private final int cells;
    private final double[] level;
    private final int[] order;
    private final int[] receiver;
    private final double[] area;

    Erosion(HeightGrid grid) {
        this.grid = grid;
        this.cells = grid.side() * grid.side();
        this.level = new double[cells];
        this.order = new int[cells];
        this.receiver = new int[cells];
        this.area = new double[cells];
    }

    /**
     * Runs the whole history.
     *
     * @param steps number of steps
     * @param power erosion per step and unit slope below one metre of drained width, metres
     * @param creep fraction of the difference from the neighbours' mean that one step levels out, 0 to 1
     */
    void run(int steps, double power, double creep) {
        for (int step = 0; step < steps; step++) {
            flood();
            drain(step);
            accumulate();
            incise(power);
            diffuse(creep);
        }
    }

    /**
     * Fills hollows from the rim inward; in the order of filling, every cell comes after the cell to which it drains.
     */
    private void flood() {
        Comparator<Spill> lowestFirst = Comparator.comparingDouble(Spill::level).thenComparingInt(Spill::index);
        PriorityQueue<Spill> front = new PriorityQueue<>(lowestFirst);
        boolean[] reached = new boolean[cells];
        for (int i = 0; i < cells; i++) {
            if (grid.isRim(i)) {
                level[i] = grid.get(i);
                reached[i] = true;
                front.add(new Spill(level[i], i));
            }
        }
        for (int filled = 0; filled < cells; filled++) {
            int here = front.remove().index();
            order[filled] = here;
            for (int k = 0; k < 8; k++) {
                int there = neighbour(here, k);
                if (there >= 0 && !reached[there]) {
                    level[there] = Math.max(grid.get(there), level[here] + DRY_FALL);
                    reached[there] = true;
                    front.add(new Spill(level[there], there));
                }
            }
        }
    }

    /**
     * Picks where each cell drains to. On a square grid the steepest of eight neighbours favours eight directions and
     * would cut dead straight gullies; weighting the slopes at random, anew in each step, lets the mean flow take any
     * direction.
     */
    private void drain(int step) {
        for (int i = 0; i < cells; i++) {
            receiver[i] = i;
            double steepest = 0;
            for (int k = 0; k < 8 && !grid.isRim(i); k++) {
                int there = neighbour(i, k);
                double slope = (level[i] - level[there]) / distance(k) * chance(step, i, k);
                if (slope > steepest) {
                    steepest = slope;
                    receiver[i] = there;
                }
            }
        }
    }

    /** A factor from 0.4 to 1.6 hashed from its arguments. */
    private static double chance(int step, int index, int k) {
        int h = (step * 0x27d4eb2d) ^ (index * 0x165667b1) ^ (k * 0x2c1b3c6d);
        h = (h ^ (h >>> 15)) * 0x297a2d39;
        h = (h ^ (h >>> 13)) * 0x2c1b3c6d;
        return 1 + 0.6 * ((h ^ (h >>> 16)) / 2147483648.0);
    }

    private void accumulate() {
        Arrays.fill(area, grid.spacing() * grid.spacing());
        for (int n = cells - 1; n >= 0; n--) {
            int i = order[n];
            if (receiver[i] != i) {
                area[receiver[i]] += area[i];
            }
        }
    }

    private void incise(double power) {
        for (int i : order) {
            int to = receiver[i];
            double fall = grid.get(i) - grid.get(to);
            if (to != i && fall > 0) {
                double run = Math.abs(i - to) == 1 || Math.abs(i - to) == grid.side() ? 1 : StrictMath.sqrt(2);
                double factor = power * StrictMath.sqrt(area[i]) / (run * grid.spacing());
                grid.set(i, (grid.get(i) + factor * grid.get(to)) / (1 + factor));
            }
        }
    }

    private void diffuse(double creep) {
        double[] old = grid.copyOfHeights();
        for (int i = 0; i < cells; i++) {
            if (!grid.isRim(i)) {
                double mean = (old[i - 1] + old[i + 1] + old[i - grid.side()] + old[i + grid.side()]) / 4;
                grid.set(i, old[i] + creep * (mean - old[i]));
            }
        }
    }

    private int neighbour(int index, int k) {
        int column = index % grid.side() + COLUMN_STEPS[k];
        int row = index / grid.side() + ROW_STEPS[k];
        boolean inside = column >= 0 && row >= 0 && column < grid.side() && row < grid.side();
        return inside ? grid.index(column, row) : -1;
    }

    private double distance(int k) {
        boolean diagonal = COLUMN_STEPS[k] != 0 && ROW_STEPS[k] != 0;
        return grid.spacing() * (diagonal ? StrictMath.sqrt(2) : 1);
    }
}
