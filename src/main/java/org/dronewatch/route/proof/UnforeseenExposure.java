package org.dronewatch.route.proof;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.FlownExposure;
import org.dronewatch.route.RoutePoint;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.exposure.ExposureField;
import org.dronewatch.route.exposure.LegMotion;
import org.dronewatch.route.search.RouteGrid;
import org.dronewatch.route.search.RouteMode;

/**
 * The exposure to looks along flown routes, beyond what the search expected there. A search assesses only the centres
 * of cells, and thus prefers routes on which it happens to underestimate the exposure; with this field added to its
 * own, the search finds other routes. In each cube of the grid, with a node at each corner, the exposure that was not
 * expected is spread over the time that the drone takes from one node to the next: the resulting rate counts at all
 * eight corners, on all headings, and is interpolated between the corners. Where several routes pass, the highest rate
 * counts. Immutable and thread-safe.
 */
public final class UnforeseenExposure implements ExposureField {
    private static final int CORNERS = 8;

    private final RouteGrid grid;
    private final double[] rates;

    private UnforeseenExposure(RouteGrid grid, double... rates) {
        this.grid = grid;
        this.rates = rates;
    }

    /** A field without exposure, over the nodes of a grid. */
    public static UnforeseenExposure none(RouteGrid grid) {
        return new UnforeseenExposure(grid, new double[grid.size()]);
    }

    /**
     * This field with the unexpected exposure of one more route.
     *
     * @param route a route, once the looks along it have been assessed
     * @param modes modes in which the drone flies, in the order of their numbers
     */
    public UnforeseenExposure with(SectorRoute route, List<RouteMode> modes) {
        FlownExposure flown = route.flown().orElseThrow();
        Map<Integer, Double> byCube = new HashMap<>();
        for (List<FlownExposure.Step> looks : flown.flights()) {
            for (FlownExposure.Step look : looks) {
                RoutePoint at = route.searched().at(look.time());
                double expected = at.exposure() - route.searched().exposureUntil(look.before());
                double rate = (look.exposure() - expected)
                        * modes.get(at.mode()).speed()
                        / (grid.spacing() * flown.flights().size());
                if (rate > 0.0) {
                    byCube.merge(new Cube(grid, at.position()).first(grid), rate, Double::sum);
                }
            }
        }
        double[] all = rates.clone();
        byCube.forEach((first, rate) -> {
            for (int corner = 0; corner < CORNERS; corner++) {
                int node = corner(first, corner);
                all[node] = Math.max(all[node], rate);
            }
        });
        return new UnforeseenExposure(grid, all);
    }

    /** The node at a corner of a cube; the lowest one if the grid has no more levels. */
    private int corner(int first, int corner) {
        int above = grid.levels() > 1 ? corner >> 2 : 0;
        return first + (corner & 1) + ((corner >> 1 & 1) + above * grid.rows()) * grid.columns();
    }

    @Override
    public double rate(double x, double y, double z, LegMotion motion, int mode) {
        Cube cube = new Cube(grid, new Position(x, y, z));
        int first = cube.first(grid);
        double sum = 0.0;
        for (int corner = 0; corner < CORNERS; corner++) {
            sum += cube.weight(grid, corner) * rates[corner(first, corner)];
        }
        return sum;
    }

    /** {@inheritDoc} Always 0: this field does not raise a lower bound. */
    @Override
    public double least(Position low, Position high, int mode) {
        return 0.0;
    }

    /**
     * The position of a point in the cube between nodes that contains it or, for a point outside the grid, relative to
     * the nearest cube.
     *
     * @param column number of columns from the first, with the fraction that lies beyond a node
     * @param row the same from the first row
     * @param level the same from the lowest level
     */
    private record Cube(double column, double row, double level) {
        Cube(RouteGrid grid, Position at) {
            this(
                    within((at.x() - grid.x(0)) / grid.spacing(), grid.columns()),
                    within((at.y() - grid.y(0)) / grid.spacing(), grid.rows()),
                    level(grid, grid.above(at)));
        }

        private static double within(double index, int count) {
            return Math.max(0.0, Math.min(count - 1.0, index));
        }

        private static double level(RouteGrid grid, double above) {
            int level = 0;
            while (level < grid.levels() - 2 && grid.height(level + 1) <= above) {
                level++;
            }
            double next = grid.levels() > 1 ? grid.height(level + 1) : Double.POSITIVE_INFINITY;
            return level + Math.max(0.0, Math.min(1.0, (above - grid.height(level)) / (next - grid.height(level))));
        }

        /** The node at its first corner. */
        int first(RouteGrid grid) {
            return grid.node(begin(column, grid.columns()), begin(row, grid.rows()), begin(level, grid.levels()));
        }

        /** What a corner contributes to the interpolation at the point, 0 to 1. */
        double weight(RouteGrid grid, int corner) {
            return share(column, grid.columns(), corner & 1)
                    * share(row, grid.rows(), corner >> 1 & 1)
                    * share(level, grid.levels(), corner >> 2);
        }

        private static double share(double index, int count, int far) {
            double beyond = index - begin(index, count);
            return far == 1 ? beyond : 1.0 - beyond;
        }

        private static int begin(double index, int count) {
            return Math.max(0, Math.min(count - 2, (int) index));
        }
    }
}
