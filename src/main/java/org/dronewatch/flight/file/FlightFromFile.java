package org.dronewatch.flight.file;

import java.nio.file.Path;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.world.Ground;

/** A flight from a file of another program; its position depends on the scene's origin and ground. */
public interface FlightFromFile extends FlightPathSettings {

    /** The name of the file, as given in the settings. */
    String file();

    /** The name of the record component that holds the file's name, such as {@code plan}. */
    String fileSetting();

    /**
     * Reads the file.
     *
     * @param path path of the file
     * @param shown name of the file in messages and in the provenance of a run
     * @throws org.dronewatch.setting.InputException when the file cannot be read, is too large, or has content that is
     *     not supported; the message gives the line or the item
     */
    FlightSource read(Path path, String shown);

    /**
     * Not supported: without a scene, the flight has no geographic position.
     *
     * @throws IllegalArgumentException always
     */
    @Override
    default FlightPath create(double speed, double acceleration, Ground ground) {
        throw new IllegalArgumentException(
                "a flight from a file of latitudes and longitudes needs a scene with an origin");
    }
}
