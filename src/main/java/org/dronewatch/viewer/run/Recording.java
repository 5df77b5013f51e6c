package org.dronewatch.viewer.run;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.run.DetectionEvent;
import org.dronewatch.run.Frame;
import org.dronewatch.run.RunInfo;
import org.dronewatch.run.SceneListener;
import org.dronewatch.run.Stage;

/** The runs of a scene while they are simulated. Written by the thread that simulates, read by any. */
public final class Recording implements SceneListener {
    private final List<RecordedRun> runs = new ArrayList<>();
    private RecordedRun current;
    private boolean finished;
    private boolean frames;

    @Override
    public synchronized void runStarted(RunInfo info, Stage stage) {
        finishCurrent();
        current = new RecordedRun(info, stage);
        runs.add(current);
    }

    @Override
    public synchronized void observed(Frame frame) {
        frames = true;
        current.add(frame);
    }

    @Override
    public synchronized void detectionChanged(DetectionEvent event) {
        current.add(event);
    }

    /** Records that nothing more will follow: all runs are over, or the last was cut short. */
    public synchronized void finish(boolean complete) {
        if (complete) {
            finishCurrent();
        }
        finished = true;
    }

    /** Whether a sensor has looked, which means that everything has been loaded. */
    public synchronized boolean hasFrames() {
        return frames;
    }

    /** Whether all runs have been simulated, or no more will be. */
    public synchronized boolean isFinished() {
        return finished;
    }

    private void finishCurrent() {
        if (current != null) {
            current.finish();
        }
    }

    /** The runs that have begun. */
    public synchronized List<RecordedRun> runs() {
        return List.copyOf(runs);
    }
}
