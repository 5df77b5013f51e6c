package org.dronewatch.bench;

import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.StackTraversal;
import org.dronewatch.raster.TileTracer;

/** Traces the rays of a picture tile by tile; a piece is a row of tiles. */
final class PictureTracer implements Tracer {
    private static final int WIDTH = TileTracer.WIDTH;
    private static final int HEIGHT = TileTracer.HEIGHT;

    private final Picture picture;
    private final boolean[][] isTile;
    private final TileTracer traversal;
    private final RaySetTracer single;

    /**
     * A tracer of a picture.
     *
     * @param isTile for each row of tiles, from {@link #tilesOf}: which of them are the picture's
     */
    PictureTracer(KDTree tree, RaySet set, Picture picture, boolean[][] isTile) {
        this.picture = picture;
        this.isTile = isTile;
        this.traversal = new TileTracer(tree);
        this.single = new RaySetTracer(new StackTraversal(tree), set);
        this.traversal.setPicture(picture.origin(), picture.corner(), picture.right(), picture.down());
    }

    /** Compares every ray with that of the picture; tiles in which any ray differs are traced ray by ray. */
    static boolean[][] tilesOf(Picture picture) {
        int across = (picture.width() + WIDTH - 1) / WIDTH;
        boolean[][] isTile = new boolean[(picture.height() + HEIGHT - 1) / HEIGHT][across];
        for (int y = 0; y < isTile.length; y++) {
            for (int x = 0; x < across; x++) {
                int columns = Math.min(WIDTH, picture.width() - x * WIDTH);
                int rows = Math.min(HEIGHT, picture.height() - y * HEIGHT);
                isTile[y][x] = picture.holds(x * WIDTH, y * HEIGHT, columns, rows);
            }
        }
        return isTile;
    }

    @Override
    public int pieces() {
        return isTile.length;
    }

    @Override
    public void trace(int piece, float[] distances, int[] triangles) {
        int top = piece * HEIGHT;
        int rows = Math.min(HEIGHT, picture.height() - top);
        for (int left = 0; left < picture.width(); left += WIDTH) {
            int columns = Math.min(WIDTH, picture.width() - left);
            if (isTile[piece][left / WIDTH]) {
                traversal.trace(left, top, columns, rows);
                copy(left, top, columns, rows, distances, triangles);
            } else {
                traceSingly(left, top, columns, rows, distances, triangles);
            }
        }
    }

    private void copy(int left, int top, int columns, int rows, float[] distances, int[] triangles) {
        traversal.copyDistances(distances, top * picture.width() + left, picture.width());
        for (int row = 0; row < rows; row++) {
            int ray = (top + row) * picture.width() + left;
            for (int column = 0; column < columns; column++) {
                triangles[ray] = traversal.hits(column, row) ? traversal.triangle(column, row) : -1;
                ray++;
            }
        }
    }

    private void traceSingly(int left, int top, int columns, int rows, float[] distances, int[] triangles) {
        for (int row = top; row < top + rows; row++) {
            for (int column = left; column < left + columns; column++) {
                single.traceRay(row * picture.width() + column, distances, triangles);
            }
        }
    }
}
