package org.dronewatch.render;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Approach;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.UpAxis;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sensor.camera.CameraSettings;

/**
 * A level yard of 60 m x 60 m with a wall of 20 m x 1 m x 8 m across its middle; a camera and a microphone south of it
 * look north, a drone comes from the north above the wall and down before it.
 */
public final class Yard extends Scene {
    /** Where camera and microphone are, m. */
    public static final Position SENSORS = new Position(0, -15, 2);

    private static final int[][] SIDES = {
        {1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5}, {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6},
    };

    private final Path directory;

    /** A yard whose model is written into a directory. */
    public Yard(Path directory) {
        this.directory = directory;
        try {
            Files.writeString(
                    directory.resolve("yard.mtl"), "newmtl brick\nKd 0.8 0.2 0.2\nnewmtl lawn\nKd 0.2 0.8 0.2\n");
            Files.writeString(directory.resolve("yard.obj"), model());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String model() {
        StringBuilder text = new StringBuilder("mtllib yard.mtl\n");
        for (int i = 0; i < 8; i++) {
            text.append(String.format(
                    Locale.ROOT, "v %d %d %d%n", (i & 1) == 0 ? -10 : 10, (i & 2) == 0 ? 0 : 1, (i & 4) == 0 ? 0 : 8));
        }
        text.append("usemtl brick\n");
        for (int[] side : SIDES) {
            text.append(String.format("f %d %d %d %d%n", side[0], side[1], side[2], side[3]));
        }
        text.append("v -30 -30 0\nv 30 -30 0\nv 30 30 0\nv -30 30 0\nusemtl lawn\nf 9 10 11 12\n");
        return text.toString();
    }

    @Override
    public Path directory() {
        return directory;
    }

    @Override
    protected void build() {
        loadWorld(load("yard.obj").withUpAxis(UpAxis.Z));
        surface("brick", "brick_rough");
        surface("lawn", "grass_turf");
        add(
                "quadrotor",
                DroneSettings.of(
                                loadPackaged("quadrotor.obj"),
                                new Approach(new Position(0, 25, 14), new Position(0, -10, 3)))
                        .withSpeed(5.0));
        add(
                "camera",
                CameraSettings.at(SENSORS)
                        .withLookAt(SENSORS.plus(new Position(0, 10, 2)))
                        .withResolution(320, 240)
                        .withRate(10.0));
        add("microphone", AcousticSettings.at(SENSORS.plus(new Position(3, 0, 0))));
        setRun(RunSettings.DEFAULT.withDuration(9.0));
    }

    /** The scene's settings. */
    public SceneSettings settings() {
        return new SceneRunner(this).settings();
    }

    /** The yard made real. */
    public Stage stage() {
        SceneRunner runner = new SceneRunner(this);
        return runner.stage(runner.settings());
    }
}
