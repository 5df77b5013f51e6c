package org.dronewatch.raster;

import org.dronewatch.kdtree.LeafOrderTriangles;

/**
 * How tiles are rasterised, depending on the number of a model's triangles. With and without vectors the pixels are the
 * same, bit for bit. Between {@link #FEW} and {@link #MANY} they differ only where a tile is given up and traced by
 * single rays, which round differently in the last bits (those of {@code MANY} meet more triangles), and where
 * triangles are seen edge-on, whose distances are rounding errors.
 */
enum RasterMode {
    /** Leaf by leaf, triangle by triangle. */
    FEW(1),
    /**
     * Forty leaves, some eighty triangles at a time: for cells this small it does not pay to ask whether they are seen.
     */
    MANY(79),
    /**
     * Like {@link #MANY}, but with vector instructions, which take triangles and pixels four at a time. The leaves have
     * to be the same as without vectors, since threads switch to vectors at different times: more leaves at a time
     * would give different rounding errors for triangles seen edge-on.
     */
    MANY_BY_VECTORS(MANY.nodesAtOnce) {
        @Override
        TriangleSetup setup(LeafOrderTriangles triangles, PixelGrid grid, TileBuffer pixels) {
            return new VectorTriangleSetup(triangles, grid, pixels, new VectorRasteriser(pixels));
        }
    };

    /** The number of triangles from which they count as many. */
    static final int MANY_TRIANGLES = 500_000;

    private final int nodesAtOnce;

    RasterMode(int nodesAtOnce) {
        this.nodesAtOnce = nodesAtOnce;
    }

    /** The mode that suits a model, to begin with. */
    static RasterMode of(int triangles) {
        return triangles < MANY_TRIANGLES ? FEW : MANY;
    }

    /** What rasterises triangles. */
    TriangleSetup setup(LeafOrderTriangles triangles, PixelGrid grid, TileBuffer pixels) {
        return new TriangleSetup(triangles, grid, pixels, new ScanlineRasteriser(pixels));
    }

    /**
     * Subtrees with no more nodes than this, leaves included, are rasterised as a whole if any part of them is seen.
     */
    int nodesAtOnce() {
        return nodesAtOnce;
    }
}
