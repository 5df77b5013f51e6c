package org.dronewatch.fuzz;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** What must hold of any text that the program shows, whatever its input was. */
public final class Messages {
    /** Characters of the longest line, with the directory of the case counted as two. */
    static final int LONGEST_LINE = 600;

    /** Characters of a value that may be repeated in a message. */
    private static final int LONGEST_ECHO = 200;

    private static final Pattern ECHO = Pattern.compile("(\\S)\\1{" + LONGEST_ECHO + ",}");
    private static final Pattern TRACE = Pattern.compile(
            "(?m)^\\s*at [\\w.$]+\\(|Exception in thread|\\bjavax?\\.[a-z]+\\.[\\w.]*(Exception|Error)\\b");
    private static final String INTERNAL = "internal error";

    /** Overrides of the direction of writing: they make a terminal show another text than is there. */
    private static final String DIRECTIONS = "\u202A\u202B\u202C\u202D\u202E\u2066\u2067\u2068\u2069\u2028\u2029";

    private Messages() {}

    /** What is wrong with all that a command showed, or empty. */
    public static Optional<String> fault(CommandRun run, Path directory) {
        if (run.code() != 0 && run.code() != 2) {
            return Optional.of("exit code " + run.code() + ": " + firstLine(run.err()));
        }
        if (run.code() == 2 && run.err().isBlank()) {
            return Optional.of("exit code 2 without a message");
        }
        return fault(run.err(), directory).or(() -> fault(run.out(), directory));
    }

    /** What is wrong with a text that is shown, or empty. */
    public static Optional<String> fault(String text, Path directory) {
        if (text.contains(INTERNAL)) {
            return Optional.of(line(text, text.indexOf(INTERNAL)));
        }
        Matcher trace = TRACE.matcher(text);
        if (trace.find()) {
            return Optional.of("shows what belongs to a stack trace: " + line(text, trace.start()));
        }
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            boolean separator = c == '\n' || c == '\r' && i + 1 < text.length() && text.charAt(i + 1) == '\n';
            if (!separator && (Character.isISOControl(c) || DIRECTIONS.indexOf(c) >= 0)) {
                return Optional.of(String.format("control character U+%04X in: %s", (int) c, line(text, i)));
            }
        }
        for (String line :
                text.replace(directory.toString(), FuzzCase.DIRECTORY).split("\r?\n")) {
            if (ECHO.matcher(line).find()) {
                return Optional.of("message repeats more than " + LONGEST_ECHO + " characters of a value: " + line);
            }
            if (line.length() > LONGEST_LINE) {
                return Optional.of("line of " + line.length() + " characters: " + line);
            }
        }
        return Optional.empty();
    }

    /** The lines of an error output that say what is wrong, without those that say what was read. */
    public static List<String> mistakes(String err) {
        return err.lines()
                .filter(line -> !line.startsWith("read ")
                        && !line.startsWith("warning: ")
                        && !line.startsWith("... and ")
                        && !line.isBlank())
                .toList();
    }

    /** The first line that says what is wrong, cut where it is long. */
    public static String firstLine(String err) {
        String line = mistakes(err).stream().findFirst().orElse("nothing was said");
        return line.length() <= LONGEST_LINE ? line : line.substring(0, LONGEST_LINE) + "...";
    }

    private static String line(String text, int at) {
        int start = text.lastIndexOf('\n', at) + 1;
        int end = text.indexOf('\n', at);
        String line = text.substring(start, end < 0 ? text.length() : end);
        return line.length() <= LONGEST_LINE ? line : line.substring(0, LONGEST_LINE) + "...";
    }

    /** A text in which control characters are written out, for terminals and files. */
    public static String printable(String text) {
        StringBuilder shown = new StringBuilder();
        text.chars().forEach(c -> {
            if (Character.isISOControl(c) || Character.getType(c) == Character.FORMAT) {
                shown.append(String.format("\\u%04x", c));
            } else {
                shown.append((char) c);
            }
        });
        return shown.toString();
    }
}
