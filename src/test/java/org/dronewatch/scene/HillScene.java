package org.dronewatch.scene;

import java.util.List;
import nl.tudelft.simulation.dsol.simulators.DevsSimulatorInterface;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Approach;
import org.dronewatch.flight.FlightPathSettings.Waypoints;
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.sensor.camera.CameraSettings;

/** Two drones, two cameras and two dice on the hill, sampling at rates that meet now and then. */
class HillScene extends Scene {
    static final double DURATION = 4.0;
    static final long SEED = 42;

    HillScene() {}

    HillScene(DevsSimulatorInterface<Double> simulator) {
        super(simulator);
    }

    @Override
    protected void build() {
        Position camera = new Position(0, 0, 144);
        loadWorld(loadPackaged("hill.obj"));
        add(
                "comer",
                DroneSettings.of(
                        loadPackaged("quadrotor.obj"),
                        new Approach(new Position(2, 30, 145), new Position(2, 5, 145))));
        add(
                "crosser",
                DroneSettings.of(
                        loadPackaged("quadrotor.obj"),
                        new Waypoints(List.of(new Position(-5, 20, 144), new Position(5, 20, 144)))));
        CameraSettings north = CameraSettings.at(camera).withResolution(320, 180);
        add("wide", north.withVerticalFov(1.2));
        add("narrow", north.withVerticalFov(0.6).withRate(4.0));
        add("dice", new DiceSettings(camera, 5.0, 0.9));
        add("more-dice", new DiceSettings(camera, 5.0, 0.9));
        setRun(RunSettings.DEFAULT.withDuration(DURATION).withSeed(SEED));
    }
}
