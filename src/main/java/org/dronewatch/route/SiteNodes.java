package org.dronewatch.route;

import java.util.ArrayDeque;
import java.util.BitSet;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.fusion.AreaZone;
import org.dronewatch.fusion.Protection;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.search.RouteGrid;

/** The nodes of a site, one at the centre of each cell of its field, and those at which routes begin and end. */
final class SiteNodes {
    private final RouteGrid grid;

    /** By column and row, whether there is ground below. */
    private final BitSet known;

    /**
     * The nodes.
     *
     * @param ceiling the greatest height above the ground, m
     * @throws IllegalArgumentException if the field has no height up to the ceiling
     */
    SiteNodes(DetectionField field, double ceiling) {
        FieldGrid cells = field.grid();
        int side = cells.columns();
        double[] heights = cells.heights().stream()
                .filter(height -> height <= ceiling)
                .mapToDouble(Double::doubleValue)
                .toArray();
        if (heights.length == 0) {
            throw new IllegalArgumentException("the lowest height, "
                    + cells.heights().get(0) + " m, is above the drone's ceiling of " + ceiling + " m");
        }
        FieldCells middles = new FieldCells(field);
        double[] ground = new double[side * side];
        this.known = new BitSet();
        for (int node = 0; node < ground.length; node++) {
            int column = node % side;
            int row = side - 1 - node / side;
            known.set(node, !Double.isNaN(field.ground(column, row)));
            ground[node] = middles.ground(column, row);
        }
        BitSet blocked = new BitSet();
        for (int node = 0; node < heights.length * ground.length; node++) {
            int below = node % ground.length;
            blocked.set(node, !field.isOpen(node / ground.length, below % side, side - 1 - below / side));
        }
        this.grid = new RouteGrid(cells.x(0), cells.y(side - 1), cells.cell(), side, side, heights, ground, blocked);
    }

    /** The grid of all nodes. */
    RouteGrid grid() {
        return grid;
    }

    /** The open nodes at the rim of the known ground: at that of the grid, or where the model of the site ends. */
    BitSet rim() {
        int side = grid.columns();
        BitSet outside = new BitSet();
        BitSet rim = new BitSet();
        ArrayDeque<Integer> next = new ArrayDeque<>();
        for (int i = 0; i < side; i++) {
            for (int column : new int[] {i, (side - 1) * side + i, i * side, i * side + side - 1}) {
                meet(column, outside, rim, next);
            }
        }
        while (!next.isEmpty()) {
            int column = next.remove();
            int x = column % side;
            if (x > 0) {
                meet(column - 1, outside, rim, next);
            }
            if (x < side - 1) {
                meet(column + 1, outside, rim, next);
            }
            if (column >= side) {
                meet(column - side, outside, rim, next);
            }
            if (column < side * (side - 1)) {
                meet(column + side, outside, rim, next);
            }
        }
        return open(node -> rim.get(node % (side * side)) ? 0.0 : 1.0, 0.0);
    }

    /** Ground that is reached from outside is part of the rim; where there is no ground, the outside continues. */
    private void meet(int column, BitSet outside, BitSet rim, ArrayDeque<Integer> next) {
        if (known.get(column)) {
            rim.set(column);
        } else if (!outside.get(column)) {
            outside.set(column);
            next.add(column);
        }
    }

    /** The open nodes above or below an area, in plan view. */
    BitSet over(AreaZone area) {
        return open(node -> area.covers(grid.x(node), grid.y(node)) ? 0.0 : 1.0, 0.0);
    }

    /**
     * How near a route has to come to the protected zone, or in plan view to the mean position of the sensors, m: into
     * the zone if it contains a node; otherwise, to within one cell's length.
     */
    double reach(Protection protection, Position middle) {
        boolean isEntered =
                !protection.isEmpty() && !near(protection, middle, 0.0).isEmpty();
        return isEntered ? 0.0 : grid.spacing();
    }

    /**
     * The open nodes within a distance of the protected zone, or in plan view of the mean position of the sensors, m.
     */
    BitSet near(Protection protection, Position middle, double distance) {
        return open(node -> distance(protection, middle, grid.position(node)), distance);
    }

    private static double distance(Protection protection, Position middle, Position at) {
        return protection.isEmpty() ? Math.hypot(at.x() - middle.x(), at.y() - middle.y()) : protection.distance(at);
    }

    /**
     * The open nodes at which a route ends: those {@linkplain #near near} enough to the protected zone. Without one, in
     * each column only the one whose height is nearest to that of the sensors: a drone that passes high over them has
     * not reached them.
     */
    BitSet goals(Protection protection, Position middle, double reach) {
        BitSet goals = near(protection, middle, reach);
        if (!protection.isEmpty()) {
            return goals;
        }
        int columns = grid.columns() * grid.rows();
        Map<Integer, Integer> nearest = new TreeMap<>();
        goals.stream()
                .forEach(node -> nearest.merge(
                        node % columns,
                        node,
                        (one, other) -> Math.abs(grid.z(other) - middle.z()) < Math.abs(grid.z(one) - middle.z())
                                ? other
                                : one));
        BitSet only = new BitSet();
        nearest.values().forEach(only::set);
        return only;
    }

    private BitSet open(ToDoubleFunction<Integer> distance, double most) {
        BitSet found = new BitSet();
        for (int node = 0; node < grid.size(); node++) {
            found.set(node, grid.isOpen(node) && distance.applyAsDouble(node) <= most);
        }
        return found;
    }

    /**
     * The nodes of all cubes in which a route may end because it comes within a distance of the protected zone or, in
     * plan view, of the mean position of the sensors, m.
     */
    BitSet ends(Protection protection, Position middle, double distance) {
        BitSet ends = new BitSet();
        for (int low = 0; low < Math.max(1, grid.levels() - 1); low++) {
            int high = Math.min(low + 1, grid.levels() - 1);
            for (int square = 0; square < (grid.columns() - 1) * (grid.rows() - 1); square++) {
                int column = square % (grid.columns() - 1);
                int row = square / (grid.columns() - 1);
                if (mayEnd(column, row, low, high, at -> distance(protection, middle, at) - distance)) {
                    for (int i = 0; i < 4; i++) {
                        ends.set(grid.node(column + i % 2, row + i / 2, low));
                        ends.set(grid.node(column + i % 2, row + i / 2, high));
                    }
                }
            }
        }
        return ends;
    }

    /**
     * Whether a distance may be 0 or less somewhere in a cube. A cube between two levels far above the ground is much
     * higher than it is wide: it is looked at in pieces, so that its top does not count as near because its bottom is.
     */
    private boolean mayEnd(int column, int row, int low, int high, ToDoubleFunction<Position> distance) {
        double[] ground = grid.groundRange(column, row);
        double bottom = ground[0] + grid.height(low);
        double depth = ground[1] + grid.height(high) - bottom;
        double width = grid.spacing();
        int pieces = Math.max(1, (int) Math.ceil(depth / width));
        double piece = depth / pieces;
        double reach = 0.5 * Math.sqrt(2.0 * width * width + piece * piece);
        int corner = grid.node(column, row, low);
        double x = grid.x(corner) + 0.5 * width;
        double y = grid.y(corner) + 0.5 * width;
        return IntStream.range(0, pieces)
                .mapToObj(i -> new Position(x, y, bottom + (i + 0.5) * piece))
                .anyMatch(at -> distance.applyAsDouble(at) <= reach);
    }
}
