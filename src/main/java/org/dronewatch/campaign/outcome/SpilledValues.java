package org.dronewatch.campaign.outcome;

import java.io.File;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.ByteBuffer;
import java.util.function.DoubleConsumer;
import org.dronewatch.setting.InputException;

/** Numbers in a temporary file, which is deleted once nothing refers to them. For use by one thread. */
final class SpilledValues {
    private static final int BUFFER_VALUES = 1 << 13;

    // Not a channel, because an interrupt would close it.
    private final RandomAccessFile file;
    private final byte[] bytes = new byte[BUFFER_VALUES * Double.BYTES];
    private long size;

    /**
     * No values yet.
     *
     * @throws InputException when the temporary directory cannot be written
     */
    SpilledValues() {
        try {
            File named = File.createTempFile("dronewatch-", ".values");
            this.file = new RandomAccessFile(named, "rw");
            if (!named.delete()) {
                // Windows keeps the name as long as the file is open.
                named.deleteOnExit();
            }
        } catch (IOException e) {
            throw refusal(e);
        }
    }

    private static InputException refusal(IOException reason) {
        return new InputException(
                "the directory for temporary files, " + System.getProperty("java.io.tmpdir")
                        + ", cannot be used (java -Djava.io.tmpdir=DIR names another): " + reason.getMessage(),
                reason);
    }

    /**
     * Adds the first of some values.
     *
     * @param count how many of them, at most 8,192
     */
    void add(double[] values, int count) {
        ByteBuffer.wrap(bytes).asDoubleBuffer().put(values, 0, count);
        try {
            file.seek(size);
            file.write(bytes, 0, count * Double.BYTES);
        } catch (IOException e) {
            throw refusal(e);
        }
        size += (long) count * Double.BYTES;
    }

    /** Hands over all values, in their order. */
    void forEach(DoubleConsumer action) {
        try {
            file.seek(0);
            for (long done = 0; done < size; done += bytes.length) {
                int length = (int) Math.min(bytes.length, size - done);
                file.readFully(bytes, 0, length);
                ByteBuffer some = ByteBuffer.wrap(bytes, 0, length);
                while (some.hasRemaining()) {
                    action.accept(some.getDouble());
                }
            }
        } catch (IOException e) {
            throw refusal(e);
        }
    }
}
