package org.dronewatch.run.store;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.WritableByteChannel;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.zip.CRC32C;

/**
 * Writes arrays and texts one after another, little-endian, each preceded by its length, and a checksum of all of them
 * at the end. {@link StoreReader} reads them.
 */
public final class StoreWriter {
    private final WritableByteChannel target;
    private final ByteBuffer buffer = ByteBuffer.allocateDirect(1 << 20).order(ByteOrder.LITTLE_ENDIAN);
    private final CRC32C checksum = new CRC32C();

    StoreWriter(WritableByteChannel target) {
        this.target = target;
    }

    /** Adds a whole number. */
    public void addInt(int value) throws IOException {
        room(Integer.BYTES).putInt(value);
    }

    void addDouble(double value) throws IOException {
        room(Double.BYTES).putDouble(value);
    }

    /** Adds bytes, preceded by their count. */
    public void addBytes(byte[] values) throws IOException {
        addInt(values.length);
        for (byte value : values) {
            room(1).put(value);
        }
    }

    void addText(String text) throws IOException {
        addBytes(text.getBytes(StandardCharsets.UTF_8));
    }

    void addTexts(List<String> texts) throws IOException {
        addInt(texts.size());
        for (String text : texts) {
            addText(text);
        }
    }

    /** Adds whole numbers, preceded by their count. */
    public void addInts(int[] values) throws IOException {
        addInt(values.length);
        for (int value : values) {
            room(Integer.BYTES).putInt(value);
        }
    }

    void addFloats(float[] values) throws IOException {
        addInt(values.length);
        for (float value : values) {
            room(Float.BYTES).putFloat(value);
        }
    }

    void addLongs(long[] values) throws IOException {
        addInt(values.length);
        for (long value : values) {
            room(Long.BYTES).putLong(value);
        }
    }

    /** Adds numbers, preceded by their count. */
    public void addDoubles(double[] values) throws IOException {
        addInt(values.length);
        for (double value : values) {
            room(Double.BYTES).putDouble(value);
        }
    }

    private ByteBuffer room(int bytes) throws IOException {
        if (buffer.remaining() < bytes) {
            flush();
        }
        return buffer;
    }

    private void flush() throws IOException {
        buffer.flip();
        checksum.update(buffer.duplicate());
        while (buffer.hasRemaining()) {
            target.write(buffer);
        }
        buffer.clear();
    }

    /** Writes the checksum, which is the end. */
    void finish() throws IOException {
        flush();
        buffer.putLong(checksum.getValue());
        flush();
    }
}
