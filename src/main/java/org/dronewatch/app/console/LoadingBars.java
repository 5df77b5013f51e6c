package org.dronewatch.app.console;

import me.tongfei.progressbar.ProgressBar;
import org.dronewatch.parallel.LongTask;

/** A progress bar for each step of loading that takes seconds; only on a terminal. */
public final class LoadingBars implements LongTask.Watcher {
    private ProgressBar bar;

    /** Shows the tasks of the calling thread, if there is a terminal. */
    public static void show() {
        LongTask.watch(System.console() == null ? null : new LoadingBars());
    }

    @Override
    public synchronized void started(String what, long steps) {
        ended();
        bar = Progress.barOf(what, steps);
    }

    @Override
    public synchronized void advanced(long steps) {
        if (bar != null) {
            // A map may be read twice.
            bar.stepTo(bar.isIndefinite() ? steps : Math.min(steps, bar.getMax()));
        }
    }

    @Override
    public synchronized void ended() {
        if (bar != null) {
            bar.close();
            bar = null;
        }
    }
}
