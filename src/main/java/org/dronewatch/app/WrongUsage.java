package org.dronewatch.app;

import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.Spelling;
import picocli.CommandLine;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.UnmatchedArgumentException;

/** The message for a command line that cannot be read, with what may have been meant. */
final class WrongUsage {
    private WrongUsage() {}

    /** One line. */
    static String message(ParameterException problem) {
        String said = problem instanceof UnmatchedArgumentException unmatched
                ? unmatched(unmatched)
                : PlainText.line(problem.getMessage()) + meantValue(problem);
        return said + " (see '" + problem.getCommandLine().getCommandSpec().qualifiedName() + " --help')";
    }

    /** What follows an unknown option is often its value: only the option is worth a word then. */
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
        return commands.isEmpty()
                ? PlainText.line(problem.getMessage())
                : "unknown command '" + PlainText.value(word) + "'" + Spelling.didYouMean(word, commands);
    }

    /** The value of an option that is one of a few words. */
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
