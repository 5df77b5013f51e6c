package org.dronewatch.buildings.io;

import java.io.IOException;
import java.io.InputStream;

/** Limits the number of bytes to which a compressed file may be unpacked. */
final class LimitedStream extends InputStream {
    private final InputStream in;
    private final long most;
    private long left;

    LimitedStream(InputStream in, long most) {
        this.in = in;
        this.most = most;
        this.left = most;
    }

    @Override
    public int read() throws IOException {
        count(1);
        return in.read();
    }

    @Override
    public int read(byte[] target, int from, int length) throws IOException {
        int read = in.read(target, from, length);
        count(Math.max(read, 0));
        return read;
    }

    private void count(int bytes) throws IOException {
        left -= bytes;
        if (left < 0) {
            throw new IOException("unpacks to more than " + most + " bytes");
        }
    }

    @Override
    public void close() throws IOException {
        in.close();
    }
}
