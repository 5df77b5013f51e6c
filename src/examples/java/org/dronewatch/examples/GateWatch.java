package org.dronewatch.examples;

import java.util.List;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Waypoints;
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.sensor.camera.CameraSettings;

/** A house on a hill whose roof camera watches the path to its gate. */
public class GateWatch extends Scene {
    private static final Position HOUSE = new Position(0, 0, 132);
    private static final Position GATE = new Position(0, 45, 133);

    @Override
    protected void build() {
        loadWorld(loadPackaged("hill.obj"));
        loadWorld(loadPackaged("house.obj").withPosition(HOUSE));

        Position start = new Position(120, 250, 160);
        Position turn = new Position(-20, 120, 150);
        add(
                "intruder",
                DroneSettings.of(loadPackaged("quadrotor.obj"), new Waypoints(List.of(start, turn, GATE)))
                        .withSpeed(12.0));

        Position roof = HOUSE.plus(new Position(0, 7.5, 12));
        add("roof", CameraSettings.at(roof).withLookAt(turn).withHorizontalFov(Math.toRadians(60)));

        setRun(RunSettings.DEFAULT.withDuration(40.0));
    }
}
