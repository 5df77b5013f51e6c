package org.dronewatch.app.console;

import java.io.PrintWriter;
import java.time.Duration;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import me.tongfei.progressbar.ProgressBar;
import org.dronewatch.campaign.CampaignRun;
import org.dronewatch.setting.Counted;

/** Shows how many cases of a campaign are done: as a bar on a terminal, otherwise as a line every ten seconds. */
public final class CaseProgress implements CampaignRun.Progress, AutoCloseable {
    private static final double NANO = 1e-9;
    private static final double EVERY_SECONDS = 10.0;

    private final int all;
    private final PrintWriter err;
    private final ProgressBar bar;
    private final boolean statesEnd;
    private final LongSupplier clock;
    private final long start;
    private double next = EVERY_SECONDS;
    private int kept;
    private int ran;

    // The first cases also set up the site, which says nothing about how long the others take.
    private int first;
    private long firstEnd;

    // The thread that draws the bar must not wait for one that closes it, and takes no lock.
    private volatile Optional<Long> end = Optional.empty();

    /**
     * Progress before any case is done.
     *
     * @param all number of cases, those of earlier runs included
     * @param bar makes the bar from a supplier of the time that is left; returns null if lines are printed instead
     * @param statesEnd whether a line also states how many cases are done at the end
     * @param clock returns the current time, ns
     */
    CaseProgress(
            int all,
            PrintWriter err,
            Function<Supplier<Optional<Duration>>, ProgressBar> bar,
            boolean statesEnd,
            LongSupplier clock) {
        this.all = all;
        this.err = err;
        this.statesEnd = statesEnd;
        this.clock = clock;
        this.start = clock.getAsLong();
        this.bar = bar.apply(this::left);
    }

    /** Counts cases whose results are those of an earlier run; the rate does not include them. */
    @Override
    public synchronized void kept(int cases) {
        kept += cases;
        show();
    }

    @Override
    public synchronized void ran(int cases) {
        ran += cases;
        if (first == 0) {
            first = ran;
            firstEnd = clock.getAsLong();
        }
        show();
    }

    private void show() {
        int done = kept + ran;
        double rate = rate();
        end = rate > 0.0 ? Optional.of(clock.getAsLong() + Math.round((all - done) / rate / NANO)) : Optional.empty();
        if (bar != null) {
            bar.stepTo(done);
            return;
        }
        double seconds = seconds();
        if (seconds >= next && ran > 0 && done < all) {
            next = seconds + EVERY_SECONDS;
            err.printf(Locale.ROOT, "%,d of %,d cases%s%n", done, all, inWords(rate, all - done));
        }
    }

    private double seconds() {
        return NANO * (clock.getAsLong() - start);
    }

    /** The cases per second after the first ones; 0 if it is not known yet. */
    private double rate() {
        double seconds = NANO * (clock.getAsLong() - firstEnd);
        return ran > first && seconds > 0.0 ? (ran - first) / seconds : 0.0;
    }

    /** The rate in words, and how long the remaining cases take; empty if that is not known yet. */
    private static String inWords(double rate, int left) {
        return rate > 0.0
                ? String.format(Locale.ROOT, ", %.3g per second, %s left", rate, ProgressLines.duration(left / rate))
                : "";
    }

    /** For a bar: the time that is left by the last estimate; empty if it is not known, or over. */
    private Optional<Duration> left() {
        return end.map(time -> Duration.ofNanos(time - clock.getAsLong())).filter(left -> left.toNanos() > 0);
    }

    @Override
    public synchronized void close() {
        if (bar != null) {
            bar.close();
        } else if (statesEnd) {
            String time = ProgressLines.duration(seconds());
            err.printf(Locale.ROOT, "%,d of %s after %s%n", kept + ran, Counted.of(all, "case"), time);
        }
    }
}
