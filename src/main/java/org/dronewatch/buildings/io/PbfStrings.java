package org.dronewatch.buildings.io;

import java.io.IOException;
import java.util.Arrays;

/**
 * The texts of a block by their numbers, decoded when they are first used: a block may hold millions that are never
 * used.
 */
final class PbfStrings {
    static final PbfStrings NONE = new PbfStrings(new ProtoReader(new byte[0]), new long[0]);

    private final ProtoReader table;
    private final long[] ranges;
    private final String[] made;

    private PbfStrings(ProtoReader table, long[] ranges) {
        this.table = table;
        this.ranges = ranges;
        this.made = new String[ranges.length];
    }

    /** The texts of a table of a block. */
    static PbfStrings of(ProtoReader table) throws IOException {
        long[] ranges = new long[64];
        int count = 0;
        while (table.next()) {
            if (table.field() == 1) {
                ranges = count == ranges.length ? Arrays.copyOf(ranges, 2 * count) : ranges;
                ranges[count++] = table.range();
            } else {
                table.skip();
            }
        }
        return new PbfStrings(table, Arrays.copyOf(ranges, count));
    }

    /** A text; the same object each time. */
    String get(long number) throws IOException {
        if (number < 0 || number >= made.length) {
            throw new IOException("string index " + number + " is not one of the " + made.length + " in its block");
        }
        int index = (int) number;
        if (made[index] == null) {
            made[index] = table.text(ranges[index]);
        }
        return made[index];
    }
}
