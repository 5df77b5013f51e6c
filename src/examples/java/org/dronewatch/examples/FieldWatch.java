package org.dronewatch.examples;

import java.nio.file.Path;
import nl.tudelft.simulation.dsol.simulators.DevsSimulatorInterface;
import org.dronewatch.drone.DroneClass;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.RadarSignature;
import org.dronewatch.flight.FlightPathSettings.Approach;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.RunReport;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sensor.acoustic.energy.EnergyModel;
import org.dronewatch.sensor.radar.LinkBudget.DataSheet;
import org.dronewatch.sensor.radar.RadarDetection;
import org.dronewatch.sensor.radar.RadarSettings;

/** A hill with a microphone and a radar that is specified by its data sheet, and the report of a run. */
public class FieldWatch extends Scene {
    private static final long serialVersionUID = 1L;

    /** A scene that is run once. */
    public FieldWatch() {}

    /** A scene that is the model of an experiment. */
    public FieldWatch(DevsSimulatorInterface<Double> simulator) {
        super(simulator);
    }

    @Override
    protected void build() {
        loadWorld(loadPackaged("hill.obj"));

        add(
                "intruder",
                DroneSettings.of(
                                loadPackaged("quadrotor.obj"),
                                new Approach(new Position(600, 400, 180), new Position(0, 0, 150)))
                        .withSpeed(15.0)
                        .withRadar(RadarSignature.of(DroneClass.SMALL_UAV)));

        // The radar detects a steady target of 0.05 m2 at 500 m with a probability of 90 %. Here, noise and the
        // fluctuation of the echo are random.
        Position mast = new Position(0, 0, 150);
        add(
                "radar",
                RadarSettings.at(mast, DataSheet.of(500.0, 0.05))
                        .withFieldOfView(2.0 * Math.PI, Math.toRadians(60))
                        .withDetection(RadarDetection.Chance.DEFAULT));

        // Sound that spreads and is absorbed by the air, instead of the thesis's model, which is the default. Tracing
        // it takes most of the time of a run: this microphone looks only once every 5 s.
        add(
                "microphone",
                AcousticSettings.at(mast).withPropagation(EnergyModel.DEFAULT).withRate(0.2));

        setRun(RunSettings.DEFAULT.withDuration(45.0));
    }

    /** Runs the scene once and writes {@code report.html} and the tables into a directory. */
    public static SceneResult report(Path directory) {
        FieldWatch scene = new FieldWatch();
        SceneRunner runner = new SceneRunner(scene).notes(System.err::println);
        try (RunReport report = new RunReport(scene, directory, false)) {
            SceneResult result = runner.listener(report).run();
            report.inputs(runner.inputs());
            report.finish(result);
            return result;
        }
    }

    public static void main(String[] args) {
        report(Path.of("field"));
    }
}
