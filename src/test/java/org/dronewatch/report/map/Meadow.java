package org.dronewatch.report.map;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Approach;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.fusion.ProtectedZone;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.UpAxis;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.radar.LinkBudget;
import org.dronewatch.sensor.radar.RadarSettings;
import org.dronewatch.sensor.rf.RfSettings;

/** A level meadow with one sensor of each kind, a drone that comes from the north, and one that hovers in the east. */
final class Meadow extends Scene {
    /** Where the hovering drone is: a hundredth of a degree of latitude and of longitude away at 45 degrees north. */
    static final Position AFAR = new Position(788.47, 1111.32, 60);

    private final transient Path directory;
    private final String name;
    private final transient Optional<Origin> origin;

    /** A meadow whose model is written into a directory. */
    Meadow(Path directory, String name, Optional<Origin> origin) {
        this.directory = directory;
        this.name = name;
        this.origin = origin;
        try {
            Files.writeString(
                    directory.resolve("meadow.obj"),
                    "v -900 -900 0\nv 900 -900 0\nv 900 900 0\nv -900 900 0\nf 1 2 3 4\n");
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** The meadow at 45 degrees north and 10 degrees east. */
    static Meadow somewhere(Path directory) {
        return new Meadow(directory, "meadow", Optional.of(Origin.at(Math.toRadians(45), Math.toRadians(10))));
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public Path directory() {
        return directory;
    }

    @Override
    protected void build() {
        loadWorld(load("meadow.obj").withUpAxis(UpAxis.Z));
        origin.ifPresent(this::setOrigin);
        setAlert(AlertSettings.DEFAULT.withProtectedZone(new ProtectedZone(new Position(0, 0, 0), 25), 5));
        Approach flight = new Approach(new Position(0, 160, 30), new Position(0, 5, 4));
        add("visitor", DroneSettings.of(loadPackaged("quadrotor.obj"), flight).withSpeed(20));
        add("kite", DroneSettings.of(loadPackaged("quadrotor.obj"), Hover.at(AFAR)));
        add(
                "eye",
                CameraSettings.at(new Position(0, 0, 2))
                        .withAim(new Aim.Direction(0, 0.2))
                        .withResolution(320, 240)
                        .withRate(5));
        add("ear", AcousticSettings.at(new Position(5, 0, 2)).withRate(2));
        add("dish", RadarSettings.at(new Position(-5, 0, 2), LinkBudget.DataSheet.of(1000, 0.01)));
        add(
                "post",
                RadarSettings.at(new Position(-9, 0, 2), LinkBudget.DataSheet.of(100, 0.01))
                        .withAim(new Aim.Direction(Math.PI / 4, 0))
                        .withFieldOfView(1.5, 1)
                        .withRanges(10, 400));
        add("box", RfSettings.at(new Position(9, 0, 2)));
        setRun(RunSettings.DEFAULT.withDuration(12));
    }
}
