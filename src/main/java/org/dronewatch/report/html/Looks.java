package org.dronewatch.report.html;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.scene.Frame;
import org.dronewatch.scene.Pointings;
import org.dronewatch.scene.SceneListener;
import org.dronewatch.sensor.Observation;

/** Keeps of all looks of a sensor at a drone the best, how many of them detected it, and where mounts pointed. */
public final class Looks implements SceneListener {
    private final Map<List<Object>, Look> best = new HashMap<>();
    private final Map<List<Object>, long[]> counts = new HashMap<>();
    private final Pointings pointings = new Pointings();

    @Override
    public void observed(Frame frame) {
        if (frame.run() == 0) {
            pointings.add(frame);
        }
        for (Observation o : frame.observations()) {
            List<Object> pair = List.of(frame.run(), o.sensor(), o.drone());
            Look look = new Look(o.arrival(), o.range(), o.value(), o.threshold(), o.unit());
            best.merge(pair, look, (old, now) -> now.margin() > old.margin() ? now : old);
            long[] count = counts.computeIfAbsent(pair, key -> new long[2]);
            count[0]++;
            count[1] += o.isDetected() ? 1 : 0;
        }
    }

    /** Where the mounts of the first run's sensors pointed. */
    public Pointings pointings() {
        return pointings;
    }

    /** The best look of a sensor at a drone in a run. */
    Optional<Look> best(int run, String sensor, String drone) {
        return Optional.ofNullable(best.get(List.of(run, sensor, drone)));
    }

    /** Whether a sensor ever had a reading of any drone: not nothing, and not zero. */
    public boolean hasReadings(String sensor) {
        return best.entrySet().stream()
                .anyMatch(look -> look.getKey().get(1).equals(sensor)
                        && Double.isFinite(look.getValue().value())
                        && look.getValue().value() != 0.0);
    }

    /** Which share of its looks detected the drone, 0 to 1. */
    double share(int run, String sensor, String drone) {
        long[] count = counts.getOrDefault(List.of(run, sensor, drone), new long[] {1, 0});
        return (double) count[1] / count[0];
    }
}
