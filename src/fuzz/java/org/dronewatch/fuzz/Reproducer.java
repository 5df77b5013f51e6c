package org.dronewatch.fuzz;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;

/** Writes a failure as a directory with all that is needed to see it again, in the form of the regression corpus. */
final class Reproducer {
    private final Path directory;
    private final String target;
    private final long seed;

    /**
     * Writes reproducers of one target.
     *
     * @param directory holds a directory for each failure
     * @param target the target's name
     * @param seed seed of the run
     */
    Reproducer(Path directory, String target, long seed) {
        this.directory = directory;
        this.target = target;
        this.seed = seed;
    }

    /**
     * Writes one; a smaller one overwrites that of the same case.
     *
     * @param number of the case
     * @param shape what distinguishes this failure from others
     * @param seconds since the target was started
     */
    Path write(FuzzCase input, long number, String shape, Throwable problem, double seconds) throws IOException {
        Path place = directory.resolve(target + "-" + number);
        Scratch.delete(place);
        Files.createDirectories(place);
        Map<String, String> further = new LinkedHashMap<>();
        further.put("target", target);
        further.put("seed", Long.toString(seed));
        further.put("case", Long.toString(number));
        further.put("shape", shape);
        further.put("seconds", String.format("%.1f", seconds));
        input.store(place, further);
        Files.writeString(place.resolve("README.txt"), readme(input, number, problem, place));
        return place;
    }

    private String readme(FuzzCase input, long number, Throwable problem, Path place) {
        StringBuilder text = new StringBuilder();
        text.append("Input:    ").append(Messages.printable(input.what())).append('\n');
        if (!input.arguments().isEmpty()) {
            text.append("Command:  dronewatch ");
            text.append(Messages.printable(String.join(" ", input.arguments()))).append("   ({} is this directory)\n");
        }
        text.append("Expected: ").append(expected(problem)).append('\n');
        text.append("Happened: ")
                .append(Messages.printable(String.valueOf(problem.getMessage())))
                .append('\n');
        text.append("Again:    mvn -q -Pfuzz test -Dfuzz.replay=").append(place).append('\n');
        text.append("As made:  mvn -q -Pfuzz test -Dfuzz.targets=").append(target);
        text.append(" -Dfuzz.seed=")
                .append(seed)
                .append(" -Dfuzz.case=")
                .append(number)
                .append('\n');
        if (!(problem instanceof Failure)) {
            text.append('\n').append(problem.getClass().getName()).append('\n');
            for (StackTraceElement frame : problem.getStackTrace()) {
                text.append("    at ").append(frame).append('\n');
            }
        }
        return text.toString();
    }

    private static String expected(Throwable problem) {
        if (problem instanceof Failure failure) {
            return failure.expected();
        }
        return problem instanceof Watchdog.Hang ? "an end within the time limit" : "no exception that is not caught";
    }
}
