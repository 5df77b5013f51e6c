package org.dronewatch.app;

import java.util.Map;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Prints what {@code --help} prints. */
@Command(
        name = "help",
        // Its output is help, which may be in colour.
        helpCommand = true,
        mixinStandardHelpOptions = true,
        description = "Prints the help of a command, as 'dronewatch COMMAND --help' does, or lists the commands.",
        footer = {"", "Examples:", "  dronewatch help", "  dronewatch help run"})
final class HelpCommand implements Callable<Integer> {
    @Parameters(
            arity = "0..1",
            paramLabel = "COMMAND",
            description = "Command whose help is printed; by default, the help of the program is printed.")
    private String command;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        CommandLine program = spec.parent().commandLine();
        Map<String, CommandLine> commands = program.getSubcommands();
        if (command != null && !commands.containsKey(command)) {
            throw new ParameterException(program, WrongUsage.unknownCommand(command, commands.keySet()));
        }
        CommandLine explained = command == null ? program : commands.get(command);
        explained.usage(spec.commandLine().getOut());
        return 0;
    }
}
