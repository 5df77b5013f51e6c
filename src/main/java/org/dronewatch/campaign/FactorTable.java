package org.dronewatch.campaign;

import de.siegmar.fastcsv.reader.CommentStrategy;
import de.siegmar.fastcsv.reader.CsvParseException;
import de.siegmar.fastcsv.reader.CsvReader;
import de.siegmar.fastcsv.reader.CsvRecord;
import de.siegmar.fastcsv.reader.FieldMismatchStrategy;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.input.BoundedFile;
import org.dronewatch.setting.input.FileHash;
import org.dronewatch.setting.input.LinkOut;

/** A table of values: the columns are paths of settings, the rows are cases. Immutable; for all threads. */
final class FactorTable {
    /** A table without columns and without rows. */
    static final FactorTable NONE = new FactorTable("", "");

    private static final int LARGEST = 64 << 20;
    private static final int MOST_ROWS = 1_000_000;
    private static final int MOST_COLUMNS = 100;
    private static final char BYTE_ORDER_MARK = '\uFEFF';

    private final String name;
    private final String hash;
    private final List<String> paths = new ArrayList<>();
    private final List<List<String>> rows = new ArrayList<>();
    private final List<Long> lines = new ArrayList<>();

    private FactorTable(String name, String text) {
        this.name = name;
        this.hash = FileHash.ofText(text);
        try (CsvReader<CsvRecord> records = CsvReader.builder()
                .commentStrategy(CommentStrategy.SKIP)
                .missingFieldStrategy(FieldMismatchStrategy.IGNORE)
                .extraFieldStrategy(FieldMismatchStrategy.IGNORE)
                .ofCsvRecord(text)) {
            for (CsvRecord record : records) {
                if (paths.isEmpty()) {
                    addHeader(record);
                } else {
                    addRow(record);
                }
            }
        } catch (CsvParseException e) {
            throw new InputException(name + ": not a table: " + PlainText.value(e.getMessage()), e);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Reads a file: in UTF-8, separated by commas, up to 64 MB, 100 columns and a million rows.
     *
     * @param directory directory of the campaign file
     * @param given its name, relative to that directory
     * @throws InputException with a one-line message when it is elsewhere, cannot be read, or is not such a table
     */
    static FactorTable read(Path directory, String given) {
        Path file = directory.resolve(given).normalize();
        if (!file.startsWith(directory.normalize())) {
            throw new InputException(
                    "table " + PlainText.value(given) + ": must lie in the directory of the campaign file or below it");
        }
        String text = new String(BoundedFile.read(file, LARGEST), StandardCharsets.UTF_8);
        LinkOut.refuse(directory, file, "table");
        if (text.indexOf('\0') >= 0) {
            throw new InputException(PlainText.value(file) + ": is not text; a table is a CSV file in UTF-8");
        }
        boolean marked = !text.isEmpty() && text.charAt(0) == BYTE_ORDER_MARK;
        FactorTable table = new FactorTable(PlainText.value(file), marked ? text.substring(1) : text);
        if (table.rows.isEmpty()) {
            throw new InputException(table.name + ": must have a line with the paths of settings and at least one row");
        }
        return table;
    }

    private void addHeader(CsvRecord record) {
        Set<String> seen = new HashSet<>();
        for (String column : record.getFields()) {
            String path = column.strip();
            if (path.isEmpty() || !seen.add(path)) {
                throw new InputException(name + ":" + record.getStartingLineNumber() + ": column "
                        + (paths.size() + 1)
                        + (path.isEmpty() ? " has no path" : ": " + PlainText.value(path) + " appears twice"));
            }
            checkPath(path, record.getStartingLineNumber());
            paths.add(path);
        }
        if (paths.size() > MOST_COLUMNS) {
            throw new InputException(
                    name + ":1: has " + paths.size() + " columns but must have at most " + MOST_COLUMNS);
        }
    }

    private void checkPath(String path, long line) {
        try {
            VariedPaths.checkSeed(path);
            VariedPaths.checkApart(path, paths);
        } catch (IllegalArgumentException e) {
            throw new InputException(
                    name + ":" + line + ": column " + (paths.size() + 1) + ": " + PlainText.line(e.getMessage()), e);
        }
    }

    private void addRow(CsvRecord record) {
        String line = name + ":" + record.getStartingLineNumber() + ": ";
        if (record.getFieldCount() != paths.size()) {
            throw new InputException(line + "number of values is " + record.getFieldCount() + " but must be "
                    + paths.size() + ", one for each column");
        }
        if (rows.size() == MOST_ROWS) {
            throw new InputException(line + "more than " + MOST_ROWS + " rows");
        }
        List<String> row = record.getFields().stream().map(String::strip).toList();
        int empty = row.indexOf("");
        if (empty >= 0) {
            throw new InputException(line + paths.get(empty) + ": is empty");
        }
        rows.add(row);
        lines.add(record.getStartingLineNumber());
    }

    /** The paths of the settings, in the order of the columns. */
    List<String> paths() {
        return List.copyOf(paths);
    }

    /** The number of rows. */
    int size() {
        return rows.size();
    }

    /** The values of a row, from 0. */
    List<String> row(int number) {
        return rows.get(number);
    }

    /** The file, line and path of a value, for messages. */
    String location(int row, int column) {
        return name + ":" + lines.get(row) + ": " + paths.get(column);
    }

    /** SHA-256 of its text. */
    String hash() {
        return hash;
    }
}
