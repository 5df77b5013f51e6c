package org.dronewatch.app;

import java.io.PrintWriter;
import java.nio.charset.Charset;
import java.util.Arrays;
import java.util.Set;
import org.dronewatch.setting.InputException;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** The entry point of the command line. */
@Command(
        name = "dronewatch",
        version = "dronewatch 0.1.0",
        mixinStandardHelpOptions = true,
        description = "Simulates how a set of sensors sees and hears drones in a site's own 3D model.",
        subcommands = {
            ListCommand.class,
            RunCommand.class,
            ViewCommand.class,
            CheckCommand.class,
            RenderCommand.class,
            CoverageCommand.class,
            BenchCommand.class,
            CostsCommand.class,
            ModelsCommand.class
        },
        footer = {"", "Example: dronewatch run camera-range --out results"})
public final class Main implements Runnable {
    /** Exit code of wrong usage and bad input. */
    static final int BAD_INPUT = 2;
    /** Exit code of a command that needs a display where there is none. */
    static final int NO_DISPLAY = 3;
    /** Exit code of anything else that went wrong. */
    static final int FAILED = 1;

    private static final String HEADLESS = "java.awt.headless";

    /** The words with which a window is asked for. */
    private static final Set<String> WINDOWED = Set.of("view", "--view");

    @Spec
    private CommandSpec spec;

    /** Runs a command and ends the process with its exit code unless that is 0. */
    public static void main(String[] arguments) {
        if (Arrays.stream(arguments).noneMatch(WINDOWED::contains) && System.getProperty(HEADLESS) == null) {
            // Pictures and plots need no display; one that cannot be reached must not stop them.
            System.setProperty(HEADLESS, "true");
        }
        // The console's own character set, so that names and paths come out as they were typed.
        PrintWriter out = new PrintWriter(System.out, true, Charset.defaultCharset());
        PrintWriter err = new PrintWriter(System.err, true, Charset.defaultCharset());
        int code = execute(out, err, arguments);
        if (code != 0) {
            System.exit(code);
        }
    }

    /**
     * Runs a command.
     *
     * @param out where results go
     * @param err where messages go
     * @return 0 done, 2 wrong usage or bad input, 3 no display, 1 anything else
     */
    public static int execute(PrintWriter out, PrintWriter err, String... arguments) {
        Logging.silence();
        CommandLine commands = new CommandLine(new Main());
        commands.setOut(out);
        commands.setErr(err);
        commands.setCaseInsensitiveEnumValuesAllowed(true);
        commands.setParameterExceptionHandler((problem, given) -> {
            err.println(told(problem) + " (see '"
                    + problem.getCommandLine().getCommandSpec().qualifiedName() + " --help')");
            return BAD_INPUT;
        });
        commands.setExecutionExceptionHandler((problem, command, given) -> {
            err.println(told(problem));
            return problem instanceof InputException ? BAD_INPUT : FAILED;
        });
        return commands.execute(arguments);
    }

    /** One line, but for input with several mistakes: a line for each. */
    private static String told(Exception problem) {
        if (problem instanceof InputException) {
            return problem.getMessage();
        }
        if (problem instanceof ParameterException) {
            return problem.getMessage().replaceAll("\\p{Cntrl}+", " ");
        }
        StackTraceElement[] trace = problem.getStackTrace();
        String place = trace.length == 0 ? "" : " at " + trace[0];
        return "internal error: " + problem.toString().replaceAll("\\p{Cntrl}+", " ") + place;
    }

    /** Without a subcommand: says what there is. */
    @Override
    public void run() {
        throw new ParameterException(
                spec.commandLine(),
                "Missing command: one of "
                        + String.join(", ", spec.subcommands().keySet()));
    }
}
