package org.dronewatch.kdtree;

/** How tiles are painted, by the number of a model's triangles. What the pixels see is the same. */
enum TilePainting {
    /** Leaf by leaf, triangle by triangle. */
    FEW {
        @Override
        TilePainter painter(PlacedTriangles triangles, PixelGrid grid, TilePixels pixels) {
            return new TilePainter(triangles, grid, pixels, new TileLines(pixels));
        }

        @Override
        int nodesPaintedWhole() {
            return 1;
        }
    },
    /** Several leaves at a time: cells so small are not worth to be asked whether they are seen. */
    MANY {
        @Override
        TilePainter painter(PlacedTriangles triangles, PixelGrid grid, TilePixels pixels) {
            return FEW.painter(triangles, grid, pixels);
        }

        @Override
        int nodesPaintedWhole() {
            return NODES_OF_MANY;
        }
    },
    /** So, and triangles and pixels four at a time by vector instructions: in the same order, with the same sums. */
    MANY_BY_VECTORS {
        @Override
        TilePainter painter(PlacedTriangles triangles, PixelGrid grid, TilePixels pixels) {
            return new VectorTilePainter(triangles, grid, pixels, new VectorTileLines(pixels));
        }

        @Override
        int nodesPaintedWhole() {
            return NODES_OF_MANY;
        }
    };

    /**
     * How many triangles are many. Vectors pay once the compiler has worked for a quarter of a second, and such a tree takes
     * longer than that to build.
     */
    static final int MANY_TRIANGLES = 500_000;

    /** Ten leaves, some twenty triangles. */
    private static final int NODES_OF_MANY = 19;

    /** The way that suits a model. */
    static TilePainting of(int triangles) {
        if (triangles < MANY_TRIANGLES) {
            return FEW;
        }
        return Vectors.areAvailable() ? MANY_BY_VECTORS : MANY;
    }

    /** What paints triangles. */
    abstract TilePainter painter(PlacedTriangles triangles, PixelGrid grid, TilePixels pixels);

    /** Parts of a tree that have no more nodes than this, leaves included, are painted whole, if anything of them is seen. */
    abstract int nodesPaintedWhole();
}
