package org.dronewatch.spark;

import java.io.Serializable;

/**
 * What an executor answers: the rows of a chunk, or why it runs none.
 *
 * @param rows the bytes of the chunk's file; none with a refusal
 * @param refusal the reason, in one line; empty with rows
 */
@SuppressWarnings("ArrayRecordComponent")
record ChunkAnswer(byte[] rows, String refusal) implements Serializable {
    private static final long serialVersionUID = 1L;

    static ChunkAnswer of(byte[] rows) {
        return new ChunkAnswer(rows, "");
    }

    static ChunkAnswer refused(String reason) {
        return new ChunkAnswer(new byte[0], reason);
    }
}
