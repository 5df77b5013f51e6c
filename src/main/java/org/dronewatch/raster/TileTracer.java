package org.dronewatch.raster;

import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.kdtree.StackTraversal;
import org.dronewatch.parallel.VectorInstructions;

/**
 * A rasteriser of image tiles: finds the nearest triangle for each pixel of a tile. All rays of a tile have the same
 * origin, and their directions lie on a regular grid, so the tree is descended once for the whole tile, with the
 * interval of ray parameters in which any of its rays is inside a cell, and each triangle on the path is rasterised
 * into the tile; the nearest surface wins. For use by one thread.
 *
 * <p>A separate ray costs a descent and several triangle tests, a pixel of a tile only a few additions. Tiles are
 * faster unless triangles are much smaller than pixels: a tile that has met eight times as many triangles as it has
 * pixels is traced ray by ray instead. Cells that lie behind the triangles found for all pixels, or between the centres
 * of the pixels, are skipped.
 */
public final class TileTracer {
    /** The largest number of columns of a tile. */
    public static final int WIDTH = 128;
    /** The largest number of rows of a tile. */
    public static final int HEIGHT = 64;
    /** How many triangles a tile may meet for each of its pixels before single rays are cheaper. */
    static final double TRIANGLES_PER_PIXEL = 8.0;

    private final KDTree tree;
    private final RayTracer single;
    private final boolean singlyOnly;
    private final PixelGrid grid = new PixelGrid();
    private final TileBuffer pixels = new TileBuffer(grid, WIDTH, HEIGHT);
    private RasterMode mode;
    private TileDescent descent;
    private double near;
    private double far = Double.POSITIVE_INFINITY;
    private final RasterWarmup warmup;

    /**
     * A tracer of a tree, for use by one thread, with the process-wide warm-up counter
     * ({@link RasterWarmup#OF_PROCESS}).
     */
    public TileTracer(KDTree tree) {
        this(tree, RasterWarmup.OF_PROCESS);
    }

    /**
     * A tracer of a tree for use by one thread.
     *
     * @param warmup counter of the pixels of large models that are drawn without vector instructions; these
     *     instructions are used once enough pixels have been drawn for them to pay off
     */
    public TileTracer(KDTree tree, RasterWarmup warmup) {
        this(tree, RasterMode.of(tree.mesh().triangleCount()), warmup);
    }

    /**
     * A tracer that traces each pixel's ray separately, for use by one thread.
     *
     * @param single traces rays in the tree
     */
    public static TileTracer singly(KDTree tree, RayTracer single) {
        return new TileTracer(tree, single, true, RasterMode.of(tree.mesh().triangleCount()), RasterWarmup.OF_PROCESS);
    }

    /**
     * A tracer in a mode that need not suit the tree.
     *
     * @param warmup counts pixels of many triangles; once it is over, vectors take over
     */
    TileTracer(KDTree tree, RasterMode mode, RasterWarmup warmup) {
        this(tree, new StackTraversal(tree), false, mode, warmup);
    }

    private TileTracer(KDTree tree, RayTracer single, boolean singlyOnly, RasterMode mode, RasterWarmup warmup) {
        this.tree = tree;
        this.warmup = warmup;
        this.single = single;
        this.singlyOnly = singlyOnly;
        use(mode);
    }

    /** How it rasterises now. */
    RasterMode mode() {
        return mode;
    }

    private void use(RasterMode chosen) {
        mode = chosen;
        LeafRasteriser leaves = new LeafRasteriser(tree.leafTriangles(), mode.setup(tree.triangles(), grid, pixels));
        descent = new TileDescent(tree, grid, pixels, leaves, mode.nodesAtOnce());
    }

    /**
     * Sets the image whose tiles are traced next. The ray of the pixel in a column and a row starts at the origin in
     * the direction corner + column * right + row * down.
     *
     * @param from x, y and z of the origin, m
     * @param corner direction of the ray of the pixel in column 0 and row 0, not necessarily of unit length
     * @param right change of the direction per column
     * @param down change of the direction per row
     * @throws IllegalArgumentException when corner, right and down lie in one plane
     */
    public void setPicture(double[] from, double[] corner, double[] right, double[] down) {
        setPicture(from, corner, right, down, 0.0, Double.POSITIVE_INFINITY);
    }

    /**
     * Sets the image whose tiles are traced next, as {@link #setPicture(double[], double[], double[], double[])},
     * between a near and a far plane.
     *
     * @param nearest the smallest ray parameter that counts, 0 or more
     * @param farthest the largest ray parameter that counts
     * @throws IllegalArgumentException when corner, right and down lie in one plane
     */
    public void setPicture(
            double[] from, double[] corner, double[] right, double[] down, double nearest, double farthest) {
        grid.set(from, corner, right, down);
        near = nearest;
        far = farthest;
    }

    /**
     * Finds the nearest triangle for each pixel of a tile, among the ray parameters that count.
     *
     * @param firstColumn column of the tile's left pixels
     * @param firstRow row of the tile's top pixels
     * @param columns number of columns, 1 to {@link #WIDTH}
     * @param rows number of rows, 1 to {@link #HEIGHT}
     */
    public void trace(int firstColumn, int firstRow, int columns, int rows) {
        if (singlyOnly) {
            traceSingly(firstColumn, firstRow, columns, rows);
            return;
        }
        pixels.begin(firstColumn, firstRow, columns, rows);
        if (mode == RasterMode.MANY && warmup.add((long) columns * rows) && VectorInstructions.areAvailable()) {
            use(RasterMode.MANY_BY_VECTORS);
        }
        int limit = (int) (TRIANGLES_PER_PIXEL * columns * rows) + 1;
        if (!descent.rasterise(limit)) {
            traceSingly(firstColumn, firstRow, columns, rows);
        } else if (near > 0.0 || far < Double.POSITIVE_INFINITY) {
            clip(columns, rows);
        }
    }

    /** Pixels that see something too far see nothing; those that see something too near look past it. */
    private void clip(int columns, int rows) {
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                if (pixels.hits(column, row)) {
                    double parameter = pixels.parameter(column, row);
                    if (parameter < near) {
                        pixels.clear(column, row);
                        traceSingly(column, row);
                    } else if (parameter > far) {
                        pixels.clear(column, row);
                    }
                }
            }
        }
    }

    /**
     * Whether the ray of a pixel hits a triangle, in the tile traced most recently; columns and rows are counted from 0
     * at the tile's upper left corner.
     */
    public boolean hits(int column, int row) {
        return pixels.hits(column, row);
    }

    /**
     * Ray parameter of the hit of a pixel, in the tile traced most recently; infinity if there is none. Columns and
     * rows as for {@link #hits}.
     */
    public double parameter(int column, int row) {
        return pixels.parameter(column, row);
    }

    /**
     * The index in the mesh of the triangle that the ray of a pixel hits, in the tile traced most recently; undefined
     * if there is none. Columns and rows as for {@link #hits}.
     */
    public int triangle(int column, int row) {
        return pixels.triangle(column, row);
    }

    /**
     * Writes the distances of the hits of the pixels of the tile traced most recently: ray parameters times the lengths
     * of the pixels' directions, m. Infinity for pixels without a hit.
     *
     * @param target array to be filled
     * @param first index of the tile's first pixel in the array
     * @param rowLength index difference from one row to the next
     */
    public void copyDistances(float[] target, int first, int rowLength) {
        pixels.copyDistances(target, first, rowLength);
    }

    /**
     * Finds the nearest triangle for each pixel of a tile, as {@link #trace}, but pixel by pixel: faster if triangles
     * are much smaller than pixels.
     *
     * @param firstColumn column of the tile's left pixels
     * @param firstRow row of the tile's top pixels
     * @param columns number of columns, 1 to {@link #WIDTH}
     * @param rows number of rows, 1 to {@link #HEIGHT}
     */
    public void traceSingly(int firstColumn, int firstRow, int columns, int rows) {
        pixels.begin(firstColumn, firstRow, columns, rows);
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                traceSingly(column, row);
            }
        }
    }

    private void traceSingly(int column, int row) {
        boolean hit = single.closestHit(
                grid.origin[0],
                grid.origin[1],
                grid.origin[2],
                grid.direction(pixels.left() + column, pixels.top() + row, 0),
                grid.direction(pixels.left() + column, pixels.top() + row, 1),
                grid.direction(pixels.left() + column, pixels.top() + row, 2),
                near,
                far);
        if (hit) {
            pixels.set(column, row, Math.abs(single.distance()), single.triangle());
        }
    }
}
