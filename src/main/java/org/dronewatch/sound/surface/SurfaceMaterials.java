package org.dronewatch.sound.surface;

import de.siegmar.fastcsv.reader.NamedCsvRecord;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.dronewatch.sound.CsvTable;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.surface.SurfaceMaterial.Wall;

/**
 * The acoustic surfaces of the library, each with its source. The published tables begin at 125 Hz and end at 4 kHz;
 * the band at 63 Hz takes the value at 125 Hz, and that at 8 kHz the value at 4 kHz. Scattering is the same in all
 * bands.
 */
public final class SurfaceMaterials {
    /** The default surface, for materials to which no other is assigned and whose name is not that of a surface. */
    public static final String SOLID = "solid";

    private static final String[] BANDS = {"125", "250", "500", "1000", "2000", "4000"};
    private static final CsvTable<SurfaceMaterial> TABLE =
            new CsvTable<>("materials.csv", "material", SurfaceMaterials::toMaterial);

    private SurfaceMaterials() {}

    /** The names, in the order of the table. */
    public static Set<String> names() {
        return TABLE.names();
    }

    /** The surface with this name; empty if there is none. */
    public static Optional<SurfaceMaterial> find(String name) {
        return TABLE.find(name);
    }

    /**
     * The surface with this name.
     *
     * @throws org.dronewatch.setting.InputException when there is none; its message names the closest matches
     */
    public static SurfaceMaterial get(String name) {
        return TABLE.get(name);
    }

    private static SurfaceMaterial toMaterial(NamedCsvRecord row) {
        double scattering = Double.parseDouble(row.getField("scattering"));
        boolean passes = !row.getField("r125").isEmpty();
        String speed = row.getField("speed");
        return new SurfaceMaterial(
                row.getField("name"),
                bands(row, "a"),
                Collections.nCopies(OctaveBands.COUNT, scattering),
                passes ? bands(row, "r") : List.of(),
                passes ? Wall.valueOf(row.getField("wall").toUpperCase(Locale.ROOT)) : Wall.SHEET,
                speed.isEmpty() ? OptionalDouble.empty() : OptionalDouble.of(Double.parseDouble(speed)),
                row.getField("source"));
    }

    private static List<Double> bands(NamedCsvRecord row, String prefix) {
        List<Double> values = new ArrayList<>();
        for (String band : BANDS) {
            values.add(Double.parseDouble(row.getField(prefix + band)));
        }
        values.add(0, values.get(0));
        values.add(values.get(values.size() - 1));
        return values;
    }
}
