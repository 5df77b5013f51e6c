package org.dronewatch.report.html.run;

import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.dronewatch.run.Frame;
import org.dronewatch.run.RunInfo;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.SceneListener;
import org.dronewatch.run.Stage;
import org.dronewatch.sensor.Observation;

/**
 * Keeps the looks and the sites of the runs that a report shows in full: all runs if there are at most
 * {@value #MAX_RUNS}, otherwise the first and the {@value #WORST_OF_MANY} worst, so that memory does not grow with the
 * number of runs.
 */
public final class Looks implements SceneListener {
    /** Maximum number of runs that are all shown in full. */
    static final int MAX_RUNS = 24;

    /** If there are more runs, the number shown in full besides the first. */
    static final int WORST_OF_MANY = 8;

    private final TreeMap<Integer, RunLooks> kept = new TreeMap<>();
    private final TreeSet<RunRank.Ranked> ranked = new TreeSet<>(RunRank.WORST_FIRST);
    private final Set<String> withReadings = new HashSet<>();
    private int runs = 1;

    @Override
    public void runStarted(RunInfo info, Stage stage) {
        runs = info.runs();
        kept.put(info.run(), new RunLooks(info.settings().run().duration(), stage));
    }

    @Override
    public void observed(Frame frame) {
        kept.get(frame.run()).add(frame);
        for (Observation o : frame.ofDrones()) {
            if (Double.isFinite(o.value()) && o.value() != 0.0) {
                withReadings.add(o.sensor());
            }
        }
    }

    @Override
    public void runEnded(RunResult result) {
        if (runs <= MAX_RUNS || result.run() == 0) {
            return;
        }
        ranked.add(new RunRank.Ranked(result));
        if (ranked.size() > WORST_OF_MANY) {
            kept.remove(ranked.pollLast().run().run());
        }
    }

    /** The looks of a run; empty for one that is not shown in full. */
    public Optional<RunLooks> ofRun(int run) {
        return Optional.ofNullable(kept.get(run));
    }

    /** Whether a sensor has measured a finite, nonzero value for any drone in any run. */
    public boolean hasReadings(String sensor) {
        return withReadings.contains(sensor);
    }
}
