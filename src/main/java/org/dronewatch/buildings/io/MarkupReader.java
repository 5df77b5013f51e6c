package org.dronewatch.buildings.io;

import java.io.FilterReader;
import java.io.IOException;
import java.io.Reader;

/**
 * Stops reading XML in which no markup follows for too long: the parser would keep an element or a text of any length
 * in memory.
 */
final class MarkupReader extends FilterReader {
    private static final int MOST = 1_000_000;

    private int since;

    MarkupReader(Reader in) {
        super(in);
    }

    @Override
    public int read() throws IOException {
        int one = in.read();
        count((char) one);
        return one;
    }

    @Override
    public int read(char[] target, int from, int length) throws IOException {
        int read = in.read(target, from, length);
        for (int i = from; i < from + read; i++) {
            count(target[i]);
        }
        return read;
    }

    private void count(char one) throws IOException {
        since = one == '<' || one == '>' ? 0 : since + 1;
        if (since > MOST) {
            throw new IOException("more than " + MOST + " characters without the beginning or the end of an element");
        }
    }
}
