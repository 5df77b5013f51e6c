package org.dronewatch.report;

import org.dronewatch.flight.FlightsFile;
import org.dronewatch.flight.Legs;
import org.dronewatch.report.file.Table;
import org.dronewatch.run.RunInfo;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.SceneListener;
import org.dronewatch.run.Stage;

/** Writes {@code flights.csv}: how each drone flew in each run, at the run's end. */
final class FlightTable implements SceneListener, AutoCloseable {
    private final Table table;
    private Stage stage;

    FlightTable(Table table) {
        this.table = table;
    }

    @Override
    public void runStarted(RunInfo run, Stage itsStage) {
        stage = itsStage;
    }

    @Override
    public void runEnded(RunResult result) {
        Legs.ofAll(stage.flights(), result.simulated())
                .forEach((id, legs) -> legs.forEach(leg -> table.row(FlightsFile.row(result.run(), id, leg))));
        stage = null;
    }

    @Override
    public void close() {
        table.close();
    }
}
