package org.dronewatch.raster;

import org.dronewatch.kdtree.KDNode;
import org.dronewatch.kdtree.KDTree;

/**
 * Descends a tree for all rays of a tile at once, nearer cells first, and rasterises the triangles of those cells in
 * which the tile may see something. For use by one thread.
 */
final class TileDescent {
    /** Numbers of a box. */
    private static final int BOX = 6;
    /** Widens the interval of a cell by more than the rounding errors of its bounds. */
    private static final double WIDER = 1e-12;

    private final KDTree tree;
    private final PixelGrid grid;
    private final TileBuffer pixels;
    private final TileCuller culler;
    private final LeafRasteriser leaves;
    private final int nodesAtOnce;

    /** The ray parameter beyond which the tile sees nothing any more. */
    private double farthest;

    /**
     * The ray parameters per metre at which the first ray of the tile meets a plane, for each axis, first for planes
     * above the origin, then for planes below, and those at which the last ray does; infinite where no ray meets it, or
     * not all rays.
     */
    private final double[] first = new double[6];

    private final double[] last = new double[6];

    /** The subtrees still to be visited: the first of their nodes, the one after the last, and their intervals. */
    private final int[] stackNode;

    private final int[] stackEnd;
    private final double[] stackEntry;
    private final double[] stackExit;

    /** The box of the current cell, and of those on the stack: minimum on three axes, then maximum. */
    private final double[] cell = new double[BOX];

    private final double[] stackCells;

    /**
     * A descent.
     *
     * @param tree what to descend
     * @param grid where the pixels look
     * @param pixels of the tile
     * @param leaves rasterises what leaves hold
     * @param nodesAtOnce subtrees with no more nodes are rasterised as a whole, 1 for leaves
     */
    TileDescent(KDTree tree, PixelGrid grid, TileBuffer pixels, LeafRasteriser leaves, int nodesAtOnce) {
        this.tree = tree;
        this.grid = grid;
        this.pixels = pixels;
        this.culler = new TileCuller(grid, pixels);
        this.leaves = leaves;
        this.nodesAtOnce = nodesAtOnce;
        int size = tree.depth() + 1;
        this.stackNode = new int[size];
        this.stackEnd = new int[size];
        this.stackEntry = new double[size];
        this.stackExit = new double[size];
        this.stackCells = new double[BOX * size];
    }

    private void begin() {
        culler.begin();
        leaves.begin();
        farthest = Double.POSITIVE_INFINITY;
        setDirections();
    }

    /** The range of the rays' steps along each axis is that of the tile's corners: they are a grid. */
    private void setDirections() {
        for (int axis = 0; axis < 3; axis++) {
            double atCorner = grid.direction(pixels.left(), pixels.top(), axis);
            double across = pixels.lastColumn() * grid.right(axis);
            double downwards = pixels.lastRow() * grid.down(axis);
            double low = atCorner + Math.min(across, 0.0) + Math.min(downwards, 0.0);
            double high = atCorner + Math.max(across, 0.0) + Math.max(downwards, 0.0);
            first[2 * axis] = high > 0.0 ? (1.0 - WIDER) / high : Double.POSITIVE_INFINITY;
            last[2 * axis] = low > 0.0 ? (1.0 + WIDER) / low : Double.POSITIVE_INFINITY;
            first[2 * axis + 1] = low < 0.0 ? (1.0 - WIDER) / low : Double.NEGATIVE_INFINITY;
            last[2 * axis + 1] = high < 0.0 ? (1.0 + WIDER) / high : Double.NEGATIVE_INFINITY;
        }
    }

    /**
     * Rasterises what the tile that the pixels have begun can see, nearer cells first. The interval of a cell holds
     * every ray parameter at which any ray of the tile is inside.
     *
     * @param limit how many triangles are worth rasterising
     * @return false when there are more, or one that cannot be rasterised
     */
    boolean rasterise(int limit) {
        begin();
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
        int end = nodes.length;
        while (true) {
            while (end - index > nodesAtOnce) {
                long node = nodes[index];
                int axis = KDNode.kind(node);
                // The origin's side is the nearer one. Where a parameter is not a number the origin lies in the plane:
                // the comparisons then visit both sides.
                double plane = KDNode.split(node);
                double toPlane = plane - origin[axis];
                int near = KDNode.leftChild(index);
                int nearEnd = KDNode.rightChild(node);
                int far = nearEnd;
                int farEnd = end;
                int side = 2 * axis;
                int nearFace = axis + 3;
                int farFace = axis;
                if (toPlane < 0.0) {
                    far = near;
                    near = nearEnd;
                    farEnd = nearEnd;
                    nearEnd = end;
                    side++;
                    nearFace = axis;
                    farFace = axis + 3;
                }
                double firstMeets = toPlane * first[side];
                double lastMeets = toPlane * last[side];
                if (firstMeets > exit) {
                    index = near;
                    end = nearEnd;
                    cell[nearFace] = plane;
                } else if (lastMeets < entry) {
                    index = far;
                    end = farEnd;
                    cell[farFace] = plane;
                } else {
                    stackNode[stacked] = far;
                    stackEnd[stacked] = farEnd;
                    stackEntry[stacked] = firstMeets > entry ? firstMeets : entry;
                    stackExit[stacked] = exit;
                    System.arraycopy(cell, 0, stackCells, BOX * stacked, BOX);
                    stackCells[BOX * stacked + farFace] = plane;
                    stacked++;
                    index = near;
                    end = nearEnd;
                    cell[nearFace] = plane;
                    exit = lastMeets < exit ? lastMeets : exit;
                }
            }

            rasteriseSubtree(index, end);
            if (leaves.met() > limit || leaves.isUnable()) {
                return false;
            }
            do {
                if (stacked == 0) {
                    return true;
                }
                stacked--;
            } while (!isWorthwhile(stacked));
            System.arraycopy(stackCells, BOX * stacked, cell, 0, BOX);
            index = stackNode[stacked];
            end = stackEnd[stacked];
            entry = stackEntry[stacked];
            exit = Math.min(stackExit[stacked], farthest);
        }
    }

    /**
     * Whether the tile may see something in a cell on the stack; subtrees that are rasterised as a whole are tested
     * when their turn comes.
     */
    private boolean isWorthwhile(int stacked) {
        if (stackEntry[stacked] > farthest) {
            return false;
        }
        return stackEnd[stacked] - stackNode[stacked] <= nodesAtOnce || culler.reaches(stackCells, BOX * stacked);
    }

    /** Rasterises a subtree, if the tile may see something in it. Its leaves are contiguous, as its nodes are. */
    private void rasteriseSubtree(int index, int end) {
        long[] nodes = tree.nodes();
        int firstLeaf = index;
        while (KDNode.kind(nodes[firstLeaf]) != KDNode.LEAF) {
            firstLeaf++;
        }
        long lastLeaf = nodes[end - 1];
        int from = KDNode.first(nodes[firstLeaf]);
        int to = KDNode.first(lastLeaf) + KDNode.count(lastLeaf);
        if (to > from && culler.reaches(cell, 0)) {
            leaves.rasterise(from, to);
            farthest = pixels.farthest() * (1.0 + WIDER);
        }
    }
}
