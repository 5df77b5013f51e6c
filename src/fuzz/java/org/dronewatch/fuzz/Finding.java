package org.dronewatch.fuzz;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Properties;
import java.util.stream.Stream;

/**
 * A failure for which a reproducer was written.
 *
 * @param directory where its reproducer is
 * @param number of its case
 * @param shape what distinguishes it from others
 * @param seconds since its target was started
 */
record Finding(Path directory, long number, String shape, double seconds) {

    /** All findings of a target, in the order in which they were found. */
    static List<Finding> readAll(Path home) throws IOException {
        List<Finding> findings = new ArrayList<>();
        if (!Files.isDirectory(home)) {
            return findings;
        }
        try (Stream<Path> found = Files.list(home)) {
            for (Path directory : found.toList()) {
                if (Files.exists(directory.resolve(FuzzCase.PROPERTIES)) && !directory.endsWith("work")) {
                    Properties properties = FuzzCase.properties(directory);
                    findings.add(new Finding(
                            directory,
                            Long.parseLong(properties.getProperty("case", "-1")),
                            properties.getProperty("shape", ""),
                            Double.parseDouble(properties.getProperty("seconds", "0"))));
                }
            }
        }
        findings.sort(Comparator.comparing(Finding::number));
        return findings;
    }
}
