package org.dronewatch.sensor.radio;

import java.util.Arrays;

/**
 * The straight pieces of a section, and which of them meet at a point. Allocates only when there are more of them than
 * ever before. For use by one thread.
 */
final class SectionPieces {
    private static final int FIRST = 64;

    /** The two points and the triangle of each piece. */
    private int[] pieces = new int[3 * FIRST];

    private int count;

    /**
     * Linked lists of the ends of pieces. For each point, one of the ends that lie there, or -1 for none; for each end
     * of a piece, another end at the same point, or -1.
     */
    private int[] ends = new int[FIRST];

    private int[] nextEnd = new int[2 * FIRST];

    /** Removes all pieces. */
    void clear() {
        count = 0;
    }

    /** Adds a point, at which no piece ends so far; points are added in the order of their numbers. */
    void addPoint(int number) {
        if (number == ends.length) {
            ends = Arrays.copyOf(ends, 2 * number);
        }
        ends[number] = -1;
    }

    /** Adds a piece between two points. */
    void add(int first, int second, int triangle) {
        if (3 * count == pieces.length) {
            pieces = Arrays.copyOf(pieces, 6 * count);
            nextEnd = Arrays.copyOf(nextEnd, 4 * count);
        }
        pieces[3 * count] = first;
        pieces[3 * count + 1] = second;
        pieces[3 * count + 2] = triangle;
        link(first, 2 * count);
        link(second, 2 * count + 1);
        count++;
    }

    private void link(int point, int end) {
        nextEnd[end] = ends[point];
        ends[point] = end;
    }

    int count() {
        return count;
    }

    int start(int piece) {
        return pieces[3 * piece];
    }

    int end(int piece) {
        return pieces[3 * piece + 1];
    }

    int triangle(int piece) {
        return pieces[3 * piece + 2];
    }

    /** One of the pieces that end at a point, as {@link #nextAt} numbers them; -1 if there is none. */
    int firstAt(int point) {
        return ends[point];
    }

    /** Another end of a piece at the same point; -1 after the last. */
    int nextAt(int end) {
        return nextEnd[end];
    }

    /** The other end of a piece that was found at a point. */
    int otherEnd(int end) {
        return (end & 1) == 0 ? end(end >> 1) : start(end >> 1);
    }
}
