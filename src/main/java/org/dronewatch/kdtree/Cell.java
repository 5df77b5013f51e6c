package org.dronewatch.kdtree;

/**
 * A part of space while a tree grows.
 *
 * @param content the triangles in it
 * @param voxel its box, as grid numbers
 * @param level how many splits lie above it
 * @param share the number of the mesh's triangles that are attributed to this cell; each triangle counts once in all,
 *     however many cells it is in
 */
record Cell(NodeTriangles content, int[] voxel, int level, double share) {

    int count() {
        return content.count;
    }

    /** The two parts of a split cell. */
    Halves split(Split split, TriangleClipper clipper) {
        int[] leftVoxel = voxel.clone();
        leftVoxel[split.axis() + 3] = split.key();
        int[] rightVoxel = voxel.clone();
        rightVoxel[split.axis()] = split.key();
        NodeTriangles below = content.part(split, true, leftVoxel, clipper);
        NodeTriangles above = content.part(split, false, rightVoxel, clipper);
        double each = share / Math.max(1.0, (double) below.count + above.count);
        Cell left = new Cell(below, leftVoxel, level + 1, each * below.count);
        Cell right = new Cell(above, rightVoxel, level + 1, each * above.count);
        return new Halves(split, left, right, Math.max(0, left.count() + right.count() - count()));
    }

    /**
     * The two cells into which a cell is split.
     *
     * @param split the split that separates them
     * @param left the cell below the plane
     * @param right the cell above it
     * @param duplicates how many more references the two cells have together than the undivided cell had
     */
    record Halves(Split split, Cell left, Cell right, int duplicates) {

        /** The fraction of a number that is due to one of them: in proportion to its references. */
        long due(long number, Cell half) {
            long both = (long) left.count() + right.count();
            return both == 0 ? 0 : number * half.count() / both;
        }
    }
}
