package org.dronewatch.app;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.Locale;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/** The message for an error: one line, which says what to do if that is known. */
final class Failure {
    private static final String MORE_WITH_VERBOSE = "; --verbose shows where";

    private Failure() {}

    /** The message in one line; for bad input, one line for each mistake. */
    static String message(Throwable problem) {
        if (problem instanceof InputException) {
            return problem.getMessage();
        }
        String message;
        if (problem instanceof OutOfMemoryError) {
            message = outOfMemory(String.valueOf(problem.getMessage()));
        } else if (problem instanceof StackOverflowError) {
            message = "stack overflow" + place(problem)
                    + "; if this is your own code, a method calls itself endlessly;"
                    + " if not, give Java a larger stack, as in 'java -Xss16m'";
        } else if (problem instanceof LinkageError) {
            message = "a class cannot be loaded: " + PlainText.value(problem)
                    + ": put all jars that the scene needs, in the versions that it was compiled with, on"
                    + " Java's class path";
        } else if (problem instanceof AssertionError) {
            message = "assertion failed" + place(problem) + detail(problem);
        } else {
            message = "internal error: " + PlainText.value(problem) + place(problem);
        }
        return PlainText.line(message) + MORE_WITH_VERBOSE;
    }

    private static String detail(Throwable problem) {
        return problem.getMessage() == null ? "" : ": " + PlainText.value(problem.getMessage());
    }

    private static String place(Throwable problem) {
        StackTraceElement[] trace = problem.getStackTrace();
        return trace.length == 0 ? "" : " at " + trace[0];
    }

    private static String outOfMemory(String reason) {
        if (reason.contains("native thread")) {
            return "no more threads can be started: use fewer with --threads, or raise this process's limit";
        }
        String most = String.format(
                Locale.ROOT, "Java may use %d MB", Runtime.getRuntime().maxMemory() >> 20);
        if (reason.contains("Metaspace")) {
            return "out of memory for classes (" + reason + "): give Java more, as in 'java -XX:MaxMetaspaceSize=1g'";
        }
        return "out of memory (" + reason + "; " + most
                + "): give it more, as in 'java -Xmx4g' or MAVEN_OPTS=-Xmx4g, or use"
                + " smaller pictures (sensors.ID.width and height, --size), fewer --cells, or models with fewer"
                + " triangles";
    }

    /** The stack trace, with its causes. */
    static void printTrace(Throwable problem, PrintWriter target) {
        StringWriter trace = new StringWriter();
        problem.printStackTrace(new PrintWriter(trace, true));
        trace.toString()
                .lines()
                .forEach(line -> target.println((line.startsWith("\t") ? "\t" : "") + PlainText.line(line)));
    }
}
