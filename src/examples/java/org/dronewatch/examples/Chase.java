package org.dronewatch.examples;

import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Orbit;
import org.dronewatch.flight.Steered;
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.scene.DroneInFlight;
import org.dronewatch.scene.Pilot;
import org.dronewatch.scene.PilotedRun;
import org.dronewatch.scene.Scene;
import org.dronewatch.sensor.camera.CameraSettings;

/** A guard drone chases a visitor that circles above a hill, then flies home. */
public class Chase extends Scene {
    private static final long serialVersionUID = 1L;
    private static final Position HOME = new Position(-90, -40, 150);

    @Override
    protected void build() {
        loadWorld(loadPackaged("hill.obj"));
        add(
                "visitor",
                DroneSettings.of(loadPackaged("quadrotor.obj"), Orbit.about(new Position(0, 0, 170), 60))
                        .withSpeed(12.0));
        add(
                "guard",
                DroneSettings.of(loadPackaged("quadrotor.obj"), Steered.from(HOME))
                        .withSpeed(20.0));
        add("camera", CameraSettings.at(new Position(0, 0, 145)).withLookAt(new Position(0, 60, 170)));
        setRun(RunSettings.DEFAULT.withDuration(30.0));
    }

    @Override
    protected Pilot pilot() {
        return new Guard();
    }

    /** Flies towards the visitor, and corrects its course ten times a second; each run creates a new guard. */
    private static final class Guard implements Pilot {
        private PilotedRun run;

        @Override
        public void begin(PilotedRun begun) {
            run = begun;
            steer();
        }

        private void steer() {
            DroneInFlight guard = run.drone("guard");
            Position visitor = run.drone("visitor").state().position();
            Position offset = visitor.minus(guard.state().position());
            if (offset.length() < 3.0) {
                guard.flyTo(HOME, run.time() + 10.0);
                return;
            }
            guard.fly(offset.unit().times(20.0));
            run.after(0.1, this::steer);
        }
    }
}
