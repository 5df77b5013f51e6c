package org.dronewatch.analysis.layer;

import org.dronewatch.analysis.cell.CellCode;

/**
 * The {@link CellCode}s of one cell on several courses, in an array of bytes. Since there are only a few distinct
 * codes, each is listed once, and each course has only the bits of a position in the list.
 *
 * <pre>
 *   byte             number of different codes, less one; 255 if that is 255 or more
 *   2 bytes          this number, the lower byte first, only if it is 255 or more
 *   3 bytes each     these codes, in the order in which they first occur
 *   bits             for each course the position of its code, the lowest bit first; filled up to a whole byte
 * </pre>
 */
final class CourseCodes {
    private static final int BYTE = 0xFF;

    /** The greatest number of different codes for which one byte is enough. */
    private static final int FEW = 255;

    private CourseCodes() {}

    /** The greatest number of bytes for a number of courses. */
    static int most(int courses) {
        return size(courses, courses);
    }

    private static int size(int different, int courses) {
        return head(different) + CellCode.BYTES * different + (courses * bits(different) + Byte.SIZE - 1) / Byte.SIZE;
    }

    /** The bytes before the codes. */
    private static int head(int different) {
        return different > FEW ? 3 : 1;
    }

    /** The number of different codes at a position. */
    private static int different(byte[] pool, int at) {
        int less = pool[at] & BYTE;
        return 1 + (less < FEW ? less : pool[at + 1] & BYTE | (pool[at + 2] & BYTE) << Byte.SIZE);
    }

    /** The bits of a position in a list of codes, one at least. */
    private static int bits(int different) {
        return Math.max(1, Integer.SIZE - Integer.numberOfLeadingZeros(different - 1));
    }

    /**
     * Writes codes to a position in an array of bytes that are 0.
     *
     * @return the position after them
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
        int head = head(different);
        pool[at] = (byte) Math.min(different - 1, FEW);
        if (different > FEW) {
            pool[at + 1] = (byte) (different - 1);
            pool[at + 2] = (byte) (different - 1 >> Byte.SIZE);
        }
        for (int i = 0; i < different; i++) {
            int first = at + head + CellCode.BYTES * i;
            for (int part = 0; part < CellCode.BYTES; part++) {
                pool[first + part] = (byte) (list[i] >> Byte.SIZE * part);
            }
        }
        int bits = bits(different);
        int begin = at + head + CellCode.BYTES * different;
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
        int different = different(pool, at);
        int first = at + head(different) + CellCode.BYTES * position(pool, at, different, course);
        return pool[first] & BYTE | (pool[first + 1] & BYTE) << 8 | (pool[first + 2] & BYTE) << 16;
    }

    private static int position(byte[] pool, int at, int different, int course) {
        int bits = bits(different);
        int index = course * bits;
        int from = at + head(different) + CellCode.BYTES * different + index / Byte.SIZE;
        int word = 0;
        for (int i = 0; i < CellCode.BYTES && from + i < pool.length; i++) {
            word |= (pool[from + i] & BYTE) << Byte.SIZE * i;
        }
        return word >> index % Byte.SIZE & (1 << bits) - 1;
    }

    /** Whether codes of a number of courses can be at a position in an array of bytes. */
    static boolean isPossible(byte[] pool, long at, int courses) {
        if (at < 0 || at >= pool.length || (pool[(int) at] & BYTE) == FEW && at + 3 > pool.length) {
            return false;
        }
        int different = different(pool, (int) at);
        boolean isShortest = different > FEW || (pool[(int) at] & BYTE) < FEW;
        if (!isShortest || different > courses || at + size(different, courses) > pool.length) {
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
