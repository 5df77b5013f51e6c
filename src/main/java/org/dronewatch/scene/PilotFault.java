package org.dronewatch.scene;

import java.security.CodeSource;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;
import nl.tudelft.simulation.dsol.simulators.DevsSimulator;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/**
 * An exception that a pilot throws: the user's mistake, not the program's.
 *
 * @param pilot class of the pilot, or of whatever should have created it
 * @param problem the exception
 */
record PilotFault(Class<?> pilot, Throwable problem) {

    /**
     * The mistake in one line: class of the pilot, time, exception, and the line of the user's code.
     *
     * @param time seconds since the start of the run
     */
    InputException at(double time) {
        return inOneLine("pilot " + name() + " at " + time + " s: ");
    }

    /** The mistake in one line when there is no pilot yet: its class is that of whatever makes it. */
    InputException beforeTheRun() {
        return inOneLine("no pilot from " + name() + ": ");
    }

    private InputException inOneLine(String beginning) {
        String line = place().map(frame -> ", at " + frame).orElse("");
        return new InputException(beginning + PlainText.value(problem) + line, problem);
    }

    /** A lambda has the name of the class that it is written in. */
    private String name() {
        return pilot.getName().replaceFirst("\\$\\$Lambda.*", "");
    }

    /** The innermost call that is neither Java's nor the library's; what a user wrote may be called by either. */
    private Optional<StackTraceElement> place() {
        return first(frame -> frame.getModuleName() == null && !isLibrary(frame.getClassName()))
                .or(() -> first(frame -> frame.getClassName().equals(name())))
                .or(() -> first(frame -> true));
    }

    private Optional<StackTraceElement> first(Predicate<StackTraceElement> condition) {
        return Stream.of(problem.getStackTrace()).filter(condition).findFirst();
    }

    private boolean isLibrary(String type) {
        try {
            CodeSource source = source(Class.forName(type, false, pilot.getClassLoader()));
            return Objects.equals(source, source(PilotFault.class))
                    || Objects.equals(source, source(DevsSimulator.class));
        } catch (ClassNotFoundException | LinkageError e) {
            return false;
        }
    }

    private static CodeSource source(Class<?> type) {
        return type.getProtectionDomain().getCodeSource();
    }
}
