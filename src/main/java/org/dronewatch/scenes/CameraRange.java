package org.dronewatch.scenes;

import java.util.OptionalDouble;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Approach;
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.sensor.camera.CameraSettings;

/**
 * The range at which a full HD camera detects a small quadrotor. The camera is on a hill and looks north; the drone
 * approaches along the camera's axis at 5 m/s. The flight is repeated for five fields of view.
 */
public final class CameraRange extends Scene {
    /** The area of the quadrotor's silhouette from the front, m2. */
    public static final double FRONTAL_AREA = 0.0528;

    /** The camera is on a mast of 12 m on the hill's level top, from where it sees over the edge into the valleys. */
    private static final Position CAMERA = new Position(0, 0, 144);

    @Override
    protected void build() {
        loadWorld(loadPackaged("hill.obj"));

        Position far = CAMERA.plus(new Position(0, 200, 0));
        Position near = CAMERA.plus(new Position(0, 5, 0));
        add(
                "quadrotor",
                DroneSettings.of(loadPackaged("quadrotor.obj"), new Approach(far, near))
                        .withSpeed(5.0));
        add(
                "camera",
                CameraSettings.at(CAMERA)
                        .withLookAt(far)
                        .withResolution(1920, 1080)
                        .withRate(10.0));

        setRun(RunSettings.DEFAULT.withDuration(39.0));
        sweep("sensors.camera.fov", Math.PI / 6, Math.PI / 5, Math.PI / 4, Math.PI / 3, Math.PI / 2);
    }

    /**
     * The mean range: with a focal length of f pixels, a silhouette of A m2 at d metres covers {@code A (f/d)^2}
     * pixels; the range is the distance d at which this number of pixels equals the detection threshold.
     */
    @Override
    public OptionalDouble expectedRange(SceneSettings settings, String sensor) {
        if (!(settings.sensors().get(sensor) instanceof CameraSettings camera)) {
            return OptionalDouble.empty();
        }
        double threshold = camera.detection().threshold();
        return OptionalDouble.of(camera.focalLength() * Math.sqrt(FRONTAL_AREA / threshold));
    }
}
