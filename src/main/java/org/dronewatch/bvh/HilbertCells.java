package org.dronewatch.bvh;

/**
 * Square cells of a rectangle, numbered along a chain of Hilbert curves: cells whose numbers are close are close to
 * each other. For use by one thread.
 */
final class HilbertCells {
    private static final int MOST_BITS = 7;

    /** For each number of bits, the positions on the curve of a square by row and column. */
    private static final short[][] CURVES = curves();

    private float left;
    private float bottom;
    private float perUnit;
    private boolean isTall;
    private int bits;
    private short[] curve = CURVES[0];

    /**
     * Divides a rectangle into cells.
     *
     * @param about approximate number of cells
     * @return one more than the highest number that a cell can have; not every number need have a cell
     */
    int set(float leastX, float mostX, float leastY, float mostY, int about) {
        left = leastX;
        bottom = leastY;
        float width = mostX - leastX;
        float height = mostY - leastY;
        isTall = height > width;
        float longer = Math.max(width, height);
        float shorter = Math.min(width, height);
        float side = Math.max((float) Math.sqrt(longer * shorter / about), longer / about);
        perUnit = side > 0.0f ? 1.0f / side : 0.0f;
        int across = 1 + (int) (shorter * perUnit);
        bits = Math.min(MOST_BITS, Integer.SIZE - Integer.numberOfLeadingZeros(across - 1));
        if (across > 1 << bits) {
            perUnit *= (float) ((1 << bits) - 1) / across;
        }
        curve = CURVES[bits];
        return 1 + ((int) (longer * perUnit) >> bits) << 2 * bits;
    }

    /** The number of the cell of a point. */
    int cell(float x, float y) {
        int column = (int) ((x - left) * perUnit);
        int row = (int) ((y - bottom) * perUnit);
        int far = isTall ? row : column;
        int near = isTall ? column : row;
        int rest = far & (1 << bits) - 1;
        return (far >> bits << 2 * bits) + curve[near << bits | rest];
    }

    private static short[][] curves() {
        short[][] all = new short[MOST_BITS + 1][];
        for (int bits = 0; bits <= MOST_BITS; bits++) {
            int size = 1 << bits;
            all[bits] = new short[size * size];
            for (int row = 0; row < size; row++) {
                for (int column = 0; column < size; column++) {
                    all[bits][row << bits | column] = (short) position(size, column, row);
                }
            }
        }
        return all;
    }

    /** The position of a cell on Hilbert's curve, which begins in the corner (0, 0) and ends in (size - 1, 0). */
    private static int position(int size, int column, int row) {
        int x = column;
        int y = row;
        int position = 0;
        for (int half = size / 2; half > 0; half /= 2) {
            int right = (x & half) > 0 ? 1 : 0;
            int upper = (y & half) > 0 ? 1 : 0;
            position += half * half * (3 * right ^ upper);
            if (upper == 0) {
                if (right == 1) {
                    x = size - 1 - x;
                    y = size - 1 - y;
                }
                int swap = x;
                x = y;
                y = swap;
            }
        }
        return position;
    }
}
