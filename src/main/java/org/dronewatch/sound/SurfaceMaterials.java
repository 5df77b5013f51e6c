package org.dronewatch.sound;

import de.siegmar.fastcsv.reader.CsvReader;
import de.siegmar.fastcsv.reader.NamedCsvRecord;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Spelling;
import org.dronewatch.sound.SurfaceMaterial.Wall;

/**
 * The surfaces that come with the library, each with its source. The published tables begin at 125 Hz and end at 4 kHz:
 * 63 Hz takes the value at 125 Hz and 8 kHz that at 4 kHz; scattering is one value for all bands.
 */
public final class SurfaceMaterials {
    /** The surface of what nobody has named a material for. */
    public static final String SOLID = "solid";

    private static final String RESOURCE = "materials.csv";
    private static final String[] BANDS = {"125", "250", "500", "1000", "2000", "4000"};
    private static final Map<String, SurfaceMaterial> TABLE = read();

    private SurfaceMaterials() {}

    /** The names, in the order of the table. */
    public static Set<String> names() {
        return TABLE.keySet();
    }

    /** The surface of a name, or empty. */
    public static Optional<SurfaceMaterial> find(String name) {
        return Optional.ofNullable(TABLE.get(name));
    }

    /**
     * The surface of a name.
     *
     * @throws InputException when there is none; names the nearest ones
     */
    public static SurfaceMaterial get(String name) {
        return find(name)
                .orElseThrow(() -> new InputException("unknown material '" + name + "'; nearest are "
                        + String.join(", ", Spelling.nearest(name, TABLE.keySet(), 3))));
    }

    private static Map<String, SurfaceMaterial> read() {
        Map<String, SurfaceMaterial> table = new LinkedHashMap<>();
        try (InputStream stream = Objects.requireNonNull(SurfaceMaterials.class.getResourceAsStream(RESOURCE));
                Reader text = new InputStreamReader(stream, StandardCharsets.UTF_8);
                CsvReader<NamedCsvRecord> rows = CsvReader.builder().ofNamedCsvRecord(text)) {
            for (NamedCsvRecord row : rows) {
                SurfaceMaterial material = toMaterial(row);
                table.put(material.name(), material);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return Collections.unmodifiableMap(table);
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
