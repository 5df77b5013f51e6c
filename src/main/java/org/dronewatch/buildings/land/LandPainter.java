package org.dronewatch.buildings.land;

import java.util.Arrays;
import java.util.List;

/**
 * Draws areas and lines into a raster of land cover; what comes later covers what was there. A cell has the class of
 * the last shape that contains its centre.
 */
final class LandPainter {
    /** The greatest number of rows, and of columns: 64 MB. */
    static final int MOST_CELLS = 8192;

    /** The side of cells, m, unless there would be too many. */
    private static final double CELL = 1.0;

    private final double half;
    private final int side;
    private final double cell;
    private final byte[] codes;

    /** Where the edges of the current area cross each of its rows, m, and how often they do. */
    private double[][] crossings = new double[0][];

    private int[] counts = new int[0];

    /** A raster without land cover, of a square of half this side, m. */
    LandPainter(double half) {
        this.half = half;
        this.side = (int) Math.min(MOST_CELLS, Math.max(1.0, Math.ceil(2.0 * half / CELL)));
        this.cell = 2.0 * half / side;
        this.codes = new byte[side * side];
    }

    double half() {
        return half;
    }

    double cell() {
        return cell;
    }

    int side() {
        return side;
    }

    /** The centre of a column or row, m. */
    double centre(int index) {
        return (index + 0.5) * cell - half;
    }

    /** The first column or row whose centre is at a coordinate or beyond; may lie outside of the raster. */
    private int first(double coordinate) {
        double index = Math.ceil((coordinate + half) / cell - 0.5);
        return (int) Math.max(-1.0, Math.min(side, index));
    }

    /** Sets cells of a row; columns outside of the raster are ignored. */
    void set(int row, int fromColumn, int toColumn, LandClass land) {
        int from = Math.max(0, fromColumn);
        int to = Math.min(side, toColumn);
        if (from < to) {
            Arrays.fill(codes, row * side + from, row * side + to, (byte) land.code());
        }
    }

    /** Fills what an odd number of rings encloses: outlines without their courtyards, but with islands in those. */
    void fill(List<double[]> rings, LandClass land) {
        int low = side;
        int high = 0;
        for (double[] ring : rings) {
            for (int i = 1; i < ring.length; i += 2) {
                low = Math.min(low, first(ring[i]));
                high = Math.max(high, first(ring[i]));
            }
        }
        low = Math.max(0, low);
        if (low >= high) {
            return;
        }
        crossings = new double[high - low][4];
        counts = new int[high - low];
        for (double[] ring : rings) {
            int last = ring.length - 2;
            for (int i = 0; i < ring.length; i += 2) {
                cross(ring[last], ring[last + 1], ring[i], ring[i + 1], low);
                last = i;
            }
        }
        for (int row = low; row < high; row++) {
            double[] columns = crossings[row - low];
            Arrays.sort(columns, 0, counts[row - low]);
            for (int i = 0; i + 1 < counts[row - low]; i += 2) {
                set(row, first(columns[i]), first(columns[i + 1]), land);
            }
        }
    }

    /** Notes where an edge crosses the centre lines of rows; its lower end counts, its upper one does not. */
    private void cross(double ax, double ay, double bx, double by, int low) {
        int from = Math.max(0, first(Math.min(ay, by)));
        int to = Math.min(side, first(Math.max(ay, by)));
        for (int row = from; row < to; row++) {
            double x = ax + (centre(row) - ay) / (by - ay) * (bx - ax);
            int index = row - low;
            if (counts[index] == crossings[index].length) {
                crossings[index] = Arrays.copyOf(crossings[index], 2 * counts[index]);
            }
            crossings[index][counts[index]++] = x;
        }
    }

    /**
     * Draws a line with round ends and corners. One that is narrower than a cell is as wide as a cell, so that it has
     * no gaps.
     */
    void stroke(double[] line, double width, LandClass land) {
        double radius = 0.5 * Math.max(width, cell);
        for (int i = 0; i + 3 < line.length; i += 2) {
            piece(line[i], line[i + 1], line[i + 2], line[i + 3], radius, land);
        }
    }

    private void piece(double ax, double ay, double bx, double by, double radius, LandClass land) {
        int from = Math.max(0, first(Math.min(ay, by) - radius));
        int to = Math.min(side, first(Math.max(ay, by) + radius));
        double[] range = new double[2];
        for (int row = from; row < to; row++) {
            if (across(ax, ay, bx, by, radius, centre(row), range)) {
                set(row, first(range[0]), first(range[1]), land);
            }
        }
    }

    /** The least and the greatest x on a level line within a distance of a segment: a convex body, so one range. */
    private static boolean across(double ax, double ay, double bx, double by, double radius, double y, double[] range) {
        range[0] = Double.POSITIVE_INFINITY;
        range[1] = Double.NEGATIVE_INFINITY;
        disc(ax, ay, radius, y, range);
        disc(bx, by, radius, y, range);
        double length = Math.hypot(bx - ax, by - ay);
        if (length > 0.0) {
            double nx = radius * (by - ay) / length;
            double ny = -radius * (bx - ax) / length;
            side(ax + nx, ay + ny, bx + nx, by + ny, y, range);
            side(ax - nx, ay - ny, bx - nx, by - ny, y, range);
        }
        return range[0] < range[1];
    }

    private static void disc(double x, double y, double radius, double at, double[] range) {
        double off = at - y;
        if (Math.abs(off) <= radius) {
            double reach = Math.sqrt(radius * radius - off * off);
            range[0] = Math.min(range[0], x - reach);
            range[1] = Math.max(range[1], x + reach);
        }
    }

    private static void side(double ax, double ay, double bx, double by, double y, double[] range) {
        if (y >= Math.min(ay, by) && y <= Math.max(ay, by) && ay != by) {
            double x = ax + (y - ay) / (by - ay) * (bx - ax);
            range[0] = Math.min(range[0], x);
            range[1] = Math.max(range[1], x);
        }
    }

    /** What was drawn. The painter must not be used any more. */
    LandRaster cover() {
        return new LandRaster(half, side, codes);
    }
}
