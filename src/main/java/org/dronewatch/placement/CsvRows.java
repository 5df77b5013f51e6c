package org.dronewatch.placement;

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
import java.util.List;
import java.util.function.Consumer;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.input.BoundedFile;

/** The records of a CSV file with named columns. */
final class CsvRows {
    private static final int LARGEST = 64 << 20;
    private static final char BYTE_ORDER_MARK = '\uFEFF';

    private final String name;
    private final List<String> columns = new ArrayList<>();
    private final List<String> known;
    private final int required;

    /**
     * A file.
     *
     * @param known the columns that it may have
     * @param required number of these columns, counted from the first, that the file must have
     */
    private CsvRows(Path file, List<String> known, int required) {
        this.name = PlainText.value(file);
        this.known = known;
        this.required = required;
    }

    /**
     * Reads a file of at most 64 MB, in UTF-8, separated by commas; lines that begin with {@code #} are comments.
     *
     * @throws InputException in one line, with file, line and column, when it is not such a file
     */
    static void read(Path file, List<String> known, int required, Consumer<CsvRow> each) {
        String text = new String(BoundedFile.read(file, LARGEST), StandardCharsets.UTF_8);
        CsvRows rows = new CsvRows(file, known, required);
        if (text.indexOf('\0') >= 0) {
            throw new InputException(rows.name + ": is not text; a table is a CSV file in UTF-8");
        }
        boolean isMarked = !text.isEmpty() && text.charAt(0) == BYTE_ORDER_MARK;
        try (CsvReader<CsvRecord> records = CsvReader.builder()
                .commentStrategy(CommentStrategy.SKIP)
                .missingFieldStrategy(FieldMismatchStrategy.IGNORE)
                .extraFieldStrategy(FieldMismatchStrategy.IGNORE)
                .ofCsvRecord(isMarked ? text.substring(1) : text)) {
            for (CsvRecord record : records) {
                rows.accept(record, each);
            }
        } catch (CsvParseException e) {
            throw new InputException(rows.name + ": not a table: " + PlainText.value(e.getMessage()), e);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        if (rows.columns.isEmpty()) {
            throw new InputException(rows.name + ": is empty; the first line must name the columns: "
                    + String.join(", ", known.subList(0, required)));
        }
    }

    private void accept(CsvRecord record, Consumer<CsvRow> each) {
        String location = name + ":" + record.getStartingLineNumber();
        List<String> fields = record.getFields().stream().map(String::strip).toList();
        if (columns.isEmpty()) {
            addHeader(location, fields);
        } else if (fields.size() != columns.size()) {
            throw new InputException(
                    location + ": number of values is " + fields.size() + " but must be " + columns.size());
        } else {
            each.accept(new CsvRow(location, columns, fields));
        }
    }

    private void addHeader(String location, List<String> fields) {
        for (String column : fields) {
            if (!known.contains(column)) {
                throw new InputException(location + ": column '" + PlainText.value(column) + "' must be one of "
                        + String.join(", ", known));
            }
            if (columns.contains(column)) {
                throw new InputException(location + ": column '" + column + "' appears twice");
            }
            columns.add(column);
        }
        for (String column : known.subList(0, required)) {
            if (!columns.contains(column)) {
                throw new InputException(location + ": column '" + column + "' is missing");
            }
        }
    }
}
