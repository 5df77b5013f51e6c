package org.dronewatch.app;

import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;
import org.dronewatch.scene.Frame;
import org.dronewatch.scene.RunInfo;
import org.dronewatch.scene.SceneListener;

/** A progress bar on standard error, when that is a terminal. */
final class Progress implements SceneListener, AutoCloseable {
    private static final int STEPS = 1000;

    private final String task;
    private ProgressBar bar;
    private RunInfo run;

    Progress(String task) {
        this.task = task;
    }

    /** A bar for so many steps; none without a terminal. */
    static ProgressBar barOf(String task, long steps) {
        return System.console() == null
                ? null
                : new ProgressBarBuilder()
                        .setTaskName(task)
                        .setInitialMax(steps)
                        .setStyle(ProgressBarStyle.ASCII)
                        .setUpdateIntervalMillis(200)
                        .build();
    }

    @Override
    public void runStarted(RunInfo info) {
        run = info;
        if (bar == null) {
            bar = barOf(task, (long) info.runs() * STEPS);
        }
    }

    @Override
    public void observed(Frame frame) {
        if (bar != null) {
            double done = frame.time() / run.settings().run().duration();
            bar.stepTo((long) ((frame.run() + done) * STEPS));
        }
    }

    /** Takes the bar away, so that what is printed next starts on a line of its own; twice is no harm. */
    void finish() {
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
