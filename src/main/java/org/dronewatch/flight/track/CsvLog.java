package org.dronewatch.flight.track;

import de.siegmar.fastcsv.reader.CsvParseException;
import de.siegmar.fastcsv.reader.CsvReader;
import de.siegmar.fastcsv.reader.FieldMismatchStrategy;
import de.siegmar.fastcsv.reader.NamedCsvRecord;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.time.DateTimeException;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.geo.EarthPoint;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/**
 * Reads a log in CSV: a header, then a row for each time. Columns are recognised by their names, in any order; other
 * columns are ignored.
 */
final class CsvLog {
    private static final double HIGHEST = 100_000.0;

    /** The largest time on any clock: the largest numbers are those of microseconds since 1970. */
    private static final double LATEST = 1e16;

    private final String name;
    private final Fixes fixes;

    private CsvLog(String name) {
        this.name = name;
        this.fixes = new Fixes(name);
    }

    /**
     * Reads a file.
     *
     * @param shown name of the file in messages
     * @param heights level from which heights are measured, which determines the column to use if there are several
     * @param track must be empty: a log has one flight
     * @throws InputException with a one-line message when columns are missing, or a row is invalid
     */
    static Fixes.Points read(String shown, byte[] bytes, Track.Heights heights, Optional<String> track) {
        String name = PlainText.value(shown);
        if (track.isPresent()) {
            throw new InputException(name + ": a CSV log has no named tracks: leave 'track' out");
        }
        String text = new String(bytes, StandardCharsets.UTF_8);
        String header = text.lines().findFirst().orElse("");
        char separator = header.indexOf('\t') >= 0 ? '\t' : header.indexOf(';') >= 0 ? ';' : ',';
        return new CsvLog(name).read(text.startsWith("\uFEFF") ? text.substring(1) : text, separator, heights);
    }

    private Fixes.Points read(String text, char separator, Track.Heights heights) {
        try (CsvReader<NamedCsvRecord> rows = CsvReader.builder()
                .fieldSeparator(separator)
                .missingFieldStrategy(FieldMismatchStrategy.IGNORE)
                .extraFieldStrategy(FieldMismatchStrategy.IGNORE)
                .ofNamedCsvRecord(text)) {
            LogColumns columns = null;
            for (NamedCsvRecord row : rows) {
                if (columns == null) {
                    columns = LogColumns.of(name, row.getHeader(), heights);
                }
                add(row, columns);
            }
            return fixes.points(columns == null ? List.of() : List.of(columns.inWords()));
        } catch (CsvParseException e) {
            throw new InputException(name + ": not a table: " + PlainText.value(reason(e)), e);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String reason(Throwable problem) {
        return problem.getCause() == null ? problem.getMessage() : reason(problem.getCause());
    }

    private void add(NamedCsvRecord row, LogColumns columns) {
        double latitude = number(row, columns.latitude(), -90.0, 90.0);
        double longitude = number(row, columns.longitude(), -180.0, 180.0);
        EarthPoint place = new EarthPoint(Math.toRadians(latitude), Math.toRadians(longitude));
        OptionalDouble height = columns.height()
                .map(column -> OptionalDouble.of(number(row, column, -HIGHEST, HIGHEST)))
                .orElse(OptionalDouble.empty());
        double time = columns.time().map(column -> time(row, column)).orElse(Double.NaN);
        fixes.add(new Fixes.Fix(row.getStartingLineNumber(), time, place, height));
    }

    private double time(NamedCsvRecord row, LogColumns.Column column) {
        String text = field(row, column);
        if (!column.isClock() || text.matches("[-+]?[\\d.]+([eE][-+]?\\d+)?")) {
            return number(row, column, -LATEST, LATEST);
        }
        try {
            return LogTime.seconds(text);
        } catch (DateTimeException e) {
            throw new InputException(
                    at(row) + column.name() + " '" + PlainText.value(text)
                            + "' must be in seconds, or written as in 2026-11-24T03:30:00Z",
                    e);
        }
    }

    private String field(NamedCsvRecord row, LogColumns.Column column) {
        if (row.getFieldCount() <= column.index()) {
            throw new InputException(at(row) + "has " + row.getFieldCount()
                    + (row.getFieldCount() == 1 ? " value, none for " : " values, none for ") + column.name());
        }
        return row.getField(column.index()).strip();
    }

    private double number(NamedCsvRecord row, LogColumns.Column column, double from, double to) {
        String text = field(row, column);
        double value;
        try {
            value = column.unit() * Double.parseDouble(text);
        } catch (NumberFormatException e) {
            throw new InputException(at(row) + column.name() + " '" + PlainText.value(text) + "' must be a number", e);
        }
        if (!(value >= from && value <= to)) {
            throw new InputException(
                    at(row) + column.name() + " " + PlainText.value(text) + " must be " + from + " to " + to);
        }
        return value;
    }

    private String at(NamedCsvRecord row) {
        return name + ":" + row.getStartingLineNumber() + ": ";
    }
}
