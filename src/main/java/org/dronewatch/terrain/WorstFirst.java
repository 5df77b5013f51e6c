package org.dronewatch.terrain;

import java.util.Arrays;

/** Triangles by their greatest error, the worst first; of equal ones the lowest number. A binary heap. */
final class WorstFirst {
    private static final int ABSENT = -1;

    private double[] errors = new double[1024];
    private int[] places = new int[1024];
    private int[] heap = new int[1024];
    private int size;

    WorstFirst() {
        Arrays.fill(places, ABSENT);
    }

    boolean isEmpty() {
        return size == 0;
    }

    int worst() {
        return heap[0];
    }

    /** Sets the error of a triangle; one that is at most the limit takes the triangle out. */
    void set(int triangle, double error, double limit) {
        if (triangle >= places.length) {
            int former = places.length;
            int length = Math.max(2 * former, triangle + 1);
            places = Arrays.copyOf(places, length);
            Arrays.fill(places, former, length, ABSENT);
            errors = Arrays.copyOf(errors, length);
            heap = Arrays.copyOf(heap, length);
        }
        errors[triangle] = error;
        int place = places[triangle];
        if (error > limit) {
            if (place == ABSENT) {
                place = size++;
                put(triangle, place);
            }
            settle(place);
        } else if (place != ABSENT) {
            int last = heap[--size];
            places[triangle] = ABSENT;
            if (last != triangle) {
                put(last, place);
                settle(place);
            }
        }
    }

    private void settle(int start) {
        int moving = heap[start];
        int place = start;
        while (place > 0 && isBefore(moving, heap[(place - 1) / 2])) {
            put(heap[(place - 1) / 2], place);
            place = (place - 1) / 2;
        }
        while (2 * place + 1 < size) {
            int child = 2 * place + 1;
            if (child + 1 < size && isBefore(heap[child + 1], heap[child])) {
                child++;
            }
            if (!isBefore(heap[child], moving)) {
                break;
            }
            put(heap[child], place);
            place = child;
        }
        put(moving, place);
    }

    private void put(int triangle, int place) {
        heap[place] = triangle;
        places[triangle] = place;
    }

    private boolean isBefore(int one, int other) {
        int order = Double.compare(errors[one], errors[other]);
        return order > 0 || order == 0 && one < other;
    }
}
