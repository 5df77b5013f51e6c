package org.dronewatch.app;

import java.io.PrintWriter;
import java.nio.charset.Charset;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import javax.imageio.ImageIO;
import org.dronewatch.app.console.ExitCode;
import org.dronewatch.app.console.Interruption;
import org.dronewatch.app.console.LoadingBars;
import org.dronewatch.app.console.PlainPrinter;
import org.dronewatch.app.console.QuietSwitch;
import org.dronewatch.app.option.StoreSwitch;
import org.dronewatch.campaign.CampaignCluster;
import org.dronewatch.mesh.io.MeshReaders;
import org.dronewatch.parallel.LongTask;
import org.dronewatch.run.store.StorePlace;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.KindRegistry;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.Spec;

/** The entry point of the command line. */
@Command(
        name = "dronewatch",
        versionProvider = VersionText.class,
        mixinStandardHelpOptions = true,
        description = "Simulates how a set of sensors sees and hears drones in a 3D model of a real site.",
        footer = {"", "Example:", "  dronewatch run camera-range --out results"})
public final class Main implements Runnable, QuietSwitch, StoreSwitch {
    private static final String HEADLESS = "java.awt.headless";

    /** The words that request a window. */
    private static final Set<String> WINDOWED = Set.of("view", "--view");

    @Option(
            names = {"-q", "--quiet"},
            scope = ScopeType.INHERIT,
            description = "Prints results, warnings and errors only: no progress, and no notes on what is read.")
    private boolean quiet;

    @Option(
            names = {"-v", "--verbose"},
            scope = ScopeType.INHERIT,
            description = "Adds the stack trace to the error message.")
    private boolean verbose;

    @Option(
            names = "--no-cache",
            scope = ScopeType.INHERIT,
            description = "Neither uses nor fills the cache of prepared sites and assessments.")
    private boolean withoutStore;

    @Spec
    private CommandSpec spec;

    private final CampaignCluster cluster;

    private Interruption interruption;

    /** Campaigns run in this process. */
    Main() {
        this(CampaignCluster.NONE);
    }

    private Main(CampaignCluster cluster) {
        this.cluster = cluster;
    }

    /** Runs a command and ends the process with its exit code unless that is 0. */
    public static void main(String[] arguments) {
        main(CampaignCluster.NONE, arguments);
    }

    /**
     * Runs a command like {@link #main(String[])}, in a process that runs the cases of campaigns on other machines.
     *
     * @param cluster runs the cases of {@code campaign}; it is closed at the end
     */
    public static void main(CampaignCluster cluster, String... arguments) {
        if (Arrays.stream(arguments).noneMatch(WINDOWED::contains) && System.getProperty(HEADLESS) == null) {
            // Pictures and plots need no display; one that cannot be reached must not stop them.
            System.setProperty(HEADLESS, "true");
        }
        // The console's own character set, so that names and paths come out as they were typed.
        PrintWriter out = new PrintWriter(System.out, true, Charset.defaultCharset());
        PrintWriter err = new PrintWriter(System.err, true, Charset.defaultCharset());
        int code;
        try (cluster) {
            code = execute(out, err, cluster, arguments);
        }
        if (out.checkError()) {
            err.println("standard output could not be written completely");
            code = code == 0 ? ExitCode.BAD_INPUT : code;
        }
        // During a shutdown, this would end the process with this code as soon as the hooks have run.
        if (code != 0 && !Interruption.isUnderWay()) {
            System.exit(code);
        }
    }

    /**
     * Runs a command. Java errors, such as running out of memory, also end in a one-line message and an exit code.
     *
     * @param out destination of results
     * @param err destination of messages
     * @return 0 done, 2 invalid usage or input, 3 no display, 1 anything else
     */
    public static int execute(PrintWriter out, PrintWriter err, String... arguments) {
        return execute(out, err, CampaignCluster.NONE, arguments);
    }

    private static int execute(PrintWriter out, PrintWriter err, CampaignCluster cluster, String... arguments) {
        // Finding the libraries that keep the log and write images takes as long as finding the command.
        CompletableFuture<Void> ready = CompletableFuture.runAsync(Main::prepareLibraries);
        Main main = new Main(cluster);
        PrintWriter plainErr = new PlainPrinter(err);
        CommandLine commands = Commands.program(main, List.of(arguments));
        commands.setOut(out);
        commands.setErr(plainErr);
        commands.setCaseInsensitiveEnumValuesAllowed(true);
        CommandHelp.complete(commands);
        commands.setParameterExceptionHandler((problem, given) -> {
            plainErr.println(WrongUsage.message(problem));
            return ExitCode.BAD_INPUT;
        });
        commands.setExecutionExceptionHandler((problem, command, given) -> main.failed(problem, plainErr));
        commands.setExecutionStrategy(parsed -> main.executeParsed(commands, parsed, ready));
        // Closed only once the last message is out: until then, and no longer, the end of the process waits.
        try (Interruption watch = new Interruption()) {
            main.interruption = watch;
            int code = main.executed(commands, plainErr, arguments);
            out.flush();
            plainErr.flush();
            return code;
        } finally {
            LongTask.watch(null);
        }
    }

    private static void prepareLibraries() {
        Logging.silence();
        // Files for unfinished images would need room in the temporary directory, and a hook at shutdown.
        ImageIO.setUseCache(false);
    }

    private int executed(CommandLine commands, PrintWriter err, String... arguments) {
        try {
            return commands.execute(arguments);
        } catch (Error e) {
            return failed(e, err);
        }
    }

    /** Help may be in colour; all else is plain. */
    private int executeParsed(CommandLine commands, ParseResult parsed, CompletableFuture<Void> ready) {
        Integer help = CommandLine.executeHelpRequest(parsed);
        if (help != null) {
            return help;
        }
        ready.join();
        commands.setOut(new PlainPrinter(commands.getOut()));
        try {
            // Errors in the class path are reported before anything is done.
            KindRegistry.found();
            MeshReaders.found();
        } catch (InputException e) {
            return failed(e, commands.getErr());
        }
        if (!quiet) {
            LoadingBars.show();
        }
        return new CommandLine.RunLast().execute(parsed);
    }

    /** Informs the running command whether the user wants it to stop. */
    Interruption interruption() {
        return interruption;
    }

    @Override
    public boolean isQuiet() {
        return quiet;
    }

    @Override
    public StorePlace store() {
        return withoutStore ? StorePlace.NONE : StorePlace.ofProcess();
    }

    /** Runs the cases of campaigns. */
    CampaignCluster cluster() {
        return cluster;
    }

    private int failed(Throwable problem, PrintWriter err) {
        boolean stopped =
                problem instanceof CancellationException || interruption.happened() && !interruption.isOutOfTime();
        if (stopped && !(problem instanceof InputException)) {
            err.println("interrupted: nothing was written");
        } else {
            err.println(Failure.message(problem));
        }
        if (verbose) {
            Failure.printTrace(problem, err);
        }
        return problem instanceof InputException ? ExitCode.BAD_INPUT : ExitCode.FAILED;
    }

    /** Fails with a list of the commands, because none was given. */
    @Override
    public void run() {
        throw new ParameterException(
                spec.commandLine(),
                "Missing command: must be one of "
                        + String.join(", ", spec.subcommands().keySet()));
    }
}
