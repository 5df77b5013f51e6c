package org.dronewatch.run.store;

import java.io.IOException;
import java.io.StreamCorruptedException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.ReadableByteChannel;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.CRC32C;

/**
 * Reads what {@link StoreWriter} wrote. Lengths are compared with what is left of the file before anything is
 * allocated, so that a damaged file takes no more memory than its own size. What was read must not be used before the
 * store has compared the checksum at the end of the file.
 */
public final class StoreReader {
    private static final int CHUNK = 1 << 20;

    private final ReadableByteChannel source;
    private final ByteBuffer buffer = ByteBuffer.allocateDirect(CHUNK).order(ByteOrder.LITTLE_ENDIAN);
    private final CRC32C checksum = new CRC32C();
    /** The number of bytes before the checksum that have not been taken from the buffer yet. */
    private long left;

    /**
     * A reader.
     *
     * @param source source of the bytes
     * @param size number of bytes
     */
    StoreReader(ReadableByteChannel source, long size) throws IOException {
        this.source = source;
        this.left = size - Long.BYTES;
        buffer.limit(0);
        if (left < 0) {
            throw new StreamCorruptedException("too short");
        }
    }

    /** The next whole number. */
    public int nextInt() throws IOException {
        require(Integer.BYTES);
        return buffer.getInt();
    }

    /** The next number. */
    public double nextDouble() throws IOException {
        require(Double.BYTES);
        return buffer.getDouble();
    }

    /** The next bytes, preceded by their count. */
    public byte[] nextBytes() throws IOException {
        byte[] values = new byte[length(1)];
        for (int i = 0; i < values.length; i++) {
            require(1);
            values[i] = buffer.get();
        }
        return values;
    }

    String nextText() throws IOException {
        return new String(nextBytes(), StandardCharsets.UTF_8);
    }

    List<String> nextTexts() throws IOException {
        int count = length(Integer.BYTES);
        List<String> texts = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            texts.add(nextText());
        }
        return texts;
    }

    /** The next whole numbers, preceded by their count. */
    public int[] nextInts() throws IOException {
        int[] values = new int[length(Integer.BYTES)];
        inChunks(values.length, Integer.BYTES, (start, some) -> buffer.asIntBuffer()
                .get(values, start, some));
        return values;
    }

    float[] nextFloats() throws IOException {
        float[] values = new float[length(Float.BYTES)];
        inChunks(values.length, Float.BYTES, (start, some) -> buffer.asFloatBuffer()
                .get(values, start, some));
        return values;
    }

    long[] nextLongs() throws IOException {
        long[] values = new long[length(Long.BYTES)];
        inChunks(values.length, Long.BYTES, (start, some) -> buffer.asLongBuffer()
                .get(values, start, some));
        return values;
    }

    /** The next numbers, preceded by their count. */
    public double[] nextDoubles() throws IOException {
        double[] values = new double[length(Double.BYTES)];
        for (int i = 0; i < values.length; i++) {
            values[i] = nextDouble();
        }
        return values;
    }

    /** The number of parts that follow, each of which takes at least the given number of bytes. */
    public int length(int bytesEach) throws IOException {
        int count = nextInt();
        if (count < 0 || (long) count * bytesEach > left) {
            throw new StreamCorruptedException("length " + count + " with " + left + " bytes left");
        }
        return count;
    }

    /** Takes some values from the buffer. */
    private interface Taking {
        /**
         * Takes the values without moving the buffer's position.
         *
         * @param start index of the first of these values among all values
         * @param some number of values to take
         */
        void take(int start, int some);
    }

    /** Takes as many values at a time as the buffer holds. */
    private void inChunks(int count, int bytesEach, Taking taking) throws IOException {
        int done = 0;
        while (done < count) {
            ready(bytesEach);
            int some = Math.min(count - done, (int) Math.min(buffer.remaining(), left) / bytesEach);
            taking.take(done, some);
            skip(some * bytesEach);
            done += some;
        }
    }

    private void skip(int bytes) {
        buffer.position(buffer.position() + bytes);
        left -= bytes;
    }

    /** Takes some bytes, which the caller gets from the buffer. */
    private void require(int bytes) throws IOException {
        ready(bytes);
        left -= bytes;
    }

    private void ready(int bytes) throws IOException {
        if (bytes > left) {
            throw new StreamCorruptedException("ends too early");
        }
        if (buffer.remaining() < bytes) {
            fill();
        }
    }

    private void fill() throws IOException {
        int start = buffer.remaining();
        buffer.compact();
        int read = 0;
        while (buffer.hasRemaining() && read >= 0) {
            read = source.read(buffer);
        }
        buffer.flip();
        // The checksum at the end does not count itself.
        long fresh = Math.min(buffer.remaining(), left) - start;
        checksum.update(buffer.duplicate().position(start).limit((int) (start + Math.max(0, fresh))));
        if (buffer.remaining() == start) {
            throw new StreamCorruptedException("ends too early");
        }
    }

    /** Checks that nothing is left, and that the checksum is that of all that was read. */
    void finish() throws IOException {
        if (left != 0) {
            throw new StreamCorruptedException(left + " bytes too many");
        }
        if (buffer.remaining() < Long.BYTES) {
            left = 0;
            fill();
        }
        if (buffer.remaining() < Long.BYTES || buffer.getLong() != checksum.getValue()) {
            throw new StreamCorruptedException("wrong checksum");
        }
    }
}
