package org.dronewatch.bvh;

import java.util.Arrays;

/**
 * Sorts segments with a common origin so that those of similar directions follow each other: directions, scaled to
 * length 1 along their longest axis, lie on one of the faces of a cube, whose square cells are visited along a Hilbert
 * curve. For use by one thread.
 */
final class FanOrder {
    /** How many segments are sorted at a time, at most. */
    static final int MOST = 1 << 16;

    private static final int FACES = 6;

    /** The number that represents a face if a segment is too short or too long for single precision. */
    static final int UNBOUNDED = FACES;

    /** How many segments there are in a cell on average. */
    private static final int PER_CELL = 8;

    /** Lengths whose cubes single precision can bound, m. */
    static final float FARTHEST = 1e10f;

    private static final float NEAREST = 1e-10f;

    private final byte[] faces = new byte[MOST];
    private final float[] across = new float[MOST];
    private final float[] along = new float[MOST];
    private final float[] ends = new float[MOST];
    private final int[] cells = new int[MOST];

    /** The segments in their order: their numbers, directions and ends. */
    private final int[] order = new int[MOST];

    private final float[] sortedAcross = new float[MOST];
    private final float[] sortedAlong = new float[MOST];
    private final float[] sortedEnds = new float[MOST];
    private final int[] faceCounts = new int[FACES];
    private final int[] faceStarts = new int[FACES + 1];
    private final float[] leastAcross = new float[FACES];
    private final float[] mostAcross = new float[FACES];
    private final float[] leastAlong = new float[FACES];
    private final float[] mostAlong = new float[FACES];
    private final HilbertCells[] grids = new HilbertCells[FACES];
    private int[] starts = new int[0];

    FanOrder() {
        for (int face = 0; face < FACES; face++) {
            grids[face] = new HilbertCells();
        }
    }

    /**
     * Sorts segments.
     *
     * @param vectors x, y and z of each
     * @param from the first segment
     * @param count number of segments, up to {@link #MOST}
     */
    void sort(double[] vectors, int from, int count) {
        Arrays.fill(faceCounts, 0);
        Arrays.fill(leastAcross, 1.0f);
        Arrays.fill(leastAlong, 1.0f);
        Arrays.fill(mostAcross, -1.0f);
        Arrays.fill(mostAlong, -1.0f);
        for (int i = 0; i < count; i++) {
            int at = 3 * (from + i);
            project(i, (float) vectors[at], (float) vectors[at + 1], (float) vectors[at + 2]);
        }
        int cellCount = divideFaces();
        if (starts.length < cellCount + 2) {
            starts = new int[cellCount + 2];
        }
        Arrays.fill(starts, 0, cellCount + 2, 0);
        for (int i = 0; i < count; i++) {
            int face = faces[i];
            int cell = face == UNBOUNDED ? cellCount : faceStarts[face] + grids[face].cell(across[i], along[i]);
            cells[i] = cell;
            starts[cell + 1]++;
        }
        for (int cell = 0; cell <= cellCount; cell++) {
            starts[cell + 1] += starts[cell];
        }
        for (int i = 0; i < count; i++) {
            int position = starts[cells[i]]++;
            order[position] = i;
            sortedAcross[position] = across[i];
            sortedAlong[position] = along[i];
            sortedEnds[position] = ends[i];
        }
    }

    private int divideFaces() {
        int cellCount = 0;
        for (int face = 0; face < FACES; face++) {
            faceStarts[face] = cellCount;
            if (faceCounts[face] > 0) {
                cellCount += grids[face].set(
                        leastAcross[face],
                        mostAcross[face],
                        leastAlong[face],
                        mostAlong[face],
                        1 + faceCounts[face] / PER_CELL);
            }
        }
        faceStarts[FACES] = cellCount;
        return cellCount;
    }

    private void project(int segment, float x, float y, float z) {
        float sizeX = Math.abs(x);
        float sizeY = Math.abs(y);
        float sizeZ = Math.abs(z);
        if (sizeZ >= sizeX && sizeZ >= sizeY) {
            project(segment, 4, z, x, y);
        } else if (sizeX >= sizeY) {
            project(segment, 0, x, y, z);
        } else {
            project(segment, 2, y, z, x);
        }
    }

    private void project(int segment, int firstFace, float ahead, float side, float other) {
        float end = Math.abs(ahead);
        if (!(end > NEAREST && end < FARTHEST)) {
            faces[segment] = UNBOUNDED;
            return;
        }
        float scale = 1.0f / end;
        float u = side * scale;
        float v = other * scale;
        int face = ahead < 0.0f ? firstFace + 1 : firstFace;
        faces[segment] = (byte) face;
        across[segment] = u;
        along[segment] = v;
        ends[segment] = end;
        faceCounts[face]++;
        if (u < leastAcross[face]) {
            leastAcross[face] = u;
        }
        if (u > mostAcross[face]) {
            mostAcross[face] = u;
        }
        if (v < leastAlong[face]) {
            leastAlong[face] = v;
        }
        if (v > mostAlong[face]) {
            mostAlong[face] = v;
        }
    }

    /** The segment at a position of the order, counted from the first one. */
    int segment(int position) {
        return order[position];
    }

    /**
     * The face of the cube that a segment crosses: twice the number of its longest axis, plus one if it runs against
     * that axis; or {@link #UNBOUNDED}.
     */
    int face(int segment) {
        return faces[segment];
    }

    /** The position after the last segment that crosses the same face as that at a position. */
    int faceEnd(int position, int count) {
        int face = faces[order[position]];
        return face == UNBOUNDED ? count : starts[faceStarts[face + 1] - 1];
    }

    /**
     * Copies some segments in their order: their numbers, their directions and their lengths along the longest axis, m.
     * A direction is scaled to 1 along that axis; its components are those on the next axis (across) and on the third
     * one (along).
     *
     * @param from the position of the first segment
     */
    void copy(int from, int number, int[] segments, float[] across, float[] along, float[] ends) {
        System.arraycopy(order, from, segments, 0, number);
        System.arraycopy(sortedAcross, from, across, 0, number);
        System.arraycopy(sortedAlong, from, along, 0, number);
        System.arraycopy(sortedEnds, from, ends, 0, number);
    }
}
