package org.dronewatch.sound.surface;

import java.util.Optional;
import java.util.Set;
import org.dronewatch.sound.CsvTable;

/** The ground impedances of the library's surfaces, each with its source. */
public final class Grounds {
    private static final CsvTable<GroundImpedance> TABLE = new CsvTable<>(
            "ground.csv", "ground", row -> new GroundImpedance(Double.parseDouble(row.getField("sigma"))));

    private Grounds() {}

    /** Names of surfaces, in the order of the table. */
    public static Set<String> names() {
        return TABLE.names();
    }

    /** The impedance of the surface with this name; empty for one that is not in the table. */
    public static Optional<GroundImpedance> find(String name) {
        return TABLE.find(name);
    }
}
