package org.dronewatch.kdtree;

import java.util.Arrays;

/**
 * Finds what the pixels of a tile of a picture see. All rays of a tile share their origin, and their directions lie on a
 * regular grid: so the tree is descended once for the whole tile, with the interval of ray parameters in which any of its
 * rays is inside a cell, and each triangle on the way is painted into the tile, nearest surface wins. One per thread.
 *
 * <p>What it buys: a ray of its own costs a descent and a handful of triangle tests, a pixel of a tile a few additions.
 * The benchmark {@code PictureTracing} shows the ratio. It pays while triangles are not much smaller than pixels; a tile
 * that has met {@link #TRIANGLES_PER_PIXEL} times as many triangles as it has pixels is traced ray by ray instead.
 *
 * <p>How a triangle is painted: in the frame whose axes are a step to the right, a step down and the grid's corner, the
 * ray of pixel (x, y) has the direction (x, y, 1). The three edge functions, whose signs tell inside from outside, and
 * the inverse of the ray parameter are linear in x and y there. Each row of pixels is then an interval between the edges.
 * An edge that two triangles share has exactly opposite values in them, and zero counts as inside: no pixel slips
 * through.
 */
public final class TileTraversal {
    /** The most pixels of a tile in a row. */
    public static final int WIDTH = 32;
    /** The most rows of a tile. */
    public static final int HEIGHT = 32;
    /** How many triangles a tile may meet for each of its pixels before single rays are cheaper. */
    static final double TRIANGLES_PER_PIXEL = 4.0;

    /** Widens the interval of a cell by more than the roundings of its bounds. */
    private static final double WIDER = 1e-12;
    /** How near to a pixel's centre, in pixels, an edge must pass to be looked at once more. */
    private static final double NEAR_EDGE = 1e-6;
    /** As if so many triangles had been met: gives the tile up. */
    private static final int TOO_MANY = 1 << 30;
    /** Relative size of the roundings of the volume between the origin and a triangle. */
    private static final double IN_PLANE = 1e-12;

    private final KDTree tree;
    private final float[] corners;
    private final KDTraversal single;

    private final double[] origin = new double[3];
    /** Direction of pixel (0, 0), step to the next column, step to the next row: three numbers each. */
    private final double[] grid = new double[9];
    /** From world to grid coordinates: rows of the inverse of the matrix of the steps and the corner. */
    private final double[] toGrid = new double[9];

    private int left;
    private int top;
    private int width;
    private int height;

    /** Inverse ray parameter of the nearest surface of each pixel, 0 for none; and which triangle it is. */
    private final double[] nearest = new double[WIDTH * HEIGHT];

    private final int[] triangles = new int[WIDTH * HEIGHT];
    private int uncovered;
    /** The ray parameter beyond which the tile sees nothing any more; its inverse. */
    private double farthest;

    private double leastInverse;

    /** On which tile each triangle was painted last: triangles lie in many leaves. */
    private final int[] painted;

    private int tile;
    private int met;

    /**
     * For each axis, first for planes above the origin, then for planes below: ray parameter per metre at which the first
     * ray of the tile meets a plane, and at which the last one does. Infinite where none does, or not all.
     */
    private final double[] first = new double[6];

    private final double[] last = new double[6];

    private final int[] stackNode;
    private final double[] stackEntry;
    private final double[] stackExit;

    /** A traversal of a tree for the use of one thread. */
    public TileTraversal(KDTree tree) {
        this.tree = tree;
        this.corners = tree.corners();
        this.single = new StackTraversal(tree);
        this.painted = new int[tree.mesh().triangleCount()];
        int size = tree.depth() + 1;
        this.stackNode = new int[size];
        this.stackEntry = new double[size];
        this.stackExit = new double[size];
    }

    /**
     * Sets the picture whose tiles come next. The ray of the pixel in a column and a row starts at the origin in the
     * direction corner + column * right + row * down.
     *
     * @param from the origin, three coordinates
     * @param corner direction of the pixel in column 0 and row 0
     * @param right what a column adds to it
     * @param down what a row adds to it
     * @throws IllegalArgumentException when corner, right and down lie in one plane
     */
    public void setPicture(double[] from, double[] corner, double[] right, double[] down) {
        System.arraycopy(from, 0, origin, 0, 3);
        System.arraycopy(corner, 0, grid, 0, 3);
        System.arraycopy(right, 0, grid, 3, 3);
        System.arraycopy(down, 0, grid, 6, 3);
        crossTo(right, down, 0);
        crossTo(down, corner, 3);
        crossTo(corner, right, 6);
        double determinant = corner[0] * toGrid[0] + corner[1] * toGrid[1] + corner[2] * toGrid[2];
        if (!(Math.abs(determinant) > 0.0)) {
            throw new IllegalArgumentException("a picture whose corner, right and down lie in one plane");
        }
        for (int i = 0; i < 9; i++) {
            toGrid[i] /= determinant;
        }
    }

    private void crossTo(double[] a, double[] b, int target) {
        toGrid[target] = a[1] * b[2] - a[2] * b[1];
        toGrid[target + 1] = a[2] * b[0] - a[0] * b[2];
        toGrid[target + 2] = a[0] * b[1] - a[1] * b[0];
    }

    /**
     * Looks for the nearest triangle of each pixel of a tile, at ray parameters from 0 on.
     *
     * @param firstColumn column of its left pixels
     * @param firstRow row of its top pixels
     * @param columns 1 to {@link #WIDTH}
     * @param rows 1 to {@link #HEIGHT}
     */
    public void trace(int firstColumn, int firstRow, int columns, int rows) {
        setTile(firstColumn, firstRow, columns, rows);
        uncovered = width * height;
        farthest = Double.POSITIVE_INFINITY;
        leastInverse = 0.0;
        met = 0;
        nextTile();
        setDirections();
        if (!descend()) {
            traceSingly(firstColumn, firstRow, columns, rows);
        }
    }

    private void setTile(int firstColumn, int firstRow, int columns, int rows) {
        left = firstColumn;
        top = firstRow;
        width = columns;
        height = rows;
        Arrays.fill(nearest, 0, width * height, 0.0);
    }

    private void nextTile() {
        tile++;
        if (tile == 0) {
            Arrays.fill(painted, 0);
            tile = 1;
        }
    }

    /** Whether a pixel of the last tile, counted from its own corner, sees a triangle. */
    public boolean hits(int column, int row) {
        return nearest[row * width + column] > 0.0;
    }

    /** Ray parameter of what a pixel of the last tile sees; infinity for nothing. */
    public double parameter(int column, int row) {
        return 1.0 / nearest[row * width + column];
    }

    /**
     * Writes how far the pixels of the last tile see: ray parameters times the lengths of the pixels' directions, which is
     * metres in the frame of the grid. Infinity for nothing.
     *
     * @param target where to
     * @param first place of the tile's first pixel in it
     * @param rowLength from one row to the next
     */
    public void copyDistances(float[] target, int first, int rowLength) {
        for (int row = 0; row < height; row++) {
            double y = top + row;
            double dx = grid[0] + left * grid[3] + y * grid[6];
            double dy = grid[1] + left * grid[4] + y * grid[7];
            double dz = grid[2] + left * grid[5] + y * grid[8];
            int start = first + row * rowLength;
            for (int column = 0; column < width; column++) {
                double inverse = nearest[row * width + column];
                target[start + column] = inverse > 0.0
                        ? (float) (Math.sqrt(dx * dx + dy * dy + dz * dz) / inverse)
                        : Float.POSITIVE_INFINITY;
                dx += grid[3];
                dy += grid[4];
                dz += grid[5];
            }
        }
    }

    /** What a pixel of the last tile sees, if it sees anything. */
    public int triangle(int column, int row) {
        return triangles[row * width + column];
    }

    /** The range of the rays' steps along each axis is that of the tile's corners: they are a grid. */
    private void setDirections() {
        for (int axis = 0; axis < 3; axis++) {
            double atCorner = grid[axis] + left * grid[3 + axis] + top * grid[6 + axis];
            double across = (width - 1) * grid[3 + axis];
            double downwards = (height - 1) * grid[6 + axis];
            double low = atCorner + Math.min(across, 0.0) + Math.min(downwards, 0.0);
            double high = atCorner + Math.max(across, 0.0) + Math.max(downwards, 0.0);
            first[2 * axis] = high > 0.0 ? (1.0 - WIDER) / high : Double.POSITIVE_INFINITY;
            last[2 * axis] = low > 0.0 ? (1.0 + WIDER) / low : Double.POSITIVE_INFINITY;
            first[2 * axis + 1] = low < 0.0 ? (1.0 - WIDER) / low : Double.NEGATIVE_INFINITY;
            last[2 * axis + 1] = high < 0.0 ? (1.0 + WIDER) / high : Double.NEGATIVE_INFINITY;
        }
    }

    /**
     * Descends the tree, nearer cells first. The interval of a cell holds every ray parameter at which any ray of the
     * tile is inside.
     *
     * @return false when the tile has met more triangles than are worth painting
     */
    private boolean descend() {
        double entry = 0.0;
        double exit = Double.POSITIVE_INFINITY;
        float[] box = tree.rootBox();
        for (int axis = 0; axis < 3; axis++) {
            // The face towards the origin lets in, the other one out; from inside no face lets in.
            double toLow = box[axis] - origin[axis];
            double toHigh = box[axis + 3] - origin[axis];
            if (toLow > 0.0) {
                entry = Math.max(entry, toLow * first[2 * axis]);
                exit = Math.min(exit, toHigh * last[2 * axis]);
            } else if (toHigh < 0.0) {
                entry = Math.max(entry, toHigh * first[2 * axis + 1]);
                exit = Math.min(exit, toLow * last[2 * axis + 1]);
            }
        }
        if (!(entry <= exit) || entry == Double.POSITIVE_INFINITY) {
            return true;
        }
        long[] nodes = tree.nodes();
        int limit = (int) (TRIANGLES_PER_PIXEL * width * height) + 1;
        int stacked = 0;
        int index = 0;
        while (true) {
            long node = nodes[index];
            int axis = KDNode.kind(node);
            while (axis != KDNode.LEAF) {
                // The origin's side is the nearer one. Where a parameter is not a number the origin lies in the plane:
                // the comparisons then visit both sides.
                double toPlane = KDNode.split(node) - origin[axis];
                int near = index + 1;
                int far = KDNode.rightChild(node);
                int side = 2 * axis;
                if (toPlane < 0.0) {
                    far = near;
                    near = KDNode.rightChild(node);
                    side++;
                }
                double firstMeets = toPlane * first[side];
                double lastMeets = toPlane * last[side];
                if (firstMeets > exit) {
                    index = near;
                } else if (lastMeets < entry) {
                    index = far;
                } else {
                    stackNode[stacked] = far;
                    stackEntry[stacked] = firstMeets > entry ? firstMeets : entry;
                    stackExit[stacked] = exit;
                    stacked++;
                    index = near;
                    exit = lastMeets < exit ? lastMeets : exit;
                }
                node = nodes[index];
                axis = KDNode.kind(node);
            }

            paintLeaf(node);
            if (met > limit) {
                return false;
            }
            // What is still to come lies behind all that the tile sees: it is done.
            do {
                if (stacked == 0) {
                    return true;
                }
                stacked--;
            } while (stackEntry[stacked] > farthest);
            index = stackNode[stacked];
            entry = stackEntry[stacked];
            exit = Math.min(stackExit[stacked], farthest);
        }
    }

    private void paintLeaf(long leaf) {
        int[] leafTriangles = tree.leafTriangles();
        int from = KDNode.first(leaf);
        int to = from + KDNode.count(leaf);
        boolean changed = false;
        for (int i = from; i < to; i++) {
            int triangle = leafTriangles[i];
            if (painted[triangle] != tile) {
                painted[triangle] = tile;
                met++;
                changed |= paint(triangle);
            }
        }
        if (changed && uncovered == 0) {
            double least = Double.POSITIVE_INFINITY;
            for (int i = 0; i < width * height; i++) {
                least = nearest[i] < least ? nearest[i] : least;
            }
            leastInverse = least;
            farthest = 1.0 / least * (1.0 + WIDER);
        }
    }

    /** Paints a triangle into the tile; gives whether any pixel took it. */
    private boolean paint(int triangle) {
        // The corners in grid coordinates, from the tile's own corner.
        float[] c = corners;
        double[] m = toGrid;
        int base = 9 * triangle;
        double x = c[base] - origin[0];
        double y = c[base + 1] - origin[1];
        double z = c[base + 2] - origin[2];
        double az = m[0] * x + m[1] * y + m[2] * z;
        double ax = m[3] * x + m[4] * y + m[5] * z - left * az;
        double ay = m[6] * x + m[7] * y + m[8] * z - top * az;
        x = c[base + 3] - origin[0];
        y = c[base + 4] - origin[1];
        z = c[base + 5] - origin[2];
        double bz = m[0] * x + m[1] * y + m[2] * z;
        double bx = m[3] * x + m[4] * y + m[5] * z - left * bz;
        double by = m[6] * x + m[7] * y + m[8] * z - top * bz;
        x = c[base + 6] - origin[0];
        y = c[base + 7] - origin[1];
        z = c[base + 8] - origin[2];
        double cz = m[0] * x + m[1] * y + m[2] * z;
        double cx = m[3] * x + m[4] * y + m[5] * z - left * cz;
        double cy = m[6] * x + m[7] * y + m[8] * z - top * cz;
        int lastColumn = width - 1;
        int lastRow = height - 1;
        if (ax < 0.0 && bx < 0.0 && cx < 0.0
                || ay < 0.0 && by < 0.0 && cy < 0.0
                || ax > lastColumn * az && bx > lastColumn * bz && cx > lastColumn * cz
                || ay > lastRow * az && by > lastRow * bz && cy > lastRow * cz) {
            return false;
        }

        // The triangle's plane, and the inverse ray parameter of each pixel on it: r + x * rx + y * ry.
        double nx = (by - ay) * (cz - az) - (bz - az) * (cy - ay);
        double ny = (bz - az) * (cx - ax) - (bx - ax) * (cz - az);
        double nz = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
        double volume = ax * nx + ay * ny + az * nz;
        if (Math.abs(volume) <= IN_PLANE * (Math.abs(ax * nx) + Math.abs(ay * ny) + Math.abs(az * nz))
                && mayHoldOrigin(triangle)) {
            // Every pixel sees it at no distance, and the edge functions say nothing: single rays know.
            met = TOO_MANY;
            return false;
        }
        double inverse = 1.0 / volume;
        double r = nz * inverse;
        double rx = nx * inverse;
        double ry = ny * inverse;
        if (!(r + Math.max(0.0, lastColumn * rx) + Math.max(0.0, lastRow * ry) > leastInverse)) {
            return false;
        }

        // Edge functions, turned so that inside is above zero for what lies before the origin.
        double turn = volume < 0.0 ? -1.0 : 1.0;
        double ex = turn * (by * cz - bz * cy);
        double ey = turn * (bz * cx - bx * cz);
        double e = turn * (bx * cy - by * cx);
        double fx = turn * (cy * az - cz * ay);
        double fy = turn * (cz * ax - cx * az);
        double f = turn * (cx * ay - cy * ax);
        double gx = turn * (ay * bz - az * by);
        double gy = turn * (az * bx - ax * bz);
        double g = turn * (ax * by - ay * bx);
        if (e + Math.max(0.0, lastColumn * ex) + Math.max(0.0, lastRow * ey) < 0.0
                || f + Math.max(0.0, lastColumn * fx) + Math.max(0.0, lastRow * fy) < 0.0
                || g + Math.max(0.0, lastColumn * gx) + Math.max(0.0, lastRow * gy) < 0.0) {
            return false;
        }

        int fromRow = 0;
        int toRow = lastRow;
        if (az > 0.0 && bz > 0.0 && cz > 0.0) {
            double yA = ay / az;
            double yB = by / bz;
            double yC = cy / cz;
            double high = Math.min(yA, Math.min(yB, yC));
            double low = Math.max(yA, Math.max(yB, yC));
            fromRow = high > 0.0 ? (int) (high + (1.0 - NEAR_EDGE)) : 0;
            toRow = low < lastRow ? (int) (low + NEAR_EDGE) : lastRow;
        }
        double atE = -1.0 / ex;
        double atF = -1.0 / fx;
        double atG = -1.0 / gx;
        boolean taken = false;
        for (int row = fromRow; row <= toRow; row++) {
            // The columns between the edges; a rising edge function bounds them from the left.
            double eRow = e + row * ey;
            double fRow = f + row * fy;
            double gRow = g + row * gy;
            double from = 0.0;
            double to = lastColumn;
            double at = eRow * atE;
            if (atE < 0.0) {
                from = at > from ? at : from;
            } else {
                to = at < to ? at : to;
            }
            at = fRow * atF;
            if (atF < 0.0) {
                from = at > from ? at : from;
            } else {
                to = at < to ? at : to;
            }
            at = gRow * atG;
            if (atG < 0.0) {
                from = at > from ? at : from;
            } else {
                to = at < to ? at : to;
            }
            if (from > to + NEAR_EDGE) {
                continue;
            }
            int first = (int) (from + (1.0 - NEAR_EDGE));
            int last = (int) (to + NEAR_EDGE);
            // Where an edge passes a pixel's centre within rounding, its sign decides.
            if (Math.abs(first - from) <= NEAR_EDGE
                    && first <= last
                    && (eRow + first * ex < 0.0 || fRow + first * fx < 0.0 || gRow + first * gx < 0.0)) {
                first++;
            }
            if (Math.abs(to - last) <= NEAR_EDGE
                    && first <= last
                    && (eRow + last * ex < 0.0 || fRow + last * fx < 0.0 || gRow + last * gx < 0.0)) {
                last--;
            }
            taken |= paintRow(row * width, first, last, r + row * ry, rx, triangle);
        }
        return taken;
    }

    private boolean mayHoldOrigin(int triangle) {
        boolean inside = true;
        for (int axis = 0; axis < 3; axis++) {
            float a = corners[9 * triangle + axis];
            float b = corners[9 * triangle + 3 + axis];
            float c = corners[9 * triangle + 6 + axis];
            inside &= origin[axis] >= Math.min(a, Math.min(b, c)) && origin[axis] <= Math.max(a, Math.max(b, c));
        }
        return inside;
    }

    private boolean paintRow(int start, int first, int last, double inverse, double step, int triangle) {
        boolean taken = false;
        for (int column = first; column <= last; column++) {
            double here = inverse + column * step;
            int pixel = start + column;
            if (here > nearest[pixel]) {
                uncovered -= nearest[pixel] == 0.0 ? 1 : 0;
                nearest[pixel] = here;
                triangles[pixel] = triangle;
                taken = true;
            }
        }
        return taken;
    }

    /**
     * Does what {@link #trace} does, pixel by pixel: faster where triangles are much smaller than pixels.
     *
     * @param firstColumn column of its left pixels
     * @param firstRow row of its top pixels
     * @param columns 1 to {@link #WIDTH}
     * @param rows 1 to {@link #HEIGHT}
     */
    public void traceSingly(int firstColumn, int firstRow, int columns, int rows) {
        setTile(firstColumn, firstRow, columns, rows);
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                int x = left + column;
                int y = top + row;
                boolean hit = single.closestHit(
                        origin[0],
                        origin[1],
                        origin[2],
                        grid[0] + x * grid[3] + y * grid[6],
                        grid[1] + x * grid[4] + y * grid[7],
                        grid[2] + x * grid[5] + y * grid[8],
                        0.0,
                        Double.POSITIVE_INFINITY);
                int pixel = row * width + column;
                nearest[pixel] = hit ? 1.0 / Math.abs(single.distance()) : 0.0;
                triangles[pixel] = hit ? single.triangle() : 0;
            }
        }
    }
}
