package org.dronewatch.app;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.dronewatch.app.console.ExitCode;
import org.dronewatch.app.console.Interruption;
import org.dronewatch.app.console.Notes;
import org.dronewatch.app.console.Progress;
import org.dronewatch.app.option.JsonOption;
import org.dronewatch.app.option.LabelOptions;
import org.dronewatch.app.option.PathWord;
import org.dronewatch.app.option.SceneChoice;
import org.dronewatch.app.option.SeedOption;
import org.dronewatch.app.option.ThreadsOption;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.report.RayPaths;
import org.dronewatch.report.ResultFile;
import org.dronewatch.report.RunReport;
import org.dronewatch.report.file.WholeFile;
import org.dronewatch.report.labels.LabelPlan;
import org.dronewatch.run.AlertResult;
import org.dronewatch.run.PairResult;
import org.dronewatch.run.RunInfo;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.SceneListener;
import org.dronewatch.run.SceneResult;
import org.dronewatch.run.Stage;
import org.dronewatch.run.time.Pace;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scenario.SweptValue;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.setting.Counted;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.viewer.Viewer;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParentCommand;
import picocli.CommandLine.Spec;

/** Runs a scene and writes its results. */
@Command(
        name = "run",
        mixinStandardHelpOptions = true,
        description = "Runs a scene; prints the range at which each sensor first detects each drone, and writes"
                + " tables, plots and a report.",
        footer = {
            "",
            "Examples:",
            "  dronewatch run camera-range --set drones.quadrotor.speed=36km/h --out results",
            "  dronewatch run scenes/daylight.yaml --labels garden --labels west",
        })
final class RunCommand implements Callable<Integer> {
    @Mixin
    private SceneChoice choice;

    @Option(names = "--out", paramLabel = "DIR", description = "Directory for results; target/runs/SCENE by default.")
    private String out;

    @Mixin
    private SeedOption seed = new SeedOption();

    @Mixin
    private ThreadsOption threads = new ThreadsOption();

    @Option(
            names = "--real-time",
            paramLabel = "FACTOR",
            description = "Runs at this multiple of real time instead of as fast as possible.")
    private Double realTime;

    @Option(names = "--observations", description = "Writes every observation to observations.csv.")
    private boolean observations;

    @Option(
            names = "--rays",
            paramLabel = "FILE.obj",
            description =
                    "Writes the rays that the acoustic sensors trace at the start of the first run, as lines of an OBJ"
                            + " file.")
    private String rays;

    @Mixin
    private LabelOptions labels = new LabelOptions();

    @Option(names = "--view", description = "Opens a window to watch the run; the results are the same as without it.")
    private boolean view;

    @Mixin
    private JsonOption json = new JsonOption();

    @ParentCommand
    private Main main;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        Scene scene = choice.create();
        SceneRunner runner = choice.runner(scene);
        PrintWriter err = spec.commandLine().getErr();
        Consumer<String> notes = Notes.of(spec);
        runner.notes(notes);
        configure(runner);
        runner.settings();
        Path directory = directory(scene);
        Optional<String> obstacle = view ? Viewer.obstacle() : Optional.empty();
        if (obstacle.isPresent()) {
            err.println(SceneWindow.noWindow(obstacle.get()));
            return ExitCode.NO_DISPLAY;
        }
        if (rays != null) {
            runner.listener(rayWriter());
        }
        if (!view) {
            run(scene, runner, directory);
            return 0;
        }
        try (Viewer viewer = Viewer.open(scene, runner, threads.number())) {
            runner.listener(viewer.listener()).notes(line -> {
                notes.accept(line);
                viewer.note(line);
            });
            try {
                run(scene, runner, directory);
                viewer.finished(true);
            } catch (RuntimeException e) {
                if (viewer.isClosed()) {
                    throw e;
                }
                viewer.failed(e);
                viewer.awaitClosed();
                throw e;
            }
            viewer.awaitClosed();
        }
        return 0;
    }

    private void run(Scene scene, SceneRunner runner, Path directory) {
        Consumer<String> notes = Notes.of(spec);
        Interruption interruption = main.interruption();
        Optional<LabelPlan> plan = labels.plan(runner);
        plan.ifPresent(labelled -> notes.accept("labels: " + labelled.inWords()));
        try (RunReport report = new RunReport(scene, directory, observations);
                Progress progress = new Progress(scene.name())) {
            plan.ifPresent(report::label);
            runner.listener(report);
            if (!Notes.areOff(spec)) {
                runner.listener(progress);
            }
            SceneResult result = runner.cancelWhen(interruption::happened).run();
            interruption.letFinish();
            report.command(spec.root().commandLine().getParseResult().originalArgs());
            report.inputs(runner.inputs());
            report.finish(result);
            progress.finish();
            json.print(new ResultFile(result)::toJson, out -> {
                print(result, out);
                printAlerts(result, out);
                FalseAlarmLines.print(result, out);
            });
            if (!result.complete()) {
                spec.commandLine().getErr().println("interrupted: " + until(result));
            }
            notes.accept("results in " + directory);
        }
    }

    /** How much of the run the results cover if it was stopped early. */
    private static String until(SceneResult result) {
        RunResult last = result.runs().get(result.runs().size() - 1);
        String of = result.runs().size() == 1 ? "" : " of run " + last.run();
        return String.format(
                Locale.ROOT,
                "these are the results up to %.1f s of %.1f s%s",
                last.simulated(),
                last.settings().run().duration(),
                of);
    }

    /** Writes the rays at the start of the first run. */
    private SceneListener rayWriter() {
        WholeFile file = new WholeFile("--rays", rays);
        return new SceneListener() {
            @Override
            public void runStarted(RunInfo run, Stage stage) {
                if (run.run() == 0) {
                    writeRays(stage, file);
                }
            }
        };
    }

    private void writeRays(Stage stage, WholeFile file) {
        RayPaths paths = new RayPaths();
        stage.traceRays(0.0, paths::recorder);
        file.write(paths::writeTo);
        if (stage.tracesRays()) {
            Notes.of(spec).accept(Counted.of(paths.pieces(), "ray segment") + " written");
        } else {
            Notes.of(spec)
                    .accept(
                            "warning: --rays " + PlainText.value(rays)
                                    + ": the file contains no rays, since the scene has no drone, or no acoustic sensor that is switched on");
        }
    }

    private void configure(SceneRunner runner) {
        try {
            seed.apply(runner);
            runner.threads(threads.number());
        } catch (IllegalArgumentException e) {
            throw new InputException(e.getMessage(), e);
        }
        try {
            if (realTime != null) {
                runner.pace(Pace.realTime(realTime));
            }
        } catch (IllegalArgumentException e) {
            throw new InputException("--real-time: " + e.getMessage(), e);
        }
    }

    private Path directory(Scene scene) {
        return out == null ? Path.of("target", "runs", scene.name()) : PathWord.of("--out", out);
    }

    private static void print(SceneResult result, PrintWriter target) {
        String heading = result.runs().get(0).settings().sweep().isPresent() ? "swept value" : "";
        int width = result.pairs().stream()
                .mapToInt(pair -> sweptValue(result, pair).length())
                .reduce(Math.max(1, heading.length()), Math::max);
        String row = "%-4s %-" + width + "s %-16s %-16s %14s %10s%n";
        target.printf(row, "run", heading, "sensor", "drone", "first detected [s]", "range [m]");
        for (PairResult pair : result.pairs()) {
            target.printf(
                    row,
                    pair.run(),
                    sweptValue(result, pair),
                    pair.sensor(),
                    pair.drone(),
                    text(pair.firstDetected()),
                    text(pair.range()));
        }
        if (result.pairs().stream().anyMatch(PairResult::isUnknown)) {
            target.println(
                    "first detected over unknown ground (beyond the terrain or above a hole), where something may hide"
                            + " the drone: "
                            + result.pairs().stream()
                                    .filter(PairResult::isUnknown)
                                    .map(pair -> "run " + pair.run() + " " + pair.sensor() + " " + pair.drone())
                                    .collect(Collectors.joining(", ")));
        }
    }

    /** The swept setting with its value in the pair's run; empty where nothing is swept. */
    private static String sweptValue(SceneResult result, PairResult pair) {
        SceneSettings settings = result.runs().get(pair.run()).settings();
        return settings.sweep()
                .map(sweep -> new SweptValue(settings, sweep).text())
                .orElse("");
    }

    /** How early the alerts are, where the scene asks for more than the first detection. */
    private static void printAlerts(SceneResult result, PrintWriter target) {
        if (result.runs().get(0).settings().alert().equals(AlertSettings.DEFAULT)) {
            return;
        }
        target.printf(
                "%n%-4s %-16s %10s %12s %14s %8s  %s%n",
                "run", "drone", "alert [s]", "to zone [m]", "warning [s]", "in time", "raised by");
        for (AlertResult alert : result.alerts()) {
            target.printf(
                    "%-4d %-16s %10s %12s %14s %8s  %s%n",
                    alert.run(),
                    alert.drone(),
                    text(alert.time()),
                    alert.zoneDistance().isPresent() ? text(alert.zoneDistance()) : "-",
                    alert.warning().isPresent() ? text(alert.warning()) : "-",
                    alert.inTime().map(enough -> enough ? "yes" : "no").orElse("-"),
                    alert.sensors().isEmpty() ? "-" : String.join(", ", alert.sensors()));
        }
    }

    private static String text(OptionalDouble value) {
        return value.isPresent() ? String.format(Locale.ROOT, "%.2f", value.getAsDouble()) : "never";
    }
}
