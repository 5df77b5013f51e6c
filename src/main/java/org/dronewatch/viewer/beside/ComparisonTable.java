package org.dronewatch.viewer.beside;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.sensor.Observation;
import org.dronewatch.viewer.beside.DetectionComparison.Side;
import org.dronewatch.viewer.part.TitledTable;
import org.dronewatch.viewer.run.RecordedRun;

/**
 * A table of when each drone is first detected in two runs: by any sensor, then by each sensor. For the event thread.
 */
final class ComparisonTable extends TitledTable {
    static final int DIFFERENCE = 4;

    private static final long serialVersionUID = 1L;

    /** Maximum number of rows. */
    private static final int MOST = 2000;

    private transient FirstDetections here;
    private transient FirstDetections there;
    private transient List<Pair> pairs = List.of();
    private final transient List<DetectionComparison> rows = new ArrayList<>();

    /** A drone, and a sensor or any. */
    private record Pair(String drone, Optional<String> sensor) {}

    ComparisonTable() {
        super("drone", "sensor", "this run", "other run", "difference", "now");
    }

    /** Compares two runs at a time, s. */
    void show(RecordedRun shown, RecordedRun other, double time) {
        if (here == null || here.run() != shown || there.run() != other) {
            here = new FirstDetections(shown);
            there = new FirstDetections(other);
            pairs = pairs(here, there);
            rows.clear();
        }
        here.update();
        there.update();
        if (rows.isEmpty()) {
            pairs.forEach(pair -> rows.add(row(pair, time)));
            fireTableDataChanged();
            return;
        }
        for (int i = 0; i < rows.size(); i++) {
            DetectionComparison now = row(pairs.get(i), time);
            if (!now.equals(rows.set(i, now))) {
                fireTableRowsUpdated(i, i);
            }
        }
    }

    /** Compares nothing. */
    void clear() {
        here = null;
        there = null;
        pairs = List.of();
        if (!rows.isEmpty()) {
            rows.clear();
            fireTableDataChanged();
        }
    }

    private static List<Pair> pairs(FirstDetections here, FirstDetections there) {
        Set<String> drones = new LinkedHashSet<>(here.drones());
        drones.addAll(there.drones());
        Set<String> sensors = new LinkedHashSet<>(here.sensors());
        sensors.addAll(there.sensors());
        List<Pair> pairs = new ArrayList<>();
        drones.forEach(drone -> pairs.add(new Pair(drone, Optional.empty())));
        for (String drone : drones) {
            sensors.forEach(sensor -> pairs.add(new Pair(drone, Optional.of(sensor))));
        }
        return List.copyOf(pairs.subList(0, Math.min(MOST, pairs.size())));
    }

    private DetectionComparison row(Pair pair, double time) {
        return new DetectionComparison(pair.drone(), pair.sensor(), side(here, pair, time), side(there, pair, time));
    }

    private static Side side(FirstDetections of, Pair pair, double time) {
        RecordedRun run = of.run();
        boolean exists = of.drones().contains(pair.drone())
                && pair.sensor().map(of.sensors()::contains).orElse(true);
        Optional<Observation> first =
                pair.sensor().map(sensor -> of.of(sensor, pair.drone())).orElseGet(() -> of.ofAny(pair.drone()));
        double then = Math.min(time, run.reached());
        boolean detects = pair.sensor().map(Set::of).orElseGet(of::sensors).stream()
                .anyMatch(sensor -> run.isDetected(sensor, pair.drone(), then));
        return new Side(exists, first, run.isFinished(), detects);
    }

    /** The rows, in order. */
    List<DetectionComparison> rows() {
        return rows;
    }

    @Override
    public int getRowCount() {
        return rows.size();
    }

    @Override
    public Object getValueAt(int index, int column) {
        DetectionComparison row = rows.get(index);
        return switch (column) {
            case 0 -> row.drone();
            case 1 -> row.sensor().orElse("any");
            case 2 -> row.hereText();
            case 3 -> row.thereText();
            case DIFFERENCE -> row.difference();
            default -> row.now();
        };
    }
}
