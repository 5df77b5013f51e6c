package org.dronewatch.report.campaign;

import de.siegmar.fastcsv.reader.CsvParseException;
import de.siegmar.fastcsv.reader.CsvReader;
import de.siegmar.fastcsv.reader.CsvRecord;
import de.siegmar.fastcsv.writer.CsvWriter;
import de.siegmar.fastcsv.writer.LineDelimiter;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.dronewatch.campaign.outcome.CaseResult;
import org.dronewatch.campaign.outcome.DroneOutcome;
import org.dronewatch.report.file.Numbers;

/** Rows of {@code runs.csv}, one for each case and variant. */
final class CaseTable {
    private static final List<String> BEFORE = List.of("case", "variant", "seed");
    private static final List<String> AFTER = List.of(
            "status",
            "error",
            "first_detected_s",
            "first_sensor",
            "range_m",
            "alert_s",
            "warning_s",
            "in_time",
            "bearing_deg",
            "drones",
            "closest_m",
            "cut_short");
    private static final String DONE = "done";
    private static final String FAILED = "failed";

    private final List<String> paths;

    /**
     * A table.
     *
     * @param paths paths of the settings that vary, each of which has a column
     */
    CaseTable(List<String> paths) {
        this.paths = List.copyOf(paths);
    }

    List<String> header() {
        List<String> header = new ArrayList<>(BEFORE);
        header.addAll(paths);
        header.addAll(AFTER);
        return header;
    }

    /** Writes rows with their header; the stream stays open. */
    void write(OutputStream stream, List<CaseResult> results) throws IOException {
        writeRecords(stream, List.of(header()));
        writeRows(stream, results);
    }

    /** Writes rows alone; the stream stays open. */
    void writeRows(OutputStream stream, List<CaseResult> results) throws IOException {
        writeRecords(stream, results.stream().map(CaseTable::row).toList());
    }

    private static void writeRecords(OutputStream stream, List<List<String>> records) throws IOException {
        OutputStreamWriter text = new OutputStreamWriter(stream, StandardCharsets.UTF_8);
        CsvWriter writer = CsvWriter.builder().lineDelimiter(LineDelimiter.LF).build(text);
        records.forEach(writer::writeRecord);
        writer.flush();
        text.flush();
    }

    private static List<String> row(CaseResult result) {
        List<String> row = new ArrayList<>();
        row.add(Integer.toString(result.number()));
        row.add(result.variant());
        row.add(Long.toString(result.seed()));
        row.addAll(result.values());
        row.add(result.isFailed() ? FAILED : DONE);
        row.add(result.error().orElse(""));
        row.add(text(result.firstDetected()));
        row.add(result.firstSensor().orElse(""));
        row.add(text(result.range()));
        row.add(text(result.alert()));
        row.add(text(result.warning()));
        row.add(result.inTime().map(String::valueOf).orElse(""));
        row.add(
                result.bearing().isPresent()
                        ? Numbers.text(Math.toDegrees(result.bearing().getAsDouble()))
                        : "");
        row.add(result.drones().entrySet().stream()
                .map(drone -> drone.getKey() + "=" + word(drone.getValue()))
                .collect(Collectors.joining(" ")));
        row.add(text(result.closest()));
        row.add(Boolean.toString(result.cutShort()));
        return row;
    }

    private static String text(OptionalDouble value) {
        return value.isPresent() ? Numbers.text(value.getAsDouble()) : "";
    }

    /**
     * Reads rows with their header.
     *
     * @throws IOException when the file cannot be read, or is not such a table
     */
    List<CaseResult> read(Path file) throws IOException {
        try (InputStream stream = Files.newInputStream(file)) {
            return read(stream);
        }
    }

    /** Reads such rows to the end of a stream. */
    List<CaseResult> read(InputStream stream) throws IOException {
        List<CaseResult> results = new ArrayList<>();
        try (CsvReader<CsvRecord> records = CsvReader.builder().ofCsvRecord(stream)) {
            boolean isHeader = true;
            for (CsvRecord row : records) {
                if (isHeader && !row.getFields().equals(header()) || row.getFieldCount() != header().size()) {
                    throw new IOException("line " + row.getStartingLineNumber() + " does not belong to this campaign");
                }
                if (!isHeader) {
                    results.add(result(row.getFields()));
                }
                isHeader = false;
            }
        } catch (CsvParseException | IllegalArgumentException e) {
            throw new IOException(e.getMessage(), e);
        }
        return results;
    }

    private CaseResult result(List<String> row) {
        int after = BEFORE.size() + paths.size();
        return new CaseResult(
                Integer.parseInt(row.get(0)),
                row.get(1),
                Long.parseLong(row.get(2)),
                row.subList(BEFORE.size(), after),
                row.get(after).equals(FAILED) ? Optional.of(row.get(after + 1)) : Optional.empty(),
                degrees(row.get(after + 8)),
                number(row.get(after + 2)),
                word(row.get(after + 3)),
                number(row.get(after + 4)),
                number(row.get(after + 5)),
                number(row.get(after + 6)),
                word(row.get(after + 7)).map(Boolean::valueOf),
                number(row.get(after + 10)),
                Boolean.parseBoolean(row.get(after + 11)),
                drones(row.get(after + 9)));
    }

    private static String word(DroneOutcome outcome) {
        return outcome.name().toLowerCase(Locale.ROOT);
    }

    /** Names of drones contain neither spaces nor equals signs. */
    private static Map<String, DroneOutcome> drones(String text) {
        Map<String, DroneOutcome> drones = new LinkedHashMap<>();
        for (String one : text.split(" ")) {
            int end = one.indexOf('=');
            if (end > 0) {
                String word = one.substring(end + 1).toUpperCase(Locale.ROOT);
                drones.put(one.substring(0, end), DroneOutcome.valueOf(word));
            }
        }
        return drones;
    }

    private static OptionalDouble degrees(String text) {
        OptionalDouble degrees = number(text);
        return degrees.isPresent() ? OptionalDouble.of(Math.toRadians(degrees.getAsDouble())) : degrees;
    }

    private static OptionalDouble number(String text) {
        return text.isEmpty() ? OptionalDouble.empty() : OptionalDouble.of(Double.parseDouble(text));
    }

    private static Optional<String> word(String text) {
        return text.isEmpty() ? Optional.empty() : Optional.of(text);
    }
}
