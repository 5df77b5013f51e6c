package org.dronewatch.app;

import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.charset.Charset;
import java.util.concurrent.TimeUnit;

/** The program on a console that takes half a second to show an end by the user: a process must not end before. */
final class SlowConsole {
    private SlowConsole() {}

    public static void main(String[] arguments) {
        PrintWriter err = new PrintWriter(new Slow(), true);
        Main.execute(new PrintWriter(System.out, true, Charset.defaultCharset()), err, arguments);
    }

    private static final class Slow extends Writer {
        private final Writer target = new OutputStreamWriter(System.err, Charset.defaultCharset());

        @Override
        public void write(char[] text, int from, int length) throws IOException {
            String shown = new String(text, from, length);
            if (shown.contains("interrupted:")) {
                long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(500);
                while (System.nanoTime() < end) {
                    // The thread may still be interrupted, and would not sleep.
                    Thread.onSpinWait();
                }
            }
            target.write(shown);
        }

        @Override
        public void flush() throws IOException {
            target.flush();
        }

        @Override
        public void close() throws IOException {
            target.close();
        }
    }
}
