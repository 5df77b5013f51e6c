package org.dronewatch.buildings.io;

import java.io.EOFException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * Reads a message of Protocol Buffers, field by field. Lengths are checked against the bytes available, so a false
 * length costs nothing.
 */
final class ProtoReader {
    private static final int VARINT = 0;
    private static final int FIXED_64 = 1;
    private static final int DELIMITED = 2;
    private static final int FIXED_32 = 5;
    private static final int MOST_BITS = 64;

    private final byte[] bytes;
    private final int end;
    private int at;
    private int field;
    private int type;

    ProtoReader(byte[] bytes) {
        this(bytes, 0, bytes.length);
    }

    private ProtoReader(byte[] bytes, int from, int end) {
        this.bytes = bytes;
        this.at = from;
        this.end = end;
    }

    boolean hasMore() {
        return at < end;
    }

    /** Goes to the next field, whose value must be read or skipped; false at the end. */
    boolean next() throws IOException {
        if (at >= end) {
            return false;
        }
        long key = varint();
        field = (int) (key >>> 3);
        type = (int) (key & 7);
        if (key >>> 32 != 0 || field == 0) {
            throw new IOException("field " + (key >>> 3) + " is not possible");
        }
        return true;
    }

    int field() {
        return field;
    }

    void skip() throws IOException {
        switch (type) {
            case VARINT -> varint();
            case FIXED_64 -> advance(8);
            case DELIMITED -> advance(length());
            case FIXED_32 -> advance(4);
            default -> throw new IOException("wire type " + type + " is not known");
        }
    }

    /** A whole number that is written without zigzag. */
    long number() throws IOException {
        expect(VARINT);
        return varint();
    }

    /** A whole number that is written in zigzag. */
    long signed() throws IOException {
        return zigzag(number());
    }

    /** A message, or the numbers of a packed field. */
    ProtoReader message() throws IOException {
        expect(DELIMITED);
        int length = length();
        ProtoReader inner = new ProtoReader(bytes, at, at + length);
        at += length;
        return inner;
    }

    byte[] copy() throws IOException {
        ProtoReader inner = message();
        return Arrays.copyOfRange(bytes, inner.at, inner.end);
    }

    /** Where the bytes of a field lie: the first in the upper half, the one after the last in the lower half. */
    long range() throws IOException {
        ProtoReader inner = message();
        return (long) inner.at << 32 | inner.end;
    }

    /** The text of a {@linkplain #range() range}. */
    String text(long range) {
        int from = (int) (range >> 32);
        return new String(bytes, from, (int) range - from, StandardCharsets.UTF_8);
    }

    String text() throws IOException {
        ProtoReader inner = message();
        return new String(bytes, inner.at, inner.end - inner.at, StandardCharsets.UTF_8);
    }

    /** The next number of a packed field. */
    long packed() throws IOException {
        return varint();
    }

    /** The next number of a packed field in zigzag. */
    long packedSigned() throws IOException {
        return zigzag(varint());
    }

    /** How many numbers a packed field has from here on. */
    int countPacked() {
        int count = 0;
        for (int i = at; i < end; i++) {
            count += bytes[i] >= 0 ? 1 : 0;
        }
        return count;
    }

    private static long zigzag(long value) {
        return value >>> 1 ^ -(value & 1);
    }

    private void expect(int wanted) throws IOException {
        if (type != wanted) {
            throw new IOException("field " + field + " has wire type " + type + " but must have " + wanted);
        }
    }

    private int length() throws IOException {
        long length = varint();
        if (length < 0 || length > end - at) {
            throw new EOFException();
        }
        return (int) length;
    }

    private void advance(int count) throws IOException {
        if (count > end - at) {
            throw new EOFException();
        }
        at += count;
    }

    private long varint() throws IOException {
        long value = 0;
        for (int shift = 0; shift < MOST_BITS; shift += 7) {
            if (at >= end) {
                throw new EOFException();
            }
            byte one = bytes[at++];
            value |= (long) (one & 0x7F) << shift;
            if (one >= 0) {
                return value;
            }
        }
        throw new IOException("a number has more than ten bytes");
    }
}
