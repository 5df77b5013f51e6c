package org.dronewatch.analysis.field;

/**
 * The {@link CellCode}s of one cell on several courses, in an array of bytes. Since there are only a few distinct
 * codes, each is listed once, and each course has only the bits of a position in the list.
 *
 * <pre>
 *   byte             number of different codes, less one
 *   3 bytes each     these codes, in the order in which they first occur
 *   bits             for each course the position of its code, the lowest bit first; filled up to a whole byte
 * </pre>
 */
final class CourseCodes {
    private static final int BYTE = 0xFF;

    private CourseCodes() {}

    /** The greatest number of bytes for a number of courses. */
    static int most(int courses) {
        return size(courses, courses);
    }

    private static int size(int different, int courses) {
        return 1 + CellCode.BYTES * different + (courses * bits(different) + Byte.SIZE - 1) / Byte.SIZE;
    }

    /** The bits of a position in a list of codes, one at least. */
    private static int bits(int different) {
        return Math.max(1, Integer.SIZE - Integer.numberOfLeadingZeros(different - 1));
    }

    /**
     * Writes codes to a position in an array of bytes that are 0.
     *
     * @return the position behind them
     */
    static int put(byte[] pool, int at, int[] codes) {
        int[] list = new int[codes.length];
        int[] positions = new int[codes.length];
        int different = 0;
        for (int course = 0; course < codes.length; course++) {
            int position = 0;
            while (position < different && list[position] != codes[course]) {
                position++;
            }
            if (position == different) {
                list[different++] = codes[course];
            }
            positions[course] = position;
        }
        pool[at] = (byte) (different - 1);
        for (int i = 0; i < different; i++) {
            int first = at + 1 + CellCode.BYTES * i;
            for (int part = 0; part < CellCode.BYTES; part++) {
                pool[first + part] = (byte) (list[i] >> Byte.SIZE * part);
            }
        }
        int bits = bits(different);
        int begin = at + 1 + CellCode.BYTES * different;
        for (int course = 0; course < codes.length; course++) {
            for (int bit = 0; bit < bits; bit++) {
                int index = course * bits + bit;
                pool[begin + index / Byte.SIZE] |= (byte) ((positions[course] >> bit & 1) << index % Byte.SIZE);
            }
        }
        return at + size(different, codes.length);
    }

    /** The code of a course, of those that were written to a position. */
    static int at(byte[] pool, int at, int course) {
        int different = (pool[at] & BYTE) + 1;
        int first = at + 1 + CellCode.BYTES * position(pool, at, different, course);
        return pool[first] & BYTE | (pool[first + 1] & BYTE) << 8 | (pool[first + 2] & BYTE) << 16;
    }

    private static int position(byte[] pool, int at, int different, int course) {
        int bits = bits(different);
        int index = course * bits;
        int from = at + 1 + CellCode.BYTES * different + index / Byte.SIZE;
        int word = pool[from] & BYTE | (from + 1 < pool.length ? (pool[from + 1] & BYTE) << 8 : 0);
        return word >> index % Byte.SIZE & (1 << bits) - 1;
    }

    /** Whether codes of a number of courses can be at a position in an array of bytes. */
    static boolean isPossible(byte[] pool, long at, int courses) {
        if (at < 0 || at >= pool.length) {
            return false;
        }
        int different = (pool[(int) at] & BYTE) + 1;
        if (different > courses || at + size(different, courses) > pool.length) {
            return false;
        }
        for (int course = 0; course < courses; course++) {
            if (position(pool, (int) at, different, course) >= different
                    || !CellCode.isPossible(at(pool, (int) at, course))) {
                return false;
            }
        }
        return true;
    }
}
