package org.dronewatch.flight;

import de.siegmar.fastcsv.reader.CsvParseException;
import de.siegmar.fastcsv.reader.CsvReader;
import de.siegmar.fastcsv.reader.FieldMismatchStrategy;
import de.siegmar.fastcsv.reader.NamedCsvRecord;
import de.siegmar.fastcsv.writer.CsvWriter;
import de.siegmar.fastcsv.writer.LineDelimiter;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Counted;
import org.dronewatch.setting.In;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.Spelling;
import org.dronewatch.setting.input.BoundedFile;
import org.dronewatch.setting.input.FileHash;

/**
 * The flights of a run's {@code flights.csv}: one row for each leg of a flight and one for the flight's end, with
 * numbers at full precision. Times are in seconds since the start of the run, positions in m, velocities in m/s, angles
 * in rad, and {@code gliding_s} is the time since the motors were stopped, empty while they run. Columns may be in any
 * order.
 */
public final class FlightsFile {
    /** The columns, in the order in which a run writes them. */
    public static final List<String> COLUMNS = List.of(
            "run",
            "drone",
            "time_s",
            "x_m",
            "y_m",
            "z_m",
            "vx_m_s",
            "vy_m_s",
            "vz_m_s",
            "yaw_rad",
            "pitch_rad",
            "roll_rad",
            "gliding_s");

    /** The largest file that is read, bytes. */
    static final int LARGEST = 64 << 20;

    /** The greatest number of rows that are read. */
    static final int MOST_ROWS = 1_000_000;

    /** The highest number of a run. */
    private static final int LAST_RUN = 1_000_000;

    /** The longest time, s: more than three years. */
    private static final double LONGEST = 1e8;

    /** The largest component of a velocity, m/s: more than any drone's speed. */
    private static final double FASTEST = 1000.0;

    private final String name;
    private final FileHash hash;
    private final Map<Flight, List<Leg>> flights = new LinkedHashMap<>();

    private record Flight(int run, String drone) {}

    private FlightsFile(String name, byte[] bytes) {
        this.name = PlainText.value(name);
        this.hash = hash(name, bytes);
        try (CsvReader<NamedCsvRecord> rows = CsvReader.builder()
                .missingFieldStrategy(FieldMismatchStrategy.IGNORE)
                .extraFieldStrategy(FieldMismatchStrategy.IGNORE)
                .ofNamedCsvRecord(new String(bytes, StandardCharsets.UTF_8))) {
            int number = 0;
            for (NamedCsvRecord row : rows) {
                if (number == 0) {
                    checkHeader(row.getHeader());
                }
                number++;
                if (number > MOST_ROWS) {
                    throw new InputException(at(row) + "more than " + MOST_ROWS + " rows");
                }
                add(row);
            }
        } catch (CsvParseException e) {
            throw new InputException(this.name + ": not a table: " + PlainText.value(reason(e)), e);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static FileHash hash(String name, byte[] bytes) {
        try {
            return FileHash.of(name, new ByteArrayInputStream(bytes));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String reason(Throwable problem) {
        return problem.getCause() == null ? problem.getMessage() : reason(problem.getCause());
    }

    /**
     * Reads a file.
     *
     * @param shown name of the file in messages and in the provenance of a run
     * @throws InputException when the file cannot be read, is too large or has an invalid row; the message gives the
     *     line
     */
    public static FlightsFile read(Path file, String shown) {
        return new FlightsFile(shown, BoundedFile.read(file, LARGEST));
    }

    private void checkHeader(List<String> header) {
        Set<String> seen = new HashSet<>();
        for (String column : header) {
            if (!seen.add(column)) {
                throw new InputException(name + ":1: column '" + PlainText.value(column) + "' appears twice");
            }
        }
        for (String column : COLUMNS) {
            if (!seen.contains(column)) {
                throw new InputException(name + ":1: no column '" + column + "' among the columns, which must be "
                        + String.join(",", COLUMNS));
            }
        }
    }

    private void add(NamedCsvRecord row) {
        if (row.getFieldCount() != row.getHeader().size()) {
            throw new InputException(at(row) + "has " + Counted.of(row.getFieldCount(), "value") + " but needs "
                    + row.getHeader().size() + ", one for each column");
        }
        double run = number(row, "run", 0.0, LAST_RUN);
        if (run != Math.rint(run)) {
            throw new InputException(at(row) + "run " + run + " must be a whole number");
        }
        double time = number(row, "time_s", 0.0, LONGEST);
        String glide = row.getField("gliding_s");
        FlightState state = new FlightState(
                new Position(place(row, "x_m"), place(row, "y_m"), place(row, "z_m")),
                new Position(velocity(row, "vx_m_s"), velocity(row, "vy_m_s"), velocity(row, "vz_m_s")),
                new Attitude(angle(row, "yaw_rad"), angle(row, "pitch_rad"), angle(row, "roll_rad")),
                glide.isEmpty() ? OptionalDouble.empty() : OptionalDouble.of(number(row, "gliding_s", 0.0, LONGEST)));
        List<Leg> legs =
                flights.computeIfAbsent(new Flight((int) run, row.getField("drone")), flight -> new ArrayList<>());
        if (legs.isEmpty() && time != 0.0) {
            throw new InputException(at(row) + "time_s " + time + " must be 0 in the first row of a flight");
        }
        if (!legs.isEmpty() && time <= legs.get(legs.size() - 1).time()) {
            throw new InputException(at(row) + "time_s " + time + " must be after "
                    + legs.get(legs.size() - 1).time() + ", that of the flight's previous row");
        }
        legs.add(new Leg(time, state));
    }

    /** A coordinate in a row; computed positions may lie a little outside the limits of settings. */
    private double place(NamedCsvRecord row, String column) {
        return number(row, column, -10 * In.FARTHEST, 10 * In.FARTHEST);
    }

    private double velocity(NamedCsvRecord row, String column) {
        return number(row, column, -FASTEST, FASTEST);
    }

    private double angle(NamedCsvRecord row, String column) {
        // The heading on an orbit grows with every turn.
        return number(row, column, -1e9, 1e9);
    }

    private double number(NamedCsvRecord row, String column, double from, double to) {
        String text = row.getField(column);
        double value;
        try {
            value = Double.parseDouble(text);
        } catch (NumberFormatException e) {
            throw new InputException(at(row) + column + " '" + PlainText.value(text) + "' must be a number", e);
        }
        if (!(value >= from && value <= to)) {
            throw new InputException(at(row) + column + " " + value + " must be " + from + " to " + to);
        }
        return value;
    }

    private String at(NamedCsvRecord row) {
        return name + ":" + row.getStartingLineNumber() + ": ";
    }

    /** The file's name and the hash of its bytes, as read. */
    public FileHash hash() {
        return hash;
    }

    /**
     * The flight of a drone in a run.
     *
     * @throws InputException when the file has no flight for that run and drone
     */
    public FlownPath flight(int run, String drone) {
        List<Leg> legs = flights.get(new Flight(run, drone));
        if (legs != null) {
            return new RecordedFlight(legs);
        }
        List<String> drones = flights.keySet().stream()
                .filter(flight -> flight.run() == run)
                .map(flight -> PlainText.value(flight.drone()))
                .toList();
        throw new InputException(name + ": "
                + (drones.isEmpty()
                        ? "has no flight of run " + run
                        : "has no flight of drone '" + drone + "' in run " + run + "; "
                                + Spelling.closestMatches(drone, drones)));
    }

    /**
     * Writes the flights of one run, with the header; a file of that name is replaced.
     *
     * @param run number of the run
     * @param flights legs of each flight, by id of the drone
     * @throws InputException when the file cannot be written
     */
    public static void write(Path file, int run, Map<String, List<Leg>> flights) {
        StringWriter text = new StringWriter();
        CsvWriter rows = CsvWriter.builder().lineDelimiter(LineDelimiter.LF).build(text);
        rows.writeRecord(COLUMNS);
        flights.forEach((drone, legs) -> legs.forEach(leg -> rows.writeRecord(row(run, drone, leg))));
        try {
            rows.close();
            Files.writeString(file, text.toString());
        } catch (IOException e) {
            throw new InputException(
                    PlainText.value(file) + ": cannot be written: " + PlainText.value(e.toString()), e);
        }
    }

    /**
     * The row for a leg, with its values in the order of {@link #COLUMNS}; reading the row back gives the same numbers.
     */
    public static String[] row(int run, String drone, Leg leg) {
        FlightState state = leg.start();
        return new String[] {
            Integer.toString(run),
            drone,
            Double.toString(leg.time()),
            Double.toString(state.position().x()),
            Double.toString(state.position().y()),
            Double.toString(state.position().z()),
            Double.toString(state.velocity().x()),
            Double.toString(state.velocity().y()),
            Double.toString(state.velocity().z()),
            Double.toString(state.attitude().yaw()),
            Double.toString(state.attitude().pitch()),
            Double.toString(state.attitude().roll()),
            state.gliding().isPresent() ? Double.toString(state.gliding().getAsDouble()) : ""
        };
    }
}
