package org.dronewatch.viewer;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.viewer.part.TitledTable;
import org.dronewatch.viewer.run.RecordedRun;

/** A table of the drones: where each one is, how fast it flies, and which sensors detect it. */
final class DroneTable extends TitledTable {
    private static final long serialVersionUID = 1L;

    private final transient List<Drone> drones = new ArrayList<>();
    private final transient List<String> detectedBy = new ArrayList<>();

    DroneTable() {
        super("drone", "east, north, up [m]", "speed [m/s]", "detected by");
    }

    /** Shows a run at a given time. */
    void show(RecordedRun run, List<Drone> now, double time) {
        boolean others = drones.size() != now.size();
        drones.clear();
        drones.addAll(now);
        detectedBy.clear();
        for (Drone drone : now) {
            detectedBy.add(String.join(
                    ", ",
                    run.info().settings().enabledSensors().keySet().stream()
                            .filter(sensor -> run.isDetected(sensor, drone.id(), time))
                            .toList()));
        }
        if (others) {
            fireTableDataChanged();
        } else if (!now.isEmpty()) {
            fireTableRowsUpdated(0, now.size() - 1);
        }
    }

    /** The name of the drone of a row. */
    String drone(int row) {
        return drones.get(row).id();
    }

    @Override
    public int getRowCount() {
        return drones.size();
    }

    @Override
    public Object getValueAt(int row, int column) {
        Drone drone = drones.get(row);
        Position at = drone.origin();
        return switch (column) {
            case 0 -> drone.id();
            case 1 -> String.format(Locale.ROOT, "%.1f, %.1f, %.1f", at.x(), at.y(), at.z());
            case 2 ->
                String.format(Locale.ROOT, "%.1f", Position.of(drone.velocity()).length());
            default -> detectedBy.get(row).isEmpty() ? "-" : detectedBy.get(row);
        };
    }
}
