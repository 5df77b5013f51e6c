package org.dronewatch.flight;

import java.nio.file.Path;
import java.util.Optional;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.FileName;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.world.Ground;

/**
 * A flight of an earlier run, from its {@code flights.csv}: a steered flight is repeated bit for bit. After the last
 * row, the drone continues with the velocity and the attitude of that row. The setting {@code speed} has no effect.
 *
 * @param file path of the {@code flights.csv}
 * @param drone id of the drone in the file; this drone's own id by default
 * @param run number of the run in the file, 0 to 1,000,000
 */
public record Recorded(
        @FileName String file, Optional<String> drone, @In(value = Quantity.NUMBER, from = 0, to = 1_000_000) int run)
        implements FlightPathSettings {
    /** Checks the limits. */
    public Recorded {
        Limits.check(Recorded.class, file, drone, run);
        if (file.isBlank()) {
            throw new IllegalArgumentException("file is empty: it must name a flights.csv");
        }
    }

    /** The drone's own flight in the first run. */
    @Defaults("file")
    public static Recorded of(String file) {
        return new Recorded(file, Optional.empty(), 0);
    }

    /**
     * The flight of a named drone, from a file relative to the working directory. A run does not use this method, since
     * its files are relative to the scene's directory.
     *
     * @throws IllegalArgumentException when no drone is named
     * @throws org.dronewatch.setting.InputException when the file cannot be read, is invalid or has no such flight
     */
    @Override
    public FlightPath create(double speed, double acceleration, Ground ground) {
        String named =
                drone.orElseThrow(() -> new IllegalArgumentException("outside a scene, the drone must be named"));
        return FlightsFile.read(Path.of(file), file).flight(run, named);
    }
}
