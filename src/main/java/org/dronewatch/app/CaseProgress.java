package org.dronewatch.app;

import java.io.PrintWriter;
import me.tongfei.progressbar.ProgressBar;

/** Shows how many cases of a campaign are done: as a bar on a terminal, otherwise as a line every ten seconds. */
final class CaseProgress implements AutoCloseable {
    private static final double NANO = 1e-9;
    private static final double EVERY_SECONDS = 10.0;
    private static final int MINUTE = 60;

    private final int all;
    private final PrintWriter err;
    private final ProgressBar bar;
    private final long start = System.nanoTime();
    private double next = EVERY_SECONDS;
    private int done;

    CaseProgress(String name, int all, PrintWriter err) {
        this.all = all;
        this.err = err;
        this.bar = Progress.barOf(name, all);
    }

    synchronized void add(int cases) {
        done += cases;
        if (bar != null) {
            bar.stepTo(done);
            return;
        }
        double seconds = NANO * (System.nanoTime() - start);
        if (seconds >= next && done < all) {
            next = seconds + EVERY_SECONDS;
            double left = seconds / done * (all - done);
            err.printf("%,d of %,d cases, %.1f per second, %s left%n", done, all, done / seconds, duration(left));
        }
    }

    private static String duration(double seconds) {
        return seconds < MINUTE ? Math.round(seconds) + " s" : Math.round(seconds / MINUTE) + " min";
    }

    @Override
    public void close() {
        if (bar != null) {
            bar.close();
        }
    }
}
