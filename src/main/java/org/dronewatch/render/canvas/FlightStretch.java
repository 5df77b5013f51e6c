package org.dronewatch.render.canvas;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.DetectionIntervals;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.Stage;

/**
 * A part of a drone's flight during which the same sensors detect it.
 *
 * @param drone name of the drone
 * @param from when the part begins, seconds since the start of the run
 * @param path positions from the beginning of the part to its end, m
 * @param sensors names of the sensors that detect the drone, in the order of the scene; empty if none does
 */
public record FlightStretch(String drone, double from, List<Position> path, List<String> sensors) {
    /** The flight of a whole run has at least this number of points. */
    private static final int STEPS = 2000;

    /** Copies the lists: later changes by the caller have no effect. */
    public FlightStretch {
        path = List.copyOf(path);
        sensors = List.copyOf(sensors);
    }

    /** The flight of a drone in a run that has ended, divided where a sensor gains or loses detection of the drone. */
    public static List<FlightStretch> of(String drone, RunResult run, Stage stage) {
        DetectionIntervals intervals = DetectionIntervals.of(run.events());
        TreeSet<Double> times = new TreeSet<>(List.of(0.0, run.simulated()));
        run.events().stream()
                .map(event -> event.observation())
                .filter(one -> one.drone().equals(drone) && one.arrival() < run.simulated())
                .forEach(one -> times.add(one.arrival()));
        List<FlightStretch> stretches = new ArrayList<>();
        double from = 0.0;
        List<String> before = List.of();
        for (double time : times) {
            List<String> now = run.settings().enabledSensors().keySet().stream()
                    .filter(sensor -> intervals.isDetected(sensor, drone, time))
                    .toList();
            if (time > from && (!now.equals(before) || time == run.simulated())) {
                stretches.add(new FlightStretch(drone, from, path(drone, from, time, run, stage), before));
                from = time;
            }
            before = now;
        }
        return stretches;
    }

    private static List<Position> path(String drone, double from, double to, RunResult run, Stage stage) {
        int steps = (int) Math.ceil(STEPS * (to - from) / run.simulated());
        List<Position> path = new ArrayList<>();
        for (int i = 0; i <= steps; i++) {
            path.add(stage.positionOf(drone, from + (to - from) * i / steps));
        }
        return path;
    }
}
