package org.dronewatch.placement.solver;

/** Sorts indices by keys without objects; indices with equal keys keep their order. Not thread-safe. */
final class Order {
    private final int[] spare;

    Order(int size) {
        spare = new int[size];
    }

    /** Sorts the first indices so that their keys descend. */
    void sort(int[] indices, int count, double[] keys) {
        for (int width = 1; width < count; width *= 2) {
            for (int start = 0; start < count; start += 2 * width) {
                merge(indices, start, Math.min(start + width, count), Math.min(start + 2 * width, count), keys);
            }
            System.arraycopy(spare, 0, indices, 0, count);
        }
    }

    private void merge(int[] indices, int start, int middle, int end, double[] keys) {
        int left = start;
        int right = middle;
        for (int to = start; to < end; to++) {
            boolean takesLeft = right == end || left < middle && keys[indices[left]] >= keys[indices[right]];
            spare[to] = takesLeft ? indices[left++] : indices[right++];
        }
    }
}
