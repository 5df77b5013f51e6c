package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

/** Only the command that is given is made, unless others are needed, and it is the same as among all others. */
class CommandsTest {
    static Set<String> all() {
        return Program.commands().getSubcommands().keySet();
    }

    private static CommandLine program(String words) {
        return Commands.program(new Main(), List.of(words.split(" ")));
    }

    @ParameterizedTest
    @MethodSource("all")
    void aCommandIsKnownByItsOwnName(String name) {
        CommandLine command = Program.commands().getSubcommands().get(name);
        assertThat(command.getCommandSpec().userObject().getClass().getAnnotation(CommandLine.Command.class))
                .extracting(CommandLine.Command::name)
                .isEqualTo(name);
    }

    @ParameterizedTest
    @MethodSource("all")
    void aloneItHasTheSameHelp(String name) {
        CommandLine whole = Program.commands();
        CommandLine alone = program(name);
        CommandHelp.complete(whole);
        CommandHelp.complete(alone);
        assertThat(alone.getSubcommands().get(name).getUsageMessage())
                .contains("--no-cache")
                .isEqualTo(whole.getSubcommands().get(name).getUsageMessage());
    }

    @ParameterizedTest
    @CsvSource({"run birds, run", "-q run birds --out view, run", "--no-cache --verbose check help, check"})
    void onlyTheGivenOneIsMade(String words, String name) {
        assertThat(program(words).getSubcommands()).containsOnlyKeys(name);
    }

    /** They are listed, a mistyped one is compared with them, or a file may name one. */
    @ParameterizedTest
    @ValueSource(strings = {"-h", "--version", "help run", "completion", "rum birds", "@words", "@words run", "-- run"})
    void whereAnyMayBeNeededAllAreMade(String words) {
        assertThat(program(words).getSubcommands().keySet()).isEqualTo(all());
    }

    @Test
    void withoutAWordAllAreMade() {
        assertThat(Commands.program(new Main(), List.of()).getSubcommands().keySet())
                .isEqualTo(all());
    }
}
