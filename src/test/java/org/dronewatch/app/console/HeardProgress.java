package org.dronewatch.app.console;

import java.io.PrintWriter;
import java.io.Writer;
import java.util.Locale;
import java.util.function.Consumer;

/** The progress of a task that a test listens to, and that nobody sees. */
final class HeardProgress {
    private HeardProgress() {}

    /**
     * A progress that prints nothing.
     *
     * @param lines receives each line
     * @param flushed is run whenever lines are flushed
     */
    static TaskProgress of(Consumer<String> lines, Runnable flushed) {
        PrintWriter err = new PrintWriter(Writer.nullWriter()) {
            @Override
            public void flush() {
                flushed.run();
            }

            @Override
            public PrintWriter printf(Locale locale, String format, Object... values) {
                lines.accept(String.format(locale, format, values));
                return this;
            }
        };
        return new TaskProgress(TaskProgress.Amount.EVERYWHERE, err);
    }
}
