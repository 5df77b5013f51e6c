package org.dronewatch.sound;

import de.siegmar.fastcsv.reader.CsvReader;
import de.siegmar.fastcsv.reader.NamedCsvRecord;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Spelling;

/**
 * A table of the library, indexed by the names in its column {@code name}.
 *
 * @param <T> type of a row
 */
public final class CsvTable<T> {

    private final String what;
    private final Map<String, T> rows;

    /**
     * Reads a table from the resources beside this class.
     *
     * @param what the word for a row in messages
     * @param toRow converts the fields of a row
     */
    public CsvTable(String resource, String what, Function<NamedCsvRecord, T> toRow) {
        this.what = what;
        Map<String, T> read = new LinkedHashMap<>();
        try (InputStream stream = Objects.requireNonNull(CsvTable.class.getResourceAsStream(resource));
                Reader text = new InputStreamReader(stream, StandardCharsets.UTF_8);
                CsvReader<NamedCsvRecord> records = CsvReader.builder().ofNamedCsvRecord(text)) {
            for (NamedCsvRecord row : records) {
                read.put(row.getField("name"), toRow.apply(row));
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        this.rows = Collections.unmodifiableMap(read);
    }

    /** The names of all rows, in the order of the table. */
    public Set<String> names() {
        return rows.keySet();
    }

    /** The row with this name; empty if there is none. */
    public Optional<T> find(String name) {
        return Optional.ofNullable(rows.get(name));
    }

    /**
     * The row with this name.
     *
     * @throws InputException if there is none; its message names the closest matches
     */
    public T get(String name) {
        return find(name)
                .orElseThrow(() -> new InputException(
                        "unknown " + what + " '" + name + "'; " + Spelling.closestMatches(name, rows.keySet())));
    }
}
