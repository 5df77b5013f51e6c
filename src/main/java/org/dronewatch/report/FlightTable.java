package org.dronewatch.report;

import org.dronewatch.flight.FlightPath;
import org.dronewatch.flight.FlightsFile;
import org.dronewatch.flight.Leg;
import org.dronewatch.flight.Legs;
import org.dronewatch.run.RunInfo;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.SceneListener;
import org.dronewatch.run.Stage;

/** Writes {@code flights.csv}: how each drone flew in each run, at the run's end. */
final class FlightTable implements SceneListener, AutoCloseable {
    /** Ten samples a second: with an acceleration of 2.5 m/s2 a flight is written to 3 mm. */
    static final double STEP = 0.1;

    /** The most samples of all drones in one run; longer steps keep a long run with many drones to some 15 MB. */
    static final int MOST_SAMPLES = 100_000;

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
        int drones = stage.flights().size();
        double step = step(result.simulated(), drones);
        stage.flights().forEach((id, path) -> write(result.run(), id, path, result.simulated(), step));
        stage = null;
    }

    /** The time between two samples, s. */
    static double step(double simulated, int drones) {
        return Math.max(STEP, simulated * drones / MOST_SAMPLES);
    }

    private void write(int run, String id, FlightPath path, double simulated, double step) {
        for (Leg leg : Legs.of(path, simulated, step)) {
            table.row(FlightsFile.row(run, id, leg));
        }
    }

    @Override
    public void close() {
        table.close();
    }
}
