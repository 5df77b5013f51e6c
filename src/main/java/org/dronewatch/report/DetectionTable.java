package org.dronewatch.report;

import org.dronewatch.report.file.Numbers;
import org.dronewatch.report.file.Table;
import org.dronewatch.run.DetectionEvent;
import org.dronewatch.run.Frame;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.alarm.FalseAlarmSource;

/** The rows of {@code detections.csv}: what sensors gain, lose, and mistake for a drone. */
final class DetectionTable {
    /** The columns of the table. */
    static final String COLUMNS = "run,time_s,event,sensor,kind,drone,range_m,value,threshold,unit,heard_s";

    private final Table table;

    DetectionTable(Table table) {
        this.table = table;
    }

    /**
     * Adds that a sensor gains or loses a drone; if the sensor begins to detect a bird, that is a false alarm with the
     * bird's name.
     */
    void add(DetectionEvent event) {
        Observation observation = event.observation();
        if (event.gained() || !observation.isBird()) {
            String name = observation.isBird() ? "false" : event.gained() ? "gained" : "lost";
            add(event.run(), name, observation, Numbers.text(observation.range()));
        }
    }

    /**
     * Adds rows for false alarms: their event has a separate name, and they have no drone. One that lasts has a single
     * row, for its beginning.
     */
    void addFalseAlarms(Frame frame) {
        for (Observation observation : frame.observations()) {
            if (FalseAlarmSource.isNew(observation) && observation.isDetected()) {
                add(frame.run(), "false", observation, measuredRange(observation));
            }
        }
    }

    private static String measuredRange(Observation alarm) {
        return alarm.sighting()
                .filter(sighting -> sighting.range().isPresent())
                .map(sighting -> Numbers.text(sighting.range().getAsDouble()))
                .orElse("");
    }

    private void add(int run, String event, Observation o, String range) {
        table.row(
                Integer.toString(run),
                Numbers.text(o.time()),
                event,
                o.sensor(),
                o.kind(),
                o.drone(),
                range,
                Numbers.text(o.value()),
                Numbers.text(o.threshold()),
                o.unit(),
                Numbers.text(o.arrival()));
    }
}
