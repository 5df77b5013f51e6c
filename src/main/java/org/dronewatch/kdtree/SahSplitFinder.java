package org.dronewatch.kdtree;

import java.util.Arrays;
import java.util.Optional;

/**
 * Finds the cheapest plane to split a cell, by sweeping a plane along each axis. The cost changes only at planes at
 * which a triangle starts or ends, or in which a triangle lies: these events are sorted, and their planes are tried.
 * Instead of a face of the cell in which triangles lie, the plane next to it is tried.
 *
 * <p>Where there are many triangles, they are first counted in equal slices of each axis. The counts bound the cost of
 * any plane in a slice from below, so that only slices which may hold the cheapest plane are sorted and swept: the
 * result is the same as that of the full sweep. The benchmark {@code TreeBuild} shows how much this gains.
 *
 * <p>Boxes and cells are given as grid numbers (see {@link KDNode}), the boxes of triangles rounded outwards. On the
 * grid, the sweep is exact: what it counts on each side is what {@link Split} will put there. A triangle that lies in a
 * plane between two grid values is a thin box here, and both of its sides are tried. For use by one thread.
 */
final class SahSplitFinder {
    /** How many numbers a box has: minimum on three axes, then maximum. */
    static final int BOX = 6;

    private static final int END = 0;
    private static final int PLANAR = 1;
    private static final int START = 2;

    /** The number of triangles from which slices are counted first. */
    private static final int MANY = 64;

    private static final int SLICES = 128;
    /** A slice's index is rounded, and so are its bounds. */
    private static final double LESS = 1.0 - 1e-9;

    private int[] events = new int[0];
    private final AxisSlices[] slices = {new AxisSlices(), new AxisSlices(), new AxisSlices()};

    private final SahCost costs;
    private final CheapestSplit cheapest;

    SahSplitFinder(SahCost costs) {
        this.costs = costs;
        this.cheapest = new CheapestSplit(costs);
    }

    /**
     * The cheapest split of a cell; of equally cheap ones, the one on the first axis, and on that axis the lowest.
     *
     * @param boxes the triangles' boxes clipped to the cell, {@link #BOX} numbers each
     * @param count how many triangles there are
     * @param voxel the cell's box
     * @return the cheapest split, or empty when none of these planes lies inside the cell or the cell has no surface
     */
    Optional<Split> find(int[] boxes, int count, int[] voxel) {
        if (!cheapest.begin(voxel)) {
            return Optional.empty();
        }
        if (events.length < 2 * count) {
            events = new int[2 * count];
        }
        for (int axis = 0; axis < 3; axis++) {
            cheapest.setAxis(axis);
            tryBesideFaces(boxes, count, axis, voxel);
        }
        if (count < MANY) {
            for (int axis = 0; axis < 3; axis++) {
                cheapest.setAxis(axis);
                sweep(0, fillEvents(boxes, count, axis), 0, count);
            }
        } else {
            findInSlices(boxes, count);
        }
        return cheapest.split();
    }

    private int fillEvents(int[] boxes, int count, int axis) {
        int size = 0;
        for (int i = 0; i < count; i++) {
            int low = boxes[BOX * i + axis];
            int high = boxes[BOX * i + axis + 3];
            if (low == high) {
                events[size++] = KDNode.event(low, PLANAR);
            } else {
                events[size++] = KDNode.event(low, START);
                events[size++] = KDNode.event(high, END);
            }
        }
        Arrays.sort(events, 0, size);
        return size;
    }

    /**
     * Tries the planes of sorted events.
     *
     * @param from the first event
     * @param size where the events end
     * @param left how many triangles start or lie before the first event
     * @param right how many end or lie at it or after it
     */
    private void sweep(int from, int size, int left, int right) {
        int before = left;
        int after = right;
        int next = from;
        while (next < size) {
            // All events of one plane, in the order end, planar, start.
            int key = KDNode.eventKey(events[next]);
            int ended = runLength(next, size, KDNode.event(key, END));
            next += ended;
            int planar = runLength(next, size, KDNode.event(key, PLANAR));
            next += planar;
            int started = runLength(next, size, KDNode.event(key, START));
            next += started;

            after -= ended + planar;
            cheapest.tryPlane(key, before, planar, after);
            before += started + planar;
        }
    }

    /**
     * Tries to cut off triangles that lie in a face of the cell, one step of the grid inside it: floors and walls would
     * otherwise share the air in front of them, and rays through the air would test them all. The slice of one step has
     * no plane inside, so it is not cut in this way again.
     */
    private void tryBesideFaces(int[] boxes, int count, int axis, int[] voxel) {
        boolean inLowFace = false;
        boolean inHighFace = false;
        for (int box = axis; box < BOX * count; box += BOX) {
            if (boxes[box] == boxes[box + 3]) {
                inLowFace |= boxes[box] == voxel[axis];
                inHighFace |= boxes[box] == voxel[axis + 3];
            }
        }
        if (inLowFace) {
            tryCounted(boxes, count, axis, voxel[axis] + 1);
        }
        if (inHighFace) {
            tryCounted(boxes, count, axis, voxel[axis + 3] - 1);
        }
    }

    /** Tries a plane after counting what lies on its sides. */
    private void tryCounted(int[] boxes, int count, int axis, int key) {
        int left = 0;
        int planar = 0;
        int right = 0;
        for (int box = axis; box < BOX * count; box += BOX) {
            left += boxes[box] < key ? 1 : 0;
            planar += boxes[box] == key && boxes[box + 3] == key ? 1 : 0;
            right += boxes[box + 3] > key ? 1 : 0;
        }
        cheapest.tryPlane(key, left, planar, right);
    }

    private int runLength(int from, int size, int event) {
        int end = from;
        while (end < size && events[end] == event) {
            end++;
        }
        return end - from;
    }

    /** Sweeps the most promising slice first, then all that may be better than what it holds. */
    private void findInSlices(int[] boxes, int count) {
        int bestSlice = 0;
        int sliceAxis = 0;
        for (int axis = 0; axis < 3; axis++) {
            cheapest.setAxis(axis);
            slices[axis].count(boxes, count, axis);
            int promising = slices[axis].mostPromising();
            if (slices[axis].bound[promising] < slices[sliceAxis].bound[bestSlice]) {
                bestSlice = promising;
                sliceAxis = axis;
            }
        }
        cheapest.setAxis(sliceAxis);
        slices[sliceAxis].sweepBelow(boxes, count, sliceAxis, Math.nextUp(slices[sliceAxis].bound[bestSlice]));
        for (int axis = 0; axis < 3; axis++) {
            cheapest.setAxis(axis);
            slices[axis].sweepBelow(boxes, count, axis, Math.nextUp(cheapest.cost()));
        }
    }

    /** How many triangles start and end in equal slices of a cell along one axis. */
    private final class AxisSlices {
        private final int[] starts = new int[SLICES];
        private final int[] ends = new int[SLICES];
        /** What a split in each slice costs at least. */
        private final double[] bound = new double[SLICES];
        /** Whether it remains to be swept. */
        private final boolean[] open = new boolean[SLICES];

        private double origin;
        private double perMetre;

        void count(int[] boxes, int count, int axis) {
            Arrays.fill(starts, 0);
            Arrays.fill(ends, 0);
            origin = cheapest.lowest();
            double length = cheapest.highest() - origin;
            perMetre = length > 0.0 ? SLICES / length : 0.0;
            for (int i = 0; i < count; i++) {
                starts[slice(boxes[BOX * i + axis])]++;
                ends[slice(boxes[BOX * i + axis + 3])]++;
            }
            int before = 0;
            int after = count;
            double width = length / SLICES;
            for (int slice = 0; slice < SLICES; slice++) {
                boolean holdsEvents = starts[slice] + ends[slice] > 0;
                after -= ends[slice];
                double cost = costs.split(
                        cheapest.leftShare(origin + slice * width),
                        cheapest.rightShare(origin + (slice + 1) * width),
                        before,
                        after);
                open[slice] = holdsEvents;
                bound[slice] = holdsEvents ? cost * LESS : Double.POSITIVE_INFINITY;
                before += starts[slice];
            }
        }

        /** The slice of a plane: never falls when the plane rises. */
        private int slice(int key) {
            return Math.max(0, Math.min(SLICES - 1, (int) ((KDNode.value(key) - origin) * perMetre)));
        }

        int mostPromising() {
            int best = 0;
            for (int slice = 1; slice < SLICES; slice++) {
                best = bound[slice] < bound[best] ? slice : best;
            }
            return best;
        }

        /** Sweeps all slices whose bound is below a cost, but those that have been swept. */
        void sweepBelow(int[] boxes, int count, int axis, double cost) {
            boolean any = false;
            boolean[] chosen = new boolean[SLICES];
            for (int slice = 0; slice < SLICES; slice++) {
                chosen[slice] = open[slice] && bound[slice] < cost;
                any |= chosen[slice];
                open[slice] &= !chosen[slice];
            }
            if (!any) {
                return;
            }
            int size = 0;
            for (int i = 0; i < count; i++) {
                int low = boxes[BOX * i + axis];
                int high = boxes[BOX * i + axis + 3];
                if (low == high) {
                    if (chosen[slice(low)]) {
                        events[size++] = KDNode.event(low, PLANAR);
                    }
                } else {
                    if (chosen[slice(low)]) {
                        events[size++] = KDNode.event(low, START);
                    }
                    if (chosen[slice(high)]) {
                        events[size++] = KDNode.event(high, END);
                    }
                }
            }
            Arrays.sort(events, 0, size);
            sweepSlices(size, count, chosen);
        }

        /** The events of a slice follow each other; what lies before it is in the counts. */
        private void sweepSlices(int size, int count, boolean[] chosen) {
            int before = 0;
            int after = count;
            int next = 0;
            for (int slice = 0; slice < SLICES; slice++) {
                if (chosen[slice]) {
                    int end = next;
                    while (end < size && slice(KDNode.eventKey(events[end])) == slice) {
                        end++;
                    }
                    sweep(next, end, before, after);
                    next = end;
                }
                before += starts[slice];
                after -= ends[slice];
            }
        }
    }
}
