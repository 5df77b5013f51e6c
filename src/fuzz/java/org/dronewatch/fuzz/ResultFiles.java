package org.dronewatch.fuzz;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** What must hold of the results of a run. */
final class ResultFiles {
    private static final List<String> TABLES = List.of("detections.csv", "observations.csv", "summary.json");
    private static final Pattern NOT_A_NUMBER = Pattern.compile("(?<![\\w'\"-])NaN(?![\\w'\"-])");

    private ResultFiles() {}

    /** Searches for what is not a number in the tables and in what was printed. */
    static void check(Path results, String printed) {
        require("standard output", printed);
        try {
            for (String table : TABLES) {
                Path file = results.resolve(table);
                if (Files.exists(file)) {
                    require(table, Files.readString(file));
                }
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void require(String name, String text) {
        Matcher found = NOT_A_NUMBER.matcher(text);
        if (found.find()) {
            String line = text.lines()
                    .filter(one -> NOT_A_NUMBER.matcher(one).find())
                    .findFirst()
                    .orElse("");
            throw new Failure("only numbers in " + name, line);
        }
    }

    /** Compares the tables of two runs byte by byte. */
    static void same(Path one, Path other) throws IOException {
        for (String table : List.of("detections.csv", "observations.csv")) {
            byte[] first = Files.readAllBytes(one.resolve(table));
            byte[] second = Files.readAllBytes(other.resolve(table));
            if (!Arrays.equals(first, second)) {
                throw new Failure("the same " + table + " for any number of threads", "it differs");
            }
        }
    }
}
