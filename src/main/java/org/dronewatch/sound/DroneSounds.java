package org.dronewatch.sound;

import de.siegmar.fastcsv.reader.NamedCsvRecord;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.sound.DroneSound.Basis;

/** The drone sounds of the library, each with its source. */
public final class DroneSounds {
    /** The sound of a small quadrotor, the default for drones. */
    public static final String SMALL_QUADROTOR = "c1-quadrotor";

    private static final CsvTable<DroneSound> TABLE = new CsvTable<>("drones.csv", "drone sound", DroneSounds::toSound);

    private static final CsvTable<Optional<Directivity>> DIRECTIVITIES =
            new CsvTable<>("drones.csv", "drone sound", DroneSounds::toDirectivity);

    private DroneSounds() {}

    /** The names, in the order of the table. */
    public static Set<String> names() {
        return TABLE.names();
    }

    /**
     * The sound with this name.
     *
     * @throws org.dronewatch.setting.InputException when there is none; its message names the closest matches
     */
    public static DroneSound get(String name) {
        return TABLE.get(name);
    }

    /** The sound with this name, if there is one. */
    public static Optional<DroneSound> find(String name) {
        return TABLE.find(name);
    }

    /**
     * The directivity that was measured together with the sound of this name; empty if none was measured, or if there
     * is no such sound.
     */
    public static Optional<Directivity> measuredDirectivity(String name) {
        return DIRECTIVITIES.find(name).flatMap(measured -> measured);
    }

    private static Optional<Directivity> toDirectivity(NamedCsvRecord row) {
        String name = row.getField("directivity");
        return name.isEmpty() ? Optional.empty() : Optional.of(Directivity.valueOf(name.toUpperCase(Locale.ROOT)));
    }

    private static DroneSound toSound(NamedCsvRecord row) {
        List<Double> shape = new ArrayList<>();
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            shape.add(Double.parseDouble(row.getField("s" + OctaveBands.nominal(band))));
        }
        return new DroneSound(
                row.getField("name"),
                Double.parseDouble(row.getField("lwa")),
                shape,
                Basis.valueOf(row.getField("basis").toUpperCase(Locale.ROOT)),
                row.getField("source"));
    }
}
