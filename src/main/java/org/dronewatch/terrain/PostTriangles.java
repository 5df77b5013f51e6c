package org.dronewatch.terrain;

/**
 * Triangles whose corners are posts.
 *
 * @param corners three posts of each, by row * columns + column, clockwise on a map whose rows go south
 * @param error the greatest vertical distance of a post from the triangle that it lies in, m
 */
record PostTriangles(int[] corners, double error) {
    /** All triangles of all squares, cut along the north-west diagonal; none where a post has no height. */
    static PostTriangles all(Posts posts) {
        int columns = posts.columns();
        int[] corners = new int[3 * countAll(posts)];
        int count = 0;
        for (int row = 0; row < posts.rows() - 1; row++) {
            for (int column = 0; column < columns - 1; column++) {
                int post = row * columns + column;
                if (posts.hasSouthWest(post)) {
                    corners[count++] = post;
                    corners[count++] = post + columns + 1;
                    corners[count++] = post + columns;
                }
                if (posts.hasNorthEast(post)) {
                    corners[count++] = post;
                    corners[count++] = post + 1;
                    corners[count++] = post + columns + 1;
                }
            }
        }
        return new PostTriangles(corners, 0.0);
    }

    /** How many triangles there are if every post is kept. */
    static int countAll(Posts posts) {
        int columns = posts.columns();
        int count = 0;
        for (int row = 0; row < posts.rows() - 1; row++) {
            for (int column = 0; column < columns - 1; column++) {
                int post = row * columns + column;
                count += (posts.hasSouthWest(post) ? 1 : 0) + (posts.hasNorthEast(post) ? 1 : 0);
            }
        }
        return count;
    }

    int count() {
        return corners.length / 3;
    }
}
