package org.dronewatch.app.console;

import java.time.Duration;
import java.util.Optional;
import java.util.function.Function;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;
import me.tongfei.progressbar.ProgressState;
import org.dronewatch.run.Frame;
import org.dronewatch.run.RunInfo;
import org.dronewatch.run.SceneListener;
import org.dronewatch.run.Stage;
import org.dronewatch.setting.PlainText;

/** A progress bar on standard error, if that is a terminal. */
public final class Progress implements SceneListener, AutoCloseable {
    private static final int STEPS = 1000;

    private final String task;
    private final int only;
    private final double until;
    private ProgressBar bar;
    private RunInfo run;

    /** The progress of all runs of a scene. */
    public Progress(String task) {
        this(task, -1, Double.POSITIVE_INFINITY);
    }

    /**
     * The progress of only one run, up to a time.
     *
     * @param only index of the run; negative for all runs of the scene
     * @param until simulated time at which the simulation ends, s
     */
    public Progress(String task, int only, double until) {
        this.task = task;
        this.only = only;
        this.until = until;
    }

    /** A bar for a number of steps; null without a terminal. */
    public static ProgressBar barOf(String task, long steps) {
        TimeLeft left = new TimeLeft(steps);
        return barOf(task, steps, bar -> left.after(bar.getCurrent(), bar.getElapsedAfterStart()));
    }

    /**
     * A bar that shows a given estimate of the time left; none without a terminal.
     *
     * @param left the time that is left; any thread calls it
     */
    static ProgressBar barOf(String task, long steps, Function<ProgressState, Optional<Duration>> left) {
        return System.console() == null ? null : builder(task, steps, left).build();
    }

    static ProgressBarBuilder builder(String task, long steps, Function<ProgressState, Optional<Duration>> left) {
        return new ProgressBarBuilder()
                .setTaskName(PlainText.value(task))
                .setInitialMax(steps)
                .setStyle(ProgressBarStyle.ASCII)
                .setUpdateIntervalMillis(200)
                .setEtaFunction(left::apply);
    }

    @Override
    public void runStarted(RunInfo info, Stage stage) {
        run = info;
        if (bar == null) {
            bar = barOf(task, (only < 0 ? info.runs() : 1L) * STEPS);
        }
    }

    @Override
    public void observed(Frame frame) {
        if (bar != null) {
            double end = Math.min(until, run.settings().run().duration());
            double done = end > 0.0 ? frame.time() / end : 1.0;
            bar.stepTo((long) (((only < 0 ? frame.run() : 0) + done) * STEPS));
        }
    }

    /** Removes the bar, so that what is printed next starts on a separate line; idempotent. */
    public void finish() {
        if (bar != null) {
            bar.close();
            bar = null;
        }
    }

    @Override
    public void close() {
        finish();
    }
}
