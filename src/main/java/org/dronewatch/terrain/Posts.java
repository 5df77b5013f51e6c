package org.dronewatch.terrain;

/**
 * A rectangle of posts in the world frame: where their verticals are, and how high each is. Rows go south and columns
 * east, more or less. Posts without a height are holes.
 */
final class Posts {
    private final int columns;
    private final int rows;
    private final float[] up;
    private final PostFrame frame;

    /**
     * Posts.
     *
     * @param up z of each in the world frame, m, row by row; NaN in a hole; kept, not copied
     * @param frame where a post of a height is
     */
    Posts(int columns, int rows, float[] up, PostFrame frame) {
        this.columns = columns;
        this.rows = rows;
        this.up = up;
        this.frame = frame;
    }

    int columns() {
        return columns;
    }

    int rows() {
        return rows;
    }

    float up(int post) {
        return up[post];
    }

    boolean isHole(int post) {
        return Float.isNaN(up[post]);
    }

    PostFrame frame() {
        return frame;
    }

    /**
     * Whether the triangle of a square north-east of its diagonal, which joins the post and its neighbour south-east,
     * has all its posts.
     *
     * @param post the square's north-western one, not in the last column or row
     */
    boolean hasNorthEast(int post) {
        return !isHole(post) && !isHole(post + 1) && !isHole(post + columns + 1);
    }

    /** Whether the triangle south-west of the diagonal has all its posts. */
    boolean hasSouthWest(int post) {
        return !isHole(post) && !isHole(post + columns) && !isHole(post + columns + 1);
    }

    /** How many of the six triangles about a post there are, and how many of them have all their posts. */
    long around(int post) {
        int column = post % columns;
        int row = post / columns;
        boolean west = column > 0;
        boolean east = column < columns - 1;
        boolean north = row > 0;
        boolean south = row < rows - 1;
        int exist = 0;
        int whole = 0;
        if (east && south) {
            exist += 2;
            whole += (hasNorthEast(post) ? 1 : 0) + (hasSouthWest(post) ? 1 : 0);
        }
        if (west && north) {
            int square = post - columns - 1;
            exist += 2;
            whole += (hasNorthEast(square) ? 1 : 0) + (hasSouthWest(square) ? 1 : 0);
        }
        if (west && south) {
            exist++;
            whole += hasNorthEast(post - 1) ? 1 : 0;
        }
        if (east && north) {
            exist++;
            whole += hasSouthWest(post - columns) ? 1 : 0;
        }
        return (long) exist << 32 | whole;
    }
}
