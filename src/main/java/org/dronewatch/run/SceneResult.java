package org.dronewatch.run;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.dronewatch.setting.Spelling;

/**
 * The results of all runs of a scene. A test that asserts these results guards against unnoticed changes in a site's
 * detection ranges.
 *
 * @param scene name of the scene
 * @param seed seed of the scene's random numbers
 * @param threads number of worker threads
 * @param complete false when the runs were stopped early
 * @param runs the runs: one, or one for each value of a sweep
 * @param timing how the computing time was spent
 */
public record SceneResult(String scene, long seed, int threads, boolean complete, List<RunResult> runs, Timing timing) {
    /** Copies the list: later changes by the caller have no effect. */
    public SceneResult {
        runs = List.copyOf(runs);
    }

    /** The results for all sensors and drones in all runs. */
    public List<PairResult> pairs() {
        return runs.stream().flatMap(run -> run.pairs().stream()).toList();
    }

    /** The alerts for all drones other than birds in all runs, with the warning times. */
    public List<AlertResult> alerts() {
        return runs.stream().flatMap(run -> run.alerts().stream()).toList();
    }

    /**
     * The alert for a drone in the first run, with the warning time.
     *
     * @throws IllegalArgumentException when the scene has no such drone
     */
    public AlertResult alert(String drone) {
        return alerts().stream()
                .filter(alert -> alert.run() == 0 && alert.drone().equals(drone))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(unknownAlert(drone)));
    }

    /** Simulated time of all runs, s. */
    public double simulated() {
        return runs.stream().mapToDouble(RunResult::simulated).sum();
    }

    /**
     * Distance at which a sensor first detected a drone in the first run, m; empty if never.
     *
     * @throws IllegalArgumentException when the scene has no such pair
     */
    public OptionalDouble firstDetectionRange(String sensor, String drone) {
        return firstDetectionRange(0, sensor, drone);
    }

    /**
     * Distance at which a sensor first detected a drone in one run of a sweep, m; empty if never.
     *
     * @param run number of the run, from 0
     * @throws IllegalArgumentException when there is no such run or pair
     */
    public OptionalDouble firstDetectionRange(int run, String sensor, String drone) {
        List<PairResult> inRun =
                pairs().stream().filter(pair -> pair.run() == run).toList();
        return inRun.stream()
                .filter(pair -> pair.sensor().equals(sensor) && pair.drone().equals(drone))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(unknownPair(inRun, run, sensor, drone)))
                .range();
    }

    private String unknownAlert(String drone) {
        return runs.stream()
                .filter(run -> run.run() == 0)
                .findFirst()
                .map(run -> Spelling.unknown(
                        "drone",
                        drone,
                        "the run",
                        run.alerts().stream().map(AlertResult::drone).toList()))
                .orElseGet(() -> noRun(0));
    }

    private String unknownPair(List<PairResult> inRun, int run, String sensor, String drone) {
        if (runs.stream().noneMatch(one -> one.run() == run)) {
            return noRun(run);
        }
        List<String> sensors = inRun.stream().map(PairResult::sensor).distinct().toList();
        return sensors.contains(sensor)
                ? Spelling.unknown(
                        "drone",
                        drone,
                        "the run",
                        inRun.stream().map(PairResult::drone).distinct().toList())
                : Spelling.unknown("sensor", sensor, "the run", sensors);
    }

    private String noRun(int run) {
        return Spelling.unknown(
                "run",
                Integer.toString(run),
                "the result",
                runs.stream().map(one -> Integer.toString(one.run())).toList());
    }

    /** The points of the sweep, sensor by sensor in each run; none for a scene without a sweep. */
    public List<SweepPoint> sweep() {
        List<SweepPoint> points = new ArrayList<>();
        for (RunResult run : runs) {
            run.settings().sweep().ifPresent(sweep -> {
                Object value = sweep.valueIn(run.settings());
                for (String sensor : run.settings().enabledSensors().keySet()) {
                    points.add(new SweepPoint(sweep.parameter(), value, sensor, run.firstDetectionRange(sensor)));
                }
            });
        }
        return points;
    }
}
