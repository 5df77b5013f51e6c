package org.dronewatch.kdtree;

import java.util.Arrays;

/**
 * Finds what the pixels of a tile of a picture see. All rays of a tile share their origin, and their directions lie on a
 * regular grid: so the tree is descended once for the whole tile, with the interval of ray parameters in which any of its
 * rays is inside a cell, and each triangle on the way is painted into the tile, nearest surface wins. One per thread.
 *
 * <p>What it buys: a ray of its own costs a descent and a handful of triangle tests, a pixel of a tile a few additions.
 * The benchmark {@code PictureTracing} shows the ratio. It pays while triangles are not much smaller than pixels; a tile
 * that has met {@link #TRIANGLES_PER_PIXEL} times as many triangles as it has pixels is traced ray by ray instead. Cells
 * that lie between or behind all that the pixels see are left out ({@link TileSight}).
 */
public final class TileTraversal {
    /** The most pixels of a tile in a row. */
    public static final int WIDTH = 128;
    /** The most rows of a tile. */
    public static final int HEIGHT = 64;
    /** How many triangles a tile may meet for each of its pixels before single rays are cheaper. */
    static final double TRIANGLES_PER_PIXEL = 8.0;

    /**
     * How many triangles a model has that is painted by vectors: they pay once the compiler has worked for a quarter of a
     * second, and such a tree takes longer than that to build.
     */
    private static final int MANY = 500_000;

    /** How many triangles are remembered as painted, a power of two. */
    private static final int REMEMBERED = 1024;
    /** Numbers that make a box. */
    private static final int BOX = 6;
    /** Widens the interval of a cell by more than the roundings of its bounds. */
    private static final double WIDER = 1e-12;

    private final KDTree tree;
    private final KDTraversal single;
    private final PixelGrid grid = new PixelGrid();
    private final TilePixels pixels = new TilePixels(grid, WIDTH, HEIGHT);
    private final TileSight sight = new TileSight(grid, pixels);
    private final TilePainter painter;

    /** The ray parameter beyond which the tile sees nothing any more. */
    private double farthest;

    /**
     * Triangles that were painted into this tile lately, each in the place of its lowest bits: triangles lie in many leaves.
     * One that was forgotten is painted again, which changes nothing, and counts as met again.
     */
    private final int[] painted = new int[REMEMBERED];

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

    /** The box of the cell that is walked, and of those on the stack: minimum on three axes, then maximum. */
    private final double[] cell = new double[BOX];

    private final double[] stackCells;

    /** A traversal of a tree for the use of one thread. */
    public TileTraversal(KDTree tree) {
        this(tree, tree.mesh().triangleCount() >= MANY && Vectors.areAvailable());
    }

    /** A traversal that paints by vector instructions or does not: what the pixels see is the same. */
    TileTraversal(KDTree tree, boolean byVectors) {
        this.tree = tree;
        this.single = new StackTraversal(tree);
        TileLines lines = byVectors ? new VectorTileLines(pixels) : new TileLines(pixels);
        this.painter = new TilePainter(tree.corners(), grid, pixels, lines);
        int size = tree.depth() + 1;
        this.stackNode = new int[size];
        this.stackEntry = new double[size];
        this.stackExit = new double[size];
        this.stackCells = new double[BOX * size];
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
        grid.set(from, corner, right, down);
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
        pixels.begin(firstColumn, firstRow, columns, rows);
        sight.begin();
        painter.begin();
        farthest = Double.POSITIVE_INFINITY;
        met = 0;
        Arrays.fill(painted, -1);
        setDirections(firstColumn, firstRow, columns, rows);
        if (!descend((int) (TRIANGLES_PER_PIXEL * columns * rows) + 1)) {
            traceSingly(firstColumn, firstRow, columns, rows);
        }
    }

    /** Whether a pixel of the last tile, counted from its own corner, sees a triangle. */
    public boolean hits(int column, int row) {
        return pixels.hits(column, row);
    }

    /** Ray parameter of what a pixel of the last tile sees; infinity for nothing. */
    public double parameter(int column, int row) {
        return pixels.parameter(column, row);
    }

    /** What a pixel of the last tile sees, if it sees anything. */
    public int triangle(int column, int row) {
        return pixels.triangle(column, row);
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
        pixels.copyDistances(target, first, rowLength);
    }

    /** The range of the rays' steps along each axis is that of the tile's corners: they are a grid. */
    private void setDirections(int left, int top, int columns, int rows) {
        for (int axis = 0; axis < 3; axis++) {
            double atCorner = grid.direction(left, top, axis);
            double across = (columns - 1) * grid.right(axis);
            double downwards = (rows - 1) * grid.down(axis);
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
     * @param limit how many triangles are worth painting
     * @return false when there are more, or one that cannot be painted
     */
    private boolean descend(int limit) {
        double entry = 0.0;
        double exit = Double.POSITIVE_INFINITY;
        double[] origin = grid.origin;
        float[] box = tree.rootBox();
        for (int axis = 0; axis < 3; axis++) {
            cell[axis] = box[axis];
            cell[axis + 3] = box[axis + 3];
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
        int stacked = 0;
        int index = 0;
        while (true) {
            long node = nodes[index];
            int axis = KDNode.kind(node);
            while (axis != KDNode.LEAF) {
                // The origin's side is the nearer one. Where a parameter is not a number the origin lies in the plane:
                // the comparisons then visit both sides.
                double plane = KDNode.split(node);
                double toPlane = plane - origin[axis];
                int near = index + 1;
                int far = KDNode.rightChild(node);
                int side = 2 * axis;
                int nearFace = axis + 3;
                int farFace = axis;
                if (toPlane < 0.0) {
                    far = near;
                    near = KDNode.rightChild(node);
                    side++;
                    nearFace = axis;
                    farFace = axis + 3;
                }
                double firstMeets = toPlane * first[side];
                double lastMeets = toPlane * last[side];
                if (firstMeets > exit) {
                    index = near;
                    cell[nearFace] = plane;
                } else if (lastMeets < entry) {
                    index = far;
                    cell[farFace] = plane;
                } else {
                    stackNode[stacked] = far;
                    stackEntry[stacked] = firstMeets > entry ? firstMeets : entry;
                    stackExit[stacked] = exit;
                    System.arraycopy(cell, 0, stackCells, BOX * stacked, BOX);
                    stackCells[BOX * stacked + farFace] = plane;
                    stacked++;
                    index = near;
                    cell[nearFace] = plane;
                    exit = lastMeets < exit ? lastMeets : exit;
                }
                node = nodes[index];
                axis = KDNode.kind(node);
            }

            if (KDNode.count(node) > 0 && sight.reaches(cell, 0)) {
                paintLeaf(node);
            }
            if (met > limit || painter.isLost()) {
                return false;
            }
            do {
                if (stacked == 0) {
                    return true;
                }
                stacked--;
            } while (!isWorthWhile(stacked));
            System.arraycopy(stackCells, BOX * stacked, cell, 0, BOX);
            index = stackNode[stacked];
            entry = stackEntry[stacked];
            exit = Math.min(stackExit[stacked], farthest);
        }
    }

    /** Whether the tile may see something in a cell on the stack. A leaf's cell is looked at when its turn has come. */
    private boolean isWorthWhile(int stacked) {
        if (stackEntry[stacked] > farthest) {
            return false;
        }
        long node = tree.nodes()[stackNode[stacked]];
        return KDNode.kind(node) == KDNode.LEAF ? KDNode.count(node) > 0 : sight.reaches(stackCells, BOX * stacked);
    }

    private void paintLeaf(long leaf) {
        int[] leafTriangles = tree.leafTriangles();
        int from = KDNode.first(leaf);
        int to = from + KDNode.count(leaf);
        for (int i = from; i < to; i++) {
            int triangle = leafTriangles[i];
            int place = triangle & (REMEMBERED - 1);
            if (painted[place] != triangle) {
                painted[place] = triangle;
                met++;
                painter.paint(triangle);
            }
        }
        farthest = pixels.farthest() * (1.0 + WIDER);
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
        pixels.begin(firstColumn, firstRow, columns, rows);
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                boolean hit = single.closestHit(
                        grid.origin[0],
                        grid.origin[1],
                        grid.origin[2],
                        grid.direction(firstColumn + column, firstRow + row, 0),
                        grid.direction(firstColumn + column, firstRow + row, 1),
                        grid.direction(firstColumn + column, firstRow + row, 2),
                        0.0,
                        Double.POSITIVE_INFINITY);
                if (hit) {
                    pixels.set(column, row, Math.abs(single.distance()), single.triangle());
                }
            }
        }
    }
}
