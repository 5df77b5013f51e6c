package org.dronewatch.report.file;

import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;

/** Records the first write error: some libraries swallow the exceptions of their stream, or replace them. */
final class CarefulStream extends FilterOutputStream {
    private IOException refusal;

    CarefulStream(OutputStream target) {
        super(target);
    }

    @Override
    public void write(int b) throws IOException {
        write(new byte[] {(byte) b}, 0, 1);
    }

    @Override
    public void write(byte[] bytes, int from, int length) throws IOException {
        check();
        try {
            out.write(bytes, from, length);
        } catch (IOException e) {
            refusal = e;
            throw e;
        }
    }

    /**
     * Checks that nothing was lost.
     *
     * @throws IOException the first write error
     */
    void check() throws IOException {
        if (refusal != null) {
            throw new IOException(refusal.getMessage(), refusal);
        }
    }
}
