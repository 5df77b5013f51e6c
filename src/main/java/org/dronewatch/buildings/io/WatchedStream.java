package org.dronewatch.buildings.io;

import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import org.dronewatch.parallel.LongTask;

/** Reports to a task how many bytes have been read. */
final class WatchedStream extends FilterInputStream {
    private final LongTask task;

    WatchedStream(InputStream in, LongTask task) {
        super(in);
        this.task = task;
    }

    @Override
    public int read() throws IOException {
        int one = super.read();
        if (one >= 0) {
            task.advance(1);
        }
        return one;
    }

    @Override
    public int read(byte[] target, int from, int length) throws IOException {
        int count = super.read(target, from, length);
        task.advance(Math.max(count, 0));
        return count;
    }
}
