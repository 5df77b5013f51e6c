package org.dronewatch.examples;

import java.nio.file.Path;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.RunReport;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scene.Pilot;
import org.dronewatch.scene.PilotedRun;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;

/** Flies the drone {@code guard} of a scene file round a square, five seconds along each side. */
public final class Patrol implements Pilot {
    private static final double SPEED = 12.0;

    @Override
    public void begin(PilotedRun run) {
        turn(run, new Position(0, SPEED, 0));
    }

    private void turn(PilotedRun run, Position velocity) {
        run.drone("guard").fly(velocity);
        Position toTheRight = new Position(velocity.y(), -velocity.x(), 0);
        run.after(5.0, () -> turn(run, toTheRight));
    }

    /** Runs the scene and writes its results, {@code flights.csv} among them, into a directory. */
    public static SceneResult record(Path scene, Path directory) {
        SceneFile file = new SceneFile(scene);
        SceneRunner runner = new SceneRunner(file).pilot(Patrol::new).notes(System.err::println);
        try (RunReport report = new RunReport(file, directory, true)) {
            SceneResult result = runner.listener(report).run();
            report.inputs(runner.inputs());
            report.finish(result);
            return result;
        }
    }

    public static void main(String[] args) {
        record(Path.of("patrol.yaml"), Path.of("patrol"));
    }
}
