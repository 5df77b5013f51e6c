package org.dronewatch.scenes;

import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sensor.acoustic.level.LevelModel;
import org.dronewatch.sensor.camera.CameraSettings;

/** A quadrotor hovers in a church: is it both seen and heard, by a camera and a microphone 10 m from it? */
public final class ClosedSpace extends Scene {
    private static final Position DRONE = new Position(5, 0, 5);
    private static final Position SENSORS = new Position(-5, 0, 5);

    @Override
    protected void build() {
        loadWorld(loadPackaged("cathedral.obj"));
        setBackgroundNoise(20.0);

        add(
                "quadrotor",
                DroneSettings.of(loadPackaged("quadrotor.obj"), new Hover(DRONE, -Math.PI / 2))
                        .withSoundLevel(55.0));
        add(
                "camera",
                CameraSettings.at(SENSORS)
                        .withLookAt(DRONE)
                        .withResolution(800, 800)
                        .withVerticalFov(0.6918));
        add(
                "microphone",
                AcousticSettings.at(SENSORS)
                        .withPropagation(LevelModel.DEFAULT.withRays(10, 10))
                        .withDrawRays(true));

        setRun(RunSettings.DEFAULT.withDuration(1.0));
    }
}
