package org.dronewatch.placement;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/**
 * Reads a table of candidates from two CSV files. The first has the column {@code name} and, optionally, {@code cost}
 * (1 by default), {@code kind}, {@code exclusive} and {@code fixed} ({@code true} or {@code false}). The second has the
 * columns {@code row}, {@code candidate}, {@code value} and, optionally, {@code weight} (1 by default), with a line for
 * each value that is not 0. A line without a candidate gives the impact (such as damage) in its row for the case that
 * no chosen candidate detects anything.
 */
public final class CandidateTableReader {
    private static final String NAME = "name";
    private static final String ROW = "row";
    private static final String CANDIDATE = "candidate";
    private static final String VALUE = "value";
    private static final String WEIGHT = "weight";
    private static final int MOST_CANDIDATES = 10_000;
    private static final int MOST_ROWS = 1_000_000;

    private final Map<String, Integer> numbers = new LinkedHashMap<>();
    private final List<Candidate> candidates = new ArrayList<>();
    private final List<Map<Integer, Double>> columns = new ArrayList<>();
    private final Map<String, Integer> rows = new LinkedHashMap<>();
    private double[] weights = new double[16];
    private double[] undetected = new double[16];

    private CandidateTableReader() {}

    /**
     * Reads the two files, of at most 64 MB each, with at most 10,000 candidates and a million rows.
     *
     * @throws InputException when a file is invalid; the message, in one line, gives file, line, column, value and
     *     limit
     */
    public static CandidateTable read(Path candidates, Path values) {
        CandidateTableReader reader = new CandidateTableReader();
        CsvRows.read(candidates, List.of(NAME, "cost", "kind", "exclusive", "fixed"), 1, reader::addCandidate);
        if (reader.candidates.isEmpty()) {
            throw new InputException(PlainText.value(candidates) + ": must have at least one candidate");
        }
        CsvRows.read(values, List.of(ROW, CANDIDATE, VALUE, WEIGHT), 3, reader::addValue);
        return reader.table();
    }

    private void addCandidate(CsvRow line) {
        String name = line.name(NAME);
        if (numbers.putIfAbsent(name, numbers.size()) != null) {
            throw line.fault(NAME, "appears twice");
        }
        if (candidates.size() == MOST_CANDIDATES) {
            throw line.fault(NAME, "more than " + MOST_CANDIDATES + " candidates");
        }
        candidates.add(new Candidate(
                name, line.number("cost", 1.0), line.text("kind"), line.text("exclusive"), line.isTrue("fixed")));
        columns.add(new TreeMap<>());
    }

    private void addValue(CsvRow line) {
        line.name(VALUE);
        double value = line.number(VALUE, 0.0);
        int row = row(line);
        String candidate = line.text(CANDIDATE);
        Integer number = numbers.get(candidate);
        if (candidate.isEmpty()) {
            if (!Double.isNaN(undetected[row])) {
                throw line.fault(ROW, "gives the impact without a detection twice");
            }
            undetected[row] = value;
        } else if (number == null) {
            throw line.fault(CANDIDATE, "is not in the table of candidates");
        } else if (columns.get(number).putIfAbsent(row, value) != null) {
            throw line.fault(CANDIDATE, "has two values in row '" + PlainText.value(line.text(ROW)) + "'");
        }
    }

    private int row(CsvRow line) {
        double weight = line.number(WEIGHT, 1.0);
        Integer earlier = rows.putIfAbsent(line.name(ROW), rows.size());
        int row = earlier == null ? rows.size() - 1 : earlier;
        if (row == MOST_ROWS) {
            throw line.fault(ROW, "more than " + MOST_ROWS + " rows");
        }
        if (row == weights.length) {
            weights = Arrays.copyOf(weights, 2 * row);
            undetected = Arrays.copyOf(undetected, 2 * row);
        }
        if (earlier == null) {
            weights[row] = weight;
            undetected[row] = Double.NaN;
        } else if (weights[row] != weight) {
            throw line.fault(
                    WEIGHT, "differs from that of an earlier line of row '" + PlainText.value(line.text(ROW)) + "'");
        }
        return row;
    }

    private CandidateTable table() {
        List<CandidateColumn> filled = columns.stream()
                .map(values -> new CandidateColumn(
                        values.keySet().stream().mapToInt(Integer::intValue).toArray(),
                        values.values().stream()
                                .mapToDouble(Double::doubleValue)
                                .toArray()))
                .toList();
        return new CandidateTable(
                candidates, filled, Arrays.copyOf(weights, rows.size()), Arrays.copyOf(undetected, rows.size()));
    }
}
