package org.dronewatch.terrain.io;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import org.dronewatch.setting.InputException;

/**
 * The tags of the first image of a TIFF or BigTIFF file (TIFF revision 6.0, Adobe 1992; BigTIFF design, libtiff). Their
 * values are read when they are asked for. Everything that a file states is checked against the length of the file
 * before memory is allocated.
 */
final class TiffDirectory {
    private static final int CLASSIC = 42;
    private static final int BIG = 43;
    private static final int MOST_TAGS = 4096;
    private static final int MOST_VALUES = 1 << 24;

    /** Bytes of a value by its type: BYTE, ASCII, SHORT, LONG, RATIONAL and so on; 0 for types that do not exist. */
    private static final int[] SIZES = {0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8, 4, 0, 0, 8, 8, 8};

    private static final int FLOAT = 11;
    private static final int DOUBLE = 12;

    private final ElevationBytes bytes;
    private final ByteOrder order;
    private final Map<Integer, Tag> tags = new HashMap<>();

    /** Where the values of a tag are. */
    private record Tag(int type, long count, long at) {}

    /** Reads the header and the first directory. */
    TiffDirectory(ElevationBytes bytes) throws IOException {
        this.bytes = bytes;
        byte[] start = bytes.read(0, 8);
        this.order = start[0] == 'I' ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN;
        int version = Short.toUnsignedInt(buffer(start).getShort(2));
        if (version == CLASSIC) {
            readClassic(Integer.toUnsignedLong(buffer(start).getInt(4)));
        } else if (version == BIG) {
            readBig(buffer(bytes.read(8, 8)).getLong(0));
        } else {
            throw new InputException(bytes.name() + ": TIFF version " + version + " must be " + CLASSIC + " or " + BIG);
        }
    }

    /** Whether a file begins as TIFF files do. */
    static boolean isTiff(byte[] start) {
        boolean isIntel =
                start[0] == 'I' && start[1] == 'I' && (start[2] == CLASSIC || start[2] == BIG) && start[3] == 0;
        boolean isMotorola =
                start[0] == 'M' && start[1] == 'M' && start[2] == 0 && (start[3] == CLASSIC || start[3] == BIG);
        return isIntel || isMotorola;
    }

    private ByteBuffer buffer(byte[] some) {
        return ByteBuffer.wrap(some).order(order);
    }

    private void readClassic(long at) throws IOException {
        int count = Short.toUnsignedInt(buffer(bytes.read(at, 2)).getShort(0));
        checkTags(count);
        ByteBuffer entries = buffer(bytes.read(at + 2, 12 * count));
        for (int i = 0; i < count; i++) {
            int type = Short.toUnsignedInt(entries.getShort(12 * i + 2));
            long values = Integer.toUnsignedLong(entries.getInt(12 * i + 4));
            boolean isInside = values * size(type) <= 4;
            long where = isInside ? at + 2 + 12L * i + 8 : Integer.toUnsignedLong(entries.getInt(12 * i + 8));
            tags.put(Short.toUnsignedInt(entries.getShort(12 * i)), new Tag(type, values, where));
        }
    }

    private void readBig(long at) throws IOException {
        long count = buffer(bytes.read(at, 8)).getLong(0);
        checkTags(count);
        ByteBuffer entries = buffer(bytes.read(at + 8, 20 * (int) count));
        for (int i = 0; i < count; i++) {
            int type = Short.toUnsignedInt(entries.getShort(20 * i + 2));
            long values = entries.getLong(20 * i + 4);
            boolean isInside = values >= 0 && values <= 8 && values * size(type) <= 8;
            long where = isInside ? at + 8 + 20L * i + 12 : entries.getLong(20 * i + 12);
            tags.put(Short.toUnsignedInt(entries.getShort(20 * i)), new Tag(type, values, where));
        }
    }

    private void checkTags(long count) {
        if (count < 1 || count > MOST_TAGS) {
            throw new InputException(
                    bytes.name() + ": states " + count + " tags but must state 1 to " + MOST_TAGS + ": it is damaged");
        }
    }

    private static int size(int type) {
        return type < SIZES.length ? SIZES[type] : 0;
    }

    ByteOrder order() {
        return order;
    }

    boolean has(int tag) {
        return tags.containsKey(tag);
    }

    private ByteBuffer values(int number, Tag tag) throws IOException {
        int size = size(tag.type());
        if (size == 0 || tag.count() < 0 || tag.count() > MOST_VALUES) {
            throw new InputException(bytes.name() + ": tag " + number + " of type " + tag.type() + " has " + tag.count()
                    + " values but must have at most " + MOST_VALUES + " of a known type: the file is damaged");
        }
        try {
            return buffer(bytes.read(tag.at(), (int) (size * tag.count())));
        } catch (EOFException e) {
            throw new InputException(
                    bytes.name() + ": the values of tag " + number + " lie beyond its end, at byte " + bytes.size()
                            + ": it is truncated or damaged",
                    e);
        }
    }

    /** Whole numbers of a tag; none if the file lacks it. */
    long[] longs(int number) throws IOException {
        Tag tag = tags.get(number);
        if (tag == null) {
            return new long[0];
        }
        ByteBuffer values = values(number, tag);
        long[] all = new long[(int) tag.count()];
        for (int i = 0; i < all.length; i++) {
            all[i] = switch (size(tag.type())) {
                case 1 -> Byte.toUnsignedLong(values.get(i));
                case 2 -> Short.toUnsignedLong(values.getShort(2 * i));
                case 4 -> Integer.toUnsignedLong(values.getInt(4 * i));
                default -> values.getLong(8 * i);
            };
        }
        return all;
    }

    /** One whole number of a tag, or another if the file lacks it. */
    long single(int number, long otherwise) throws IOException {
        long[] all = longs(number);
        return all.length == 0 ? otherwise : all[0];
    }

    /** Real numbers of a tag; none if the file lacks it. */
    double[] doubles(int number) throws IOException {
        Tag tag = tags.get(number);
        if (tag == null) {
            return new double[0];
        }
        ByteBuffer values = values(number, tag);
        double[] all = new double[(int) tag.count()];
        for (int i = 0; i < all.length; i++) {
            if (tag.type() != DOUBLE && tag.type() != FLOAT) {
                throw new InputException(bytes.name() + ": tag " + number + " must hold real numbers");
            }
            all[i] = tag.type() == DOUBLE ? values.getDouble(8 * i) : values.getFloat(4 * i);
        }
        return all;
    }

    /** The text of a tag; empty if the file lacks it. */
    String text(int number) throws IOException {
        Tag tag = tags.get(number);
        if (tag == null || size(tag.type()) != 1) {
            return "";
        }
        byte[] all = values(number, tag).array();
        int end = 0;
        while (end < all.length && all[end] != 0) {
            end++;
        }
        return new String(all, 0, end, StandardCharsets.ISO_8859_1).strip();
    }
}
