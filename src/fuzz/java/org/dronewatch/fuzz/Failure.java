package org.dronewatch.fuzz;

import java.util.Arrays;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** The program did not do what it should. */
public final class Failure extends RuntimeException {
    private static final long serialVersionUID = 1L;
    private static final int LONGEST_SHAPE = 120;
    private static final int FRAMES = 3;

    private static final Pattern SHOWN =
            Pattern.compile("(control character|message repeats more than \\d+ characters of a value)");

    private final String expected;

    /**
     * A failure.
     *
     * @param expected what should have happened
     * @param happened what did happen
     */
    public Failure(String expected, String happened) {
        super(happened);
        this.expected = expected;
    }

    /** What should have happened. */
    public String expected() {
        return expected;
    }

    /**
     * One short line that is the same for failures with the same cause, as far as a message or a stack trace shows it.
     */
    static String shapeOf(Throwable problem) {
        if (problem instanceof Failure failure) {
            return shape(failure.expected + ": " + failure.getMessage());
        }
        return shape(problem.getClass().getSimpleName() + " in " + places(problem.getStackTrace()));
    }

    /** The innermost methods of the program in a stack trace. */
    static String places(StackTraceElement[] trace) {
        return Arrays.stream(trace)
                .filter(frame -> frame.getClassName().startsWith("org.dronewatch."))
                .limit(FRAMES)
                .map(frame -> frame.getClassName().replaceFirst(".*\\.", "") + "." + frame.getMethodName())
                .collect(Collectors.joining(" < "));
    }

    private static String shape(String text) {
        Matcher shown = SHOWN.matcher(text);
        if (shown.find()) {
            // What was shown is as random as the input; only whether it was a warning tells two faults apart.
            boolean warning = text.contains("warning: ") || text.contains("read ");
            return shown.group(1) + (warning ? " in a warning" : " in a message");
        }
        String shape = Messages.printable(text)
                .replaceAll("/\\S+/", "")
                .replaceAll("[A-Za-z][\\w-]*(\\.[\\w-]+)+", "PATH")
                .replaceAll("\\$\\$Lambda[$/\\w]*", "")
                .replaceAll("'[^']*'", "'...'")
                .replaceAll("\"[^\"]*\"", "'...'")
                .replaceAll("('\\.\\.\\.', )+", "")
                .replaceAll("(\\S)\\1{9,}", "$1...")
                .replaceAll("-?\\d+(\\.\\d+)?(E-?\\d+)?", "#");
        return shape.length() <= LONGEST_SHAPE ? shape : shape.substring(0, LONGEST_SHAPE);
    }
}
