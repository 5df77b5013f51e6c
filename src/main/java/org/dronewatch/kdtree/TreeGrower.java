package org.dronewatch.kdtree;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicLong;
import org.dronewatch.parallel.LongTask;
import org.dronewatch.parallel.Workers;

/**
 * Grows parts of a tree. A split duplicates the references to the triangles that cross its plane; a bundle of long thin
 * triangles oblique to the axes could thus exhaust memory of any size. Each part therefore has a limit on its
 * duplicates:
 *
 * <ul>
 *   <li>A part that stays within its limit is the same as it would be without a limit.
 *   <li>Otherwise its root is split all the same, if the limit covers that split; what remains of the limit is divided
 *       between both sides in proportion to their references, and the same holds for each of them. A cell whose split
 *       is not covered becomes a leaf.
 * </ul>
 *
 * <p>Whether a part stays within its limit is found out by growing it until it is complete or exceeds the limit. If it
 * exceeds the limit, the same is tried again only with parts that have at most a quarter of its references, so that
 * this costs at most the same at each level of the tree.
 *
 * <p>All of this depends on the part alone, not on which thread comes first: the tree is the same for any number of
 * them. For use by one thread.
 */
final class TreeGrower {
    /** Parts of fewer triangles are not worth another thread. */
    private static final int WORTH_A_THREAD = 2048;

    /** A part that exceeds its limit is tried again as parts of this fraction of its references. */
    private static final int TRY_AGAIN = 4;

    private final float[] corners;
    private final int depthLimit;
    private final SahCost costs;
    private final LongTask task;
    private final SahSplitFinder splitFinder;
    private final TriangleClipper clipper;

    /**
     * A grower.
     *
     * @param corners nine coordinates a triangle
     * @param costs costs that decide whether a cell is split, and where
     * @param depthLimit the level on which all cells are leaves
     * @param task advances with each triangle of a leaf
     */
    TreeGrower(float[] corners, SahCost costs, int depthLimit, LongTask task) {
        this.corners = corners;
        this.depthLimit = depthLimit;
        this.costs = costs;
        this.task = task;
        this.splitFinder = new SahSplitFinder(costs);
        this.clipper = new TriangleClipper(corners);
    }

    /**
     * Grows a part of a tree.
     *
     * @param cell its root
     * @param duplicates how many references it may have beyond those of its root
     * @throws CancellationException when the thread is interrupted while the tree is built
     */
    Subtree grow(Cell cell, long duplicates) {
        AtomicLong left = new AtomicLong(duplicates);
        Subtree tree = new Subtree();
        appendFreely(tree, cell, left);
        if (left.get() < 0) {
            tree = new Subtree();
            appendSparingly(tree, cell, duplicates, cell.count() / TRY_AGAIN);
        }
        return tree;
    }

    /** Appends all below a cell, or anything once too many duplicates have been made. */
    private void appendFreely(Subtree tree, Cell cell, AtomicLong duplicatesLeft) {
        Optional<Cell.Halves> halves = duplicatesLeft.get() < 0 ? Optional.empty() : split(cell);
        if (halves.isEmpty()) {
            appendLeaf(tree, cell);
            return;
        }
        if (halves.get().duplicates() > 0) {
            duplicatesLeft.addAndGet(-halves.get().duplicates());
        }
        appendHalves(tree, halves.get(), (grower, part, half) -> grower.appendFreely(part, half, duplicatesLeft));
    }

    /** Appends what a limit allows below a cell. */
    private void appendSparingly(Subtree tree, Cell cell, long duplicates, int tryAgain) {
        if (cell.count() <= tryAgain) {
            tree.append(grow(cell, duplicates));
            return;
        }
        Optional<Cell.Halves> found = split(cell).filter(halves -> halves.duplicates() <= duplicates);
        if (found.isEmpty()) {
            appendLeaf(tree, cell);
            return;
        }
        Cell.Halves halves = found.get();
        long left = duplicates - halves.duplicates();
        appendHalves(
                tree,
                halves,
                (grower, part, half) -> grower.appendSparingly(part, half, halves.due(left, half), tryAgain));
    }

    private void appendLeaf(Subtree tree, Cell cell) {
        tree.appendLeaf(cell);
        task.advance(cell.share());
    }

    /** The parts of a cell that is better split than a leaf. */
    private Optional<Cell.Halves> split(Cell cell) {
        if (cell.count() > WORTH_A_THREAD && Thread.currentThread().isInterrupted()) {
            throw new CancellationException("interrupted while a tree was built");
        }
        if (cell.level() >= depthLimit) {
            return Optional.empty();
        }
        return splitFinder
                .find(cell.content().boxes, cell.count(), cell.voxel())
                .filter(split -> split.cost() <= costs.leaf(cell.count()))
                .map(split -> cell.split(split, clipper));
    }

    /** Appends a split: its root, all that is left of it, all that is right of it. */
    private void appendHalves(Subtree tree, Cell.Halves halves, Growth growth) {
        int parent = tree.reserveNode();
        if (Math.min(halves.left().count(), halves.right().count()) < WORTH_A_THREAD || Workers.available() == 1) {
            growth.append(this, tree, halves.left());
            tree.closeInterior(parent, halves.split());
            growth.append(this, tree, halves.right());
        } else {
            Subtree[] parts = {new Subtree(), new Subtree()};
            Workers.both(
                    () -> growth.append(new TreeGrower(corners, costs, depthLimit, task), parts[0], halves.left()),
                    () -> growth.append(new TreeGrower(corners, costs, depthLimit, task), parts[1], halves.right()));
            tree.append(parts[0]);
            tree.closeInterior(parent, halves.split());
            tree.append(parts[1]);
        }
    }

    /** How one half of a split is appended. */
    private interface Growth {
        void append(TreeGrower grower, Subtree tree, Cell half);
    }
}
