package org.dronewatch.viewer;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.viewer.part.Texts;
import org.dronewatch.viewer.part.TitledTable;
import org.dronewatch.viewer.run.PairReading;
import org.dronewatch.viewer.run.RecordedRun;

/**
 * A table of each sensor with each drone: whether the sensor detects the drone, at what range, and the measured value
 * against the threshold.
 */
final class PairTable extends TitledTable {
    private static final long serialVersionUID = 1L;

    /** Maximum number of pairs shown. */
    private static final int MOST = 2000;

    private final transient List<Row> rows = new ArrayList<>();
    private transient RecordedRun run;

    PairTable() {
        super("sensor", "kind", "drone", "state", "range [m]", "value", "needs");
    }

    private static final class Row {
        private final String sensor;
        private final String kind;
        private final String drone;
        private final boolean isBird;
        private boolean detected;
        private Optional<PairReading> reading = Optional.empty();

        Row(String sensor, String kind, String drone, boolean isBird) {
            this.sensor = sensor;
            this.kind = kind;
            this.drone = drone;
            this.isBird = isBird;
        }
    }

    /** Shows a run at a given time. */
    void show(RecordedRun next, double time) {
        if (next != run) {
            run = next;
            rows.clear();
            Set<String> birds = run.info().settings().birds();
            run.info().settings().enabledSensors().forEach((id, sensor) -> {
                for (String drone : run.info().settings().individualDrones().keySet()) {
                    if (rows.size() < MOST) {
                        rows.add(new Row(id, sensor.kind(), drone, birds.contains(drone)));
                    }
                }
            });
            fireTableDataChanged();
        }
        for (int i = 0; i < rows.size(); i++) {
            Row row = rows.get(i);
            boolean detected = run.isDetected(row.sensor, row.drone, time);
            Optional<PairReading> reading = run.reading(row.sensor, row.drone, time);
            if (detected != row.detected || !reading.equals(row.reading)) {
                row.detected = detected;
                row.reading = reading;
                fireTableRowsUpdated(i, i);
            }
        }
    }

    /** The sensor of a row. */
    String sensor(int row) {
        return rows.get(row).sensor;
    }

    /** Whether the sensor of a row detects its drone. */
    boolean isDetected(int row) {
        return rows.get(row).detected;
    }

    @Override
    public int getRowCount() {
        return rows.size();
    }

    @Override
    public Object getValueAt(int index, int column) {
        Row row = rows.get(index);
        return switch (column) {
            case 0 -> row.sensor;
            case 1 -> row.kind;
            case 2 -> row.isBird ? row.drone + " (bird)" : row.drone;
            case 3 -> row.detected ? "detects" : "-";
            case 4 -> row.reading.map(r -> Texts.value(r.range())).orElse("");
            case 5 -> row.reading.map(r -> Texts.measured(r.value(), r.unit())).orElse("");
            default ->
                row.reading.map(r -> Texts.measured(r.threshold(), r.unit())).orElse("");
        };
    }
}
