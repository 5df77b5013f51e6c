package org.dronewatch.terrain;

import org.dronewatch.geo.MapTransform;
import org.dronewatch.terrain.io.Lattice;

/**
 * Posts with the heights that their files state. Rows go south and columns east, so that squares are cut along their
 * north-west diagonal in whatever order a file has them.
 */
record Grid(Lattice lattice, int columns, int rows, float[] heights) {

    /**
     * A grid flipped so that its rows run from north to south and its columns from west to east.
     *
     * @param heights row by row; flipped in place
     */
    static Grid southward(Lattice lattice, int columns, int rows, float[] heights, MapTransform map) {
        Lattice turned = lattice;
        if (turned.rowY() > 0.0) {
            turned = new Lattice(
                    turned.xAt(0, rows - 1),
                    turned.yAt(0, rows - 1),
                    turned.columnX(),
                    turned.columnY(),
                    -turned.rowX(),
                    -turned.rowY());
            for (int row = 0; row < rows / 2; row++) {
                for (int column = 0; column < columns; column++) {
                    swap(heights, row * columns + column, (rows - 1 - row) * columns + column);
                }
            }
        }
        if (turned.columnX() < 0.0) {
            turned = new Lattice(
                    turned.xAt(columns - 1, 0),
                    turned.yAt(columns - 1, 0),
                    -turned.columnX(),
                    -turned.columnY(),
                    turned.rowX(),
                    turned.rowY());
            for (int row = 0; row < rows; row++) {
                for (int column = 0; column < columns / 2; column++) {
                    swap(heights, row * columns + column, row * columns + columns - 1 - column);
                }
            }
        }
        return new Grid(turned, columns, rows, heights);
    }

    private static void swap(float[] values, int one, int other) {
        float kept = values[one];
        values[one] = values[other];
        values[other] = kept;
    }

    /**
     * The posts in the world frame. The heights of this grid become theirs and are no longer those of the files.
     *
     * @param offset added to each height, m
     */
    Posts posts(MapTransform map, double offset) {
        PostFrame frame = new PostFrame(lattice, columns, rows, map);
        PostFrame.Row line = frame.newRow();
        for (int row = 0; row < rows; row++) {
            line.to(row);
            for (int column = 0; column < columns; column++) {
                line.column(column);
                int post = row * columns + column;
                heights[post] = (float) line.up(heights[post] + offset);
            }
        }
        Posts posts = new Posts(columns, rows, heights, frame);
        dropLonely(posts);
        return posts;
    }

    /** Posts that are a corner of no triangle, because their neighbours are holes, become holes. */
    private void dropLonely(Posts posts) {
        for (int post = 0; post < heights.length; post++) {
            if (!posts.isHole(post) && (int) posts.around(post) == 0) {
                heights[post] = Float.NaN;
            }
        }
    }
}
