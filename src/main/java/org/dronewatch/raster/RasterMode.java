package org.dronewatch.raster;

import org.dronewatch.kdtree.LeafOrderTriangles;

/**
 * How tiles are painted, by the number of a model's triangles. With and without vectors all is the same, bit for bit. Few and
 * many, too, but where a tile is given up and traced by single rays, which round differently in the last bits (many meet more
 * triangles), and where triangles are seen edge-on, whose distances are roundings.
 */
enum RasterMode {
    /** Leaf by leaf, triangle by triangle. */
    FEW(1),
    /** Forty leaves, some eighty triangles at a time: cells so small are not worth to be asked whether they are seen. */
    MANY(79),
    /**
     * So, and triangles and pixels four at a time by vector instructions. The leaves have to be the same as without, since
     * threads change over at different times: who paints more leaves comes upon other roundings of triangles seen edge-on.
     */
    MANY_BY_VECTORS(MANY.nodesPaintedWhole) {
        @Override
        TriangleSetup painter(LeafOrderTriangles triangles, PixelGrid grid, TileBuffer pixels) {
            return new VectorTriangleSetup(triangles, grid, pixels, new VectorRasteriser(pixels));
        }
    };

    /** How many triangles are many. */
    static final int MANY_TRIANGLES = 500_000;

    private final int nodesPaintedWhole;

    RasterMode(int nodesPaintedWhole) {
        this.nodesPaintedWhole = nodesPaintedWhole;
    }

    /** The way that suits a model, to begin with. */
    static RasterMode of(int triangles) {
        return triangles < MANY_TRIANGLES ? FEW : MANY;
    }

    /** What paints triangles. */
    TriangleSetup painter(LeafOrderTriangles triangles, PixelGrid grid, TileBuffer pixels) {
        return new TriangleSetup(triangles, grid, pixels, new ScanlineRasteriser(pixels));
    }

    /** Parts of a tree that have no more nodes than this, leaves included, are painted whole, if anything of them is seen. */
    int nodesPaintedWhole() {
        return nodesPaintedWhole;
    }
}
