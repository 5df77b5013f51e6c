package org.dronewatch.run.store;

import java.io.IOException;

/** How something is written to the store, and read from it. */
public interface StoredForm<T> {
    /**
     * Writes a value.
     *
     * @throws IOException when the value cannot be written
     */
    void write(T value, StoreWriter target) throws IOException;

    /**
     * Reads a value; the checksum has not been compared yet.
     *
     * @throws IOException when the file ends too early
     * @throws IllegalArgumentException when its contents cannot be valid
     */
    T read(StoreReader source) throws IOException;
}
