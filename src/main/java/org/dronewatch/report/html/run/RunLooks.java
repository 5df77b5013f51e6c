package org.dronewatch.report.html.run;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.run.Frame;
import org.dronewatch.run.Pointings;
import org.dronewatch.run.Stage;
import org.dronewatch.sensor.Observation;

/**
 * The looks of one run: the best look and the number of detections for each sensor and drone, and the pointings of
 * positioners.
 */
public final class RunLooks {
    /**
     * Intervals of a run in which positioners' last pointings are kept: ten for each instant that {@link Reasons} looks
     * at.
     */
    private static final int INTERVALS = 10 * Reasons.MOMENTS;

    private final Map<List<String>, BestLook> best = new HashMap<>();
    private final Map<List<String>, Double> first = new HashMap<>();
    private final Map<List<String>, long[]> counts = new HashMap<>();
    private final Pointings pointings;
    private final Stage stage;

    /**
     * The looks of a run that has not started yet.
     *
     * @param duration duration of the run, s
     * @param stage site of the run
     */
    RunLooks(double duration, Stage stage) {
        this.stage = stage;
        this.pointings = new Pointings(duration / INTERVALS);
    }

    void add(Frame frame) {
        pointings.add(frame);
        for (Observation o : frame.ofDrones()) {
            List<String> pair = List.of(o.sensor(), o.drone());
            BestLook look = new BestLook(o.arrival(), o.range(), o.value(), o.threshold(), o.unit());
            best.merge(pair, look, (old, now) -> now.margin() > old.margin() ? now : old);
            first.merge(pair, o.arrival(), Math::min);
            long[] count = counts.computeIfAbsent(pair, key -> new long[2]);
            count[0]++;
            count[1] += o.isDetected() ? 1 : 0;
        }
    }

    /** The site of the run. */
    public Stage stage() {
        return stage;
    }

    /** The pointings of the positioners of the run's sensors. */
    public Pointings pointings() {
        return pointings;
    }

    /** The best look of a sensor at a drone. */
    Optional<BestLook> best(String sensor, String drone) {
        return Optional.ofNullable(best.get(List.of(sensor, drone)));
    }

    /**
     * Whether a sensor has observed a drone, detected or not, by a time, s since the start of the run; sound counts
     * once it arrives.
     */
    boolean hasObserved(String sensor, String drone, double time) {
        return first.getOrDefault(List.of(sensor, drone), Double.POSITIVE_INFINITY) <= time;
    }

    /** Fraction of a sensor's looks that detected a drone, 0 to 1. */
    double detecting(String sensor, String drone) {
        long[] count = counts.getOrDefault(List.of(sensor, drone), new long[] {1, 0});
        return (double) count[1] / count[0];
    }
}
