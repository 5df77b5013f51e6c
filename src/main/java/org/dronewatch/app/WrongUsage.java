package org.dronewatch.app;

import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.Spelling;
import picocli.CommandLine;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.TypeConversionException;
import picocli.CommandLine.UnmatchedArgumentException;

/** The message for a command line that cannot be read, with what may have been meant. */
final class WrongUsage {
    private static final String WHOLE = "a whole number";

    private WrongUsage() {}

    /** The message, in one line. */
    static String message(ParameterException problem) {
        String said = problem instanceof UnmatchedArgumentException unmatched
                ? unmatched(unmatched)
                : notANumber(problem).orElseGet(() -> PlainText.line(problem.getMessage()) + meantValue(problem));
        return said + " (see '" + problem.getCommandLine().getCommandSpec().qualifiedName() + " --help')";
    }

    /**
     * States what was not recognised. What follows an unknown option is often its value, so that only the option is
     * mentioned.
     */
    private static String unmatched(UnmatchedArgumentException problem) {
        CommandLine command = problem.getCommandLine();
        Optional<String> option = problem.getUnmatched().stream()
                .filter(word -> word.startsWith("-"))
                .findFirst();
        if (option.isPresent()) {
            String name = option.get().replaceFirst("=.*", "");
            Collection<String> options = command.getCommandSpec().optionsMap().keySet();
            return "unknown option '" + PlainText.value(name) + "'" + Spelling.didYouMean(name, options);
        }
        String word = problem.getUnmatched().get(0);
        Collection<String> commands = command.getSubcommands().keySet();
        return commands.isEmpty() ? PlainText.line(problem.getMessage()) : unknownCommand(word, commands);
    }

    /** That a word is none of the commands, with the one that was probably meant. */
    static String unknownCommand(String word, Collection<String> commands) {
        return "unknown command '" + PlainText.value(word) + "'" + Spelling.didYouMean(word, commands);
    }

    /** Where a number is needed, and something else was given, the option, its value and what it must be. */
    private static Optional<String> notANumber(ParameterException problem) {
        ArgSpec option = problem.getArgSpec();
        if (!(problem.getCause() instanceof TypeConversionException) || option == null || problem.getValue() == null) {
            return Optional.empty();
        }
        String value = PlainText.value(problem.getValue());
        String name = option instanceof OptionSpec named ? named.longestName() : option.paramLabel();
        return needed(option.type(), value).map(needed -> (name + " " + value).strip() + ": must be " + needed);
    }

    private static Optional<String> needed(Class<?> type, String value) {
        boolean isTooLarge = value.matches("[-+]?[0-9]+");
        if (type == int.class || type == Integer.class) {
            return Optional.of(isTooLarge ? Integer.MIN_VALUE + " to " + Integer.MAX_VALUE : WHOLE);
        }
        if (type == long.class || type == Long.class) {
            return Optional.of(isTooLarge ? Long.MIN_VALUE + " to " + Long.MAX_VALUE : WHOLE);
        }
        return type == double.class || type == Double.class ? Optional.of("a number") : Optional.empty();
    }

    /** Suggests the value that was probably meant, for an option that takes one of a few words. */
    private static String meantValue(ParameterException problem) {
        if (problem.getArgSpec() == null || !problem.getArgSpec().type().isEnum()) {
            return "";
        }
        List<String> words = Arrays.stream(problem.getArgSpec().type().getEnumConstants())
                .map(word -> word.toString().toLowerCase(Locale.ROOT))
                .toList();
        return problem.getValue() == null ? "" : Spelling.didYouMean(problem.getValue(), words);
    }
}
