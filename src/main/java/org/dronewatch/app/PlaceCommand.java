package org.dronewatch.app;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.app.console.Interruption;
import org.dronewatch.app.console.ProgressOptions;
import org.dronewatch.app.console.TaskProgress;
import org.dronewatch.app.option.FieldOptions;
import org.dronewatch.app.option.GivenOption;
import org.dronewatch.app.option.JsonOption;
import org.dronewatch.app.option.PathWord;
import org.dronewatch.app.option.SeedOption;
import org.dronewatch.app.option.SetOption;
import org.dronewatch.app.option.StoreSwitch;
import org.dronewatch.app.option.ThreadsOption;
import org.dronewatch.app.search.PlaceFinder;
import org.dronewatch.app.search.PlaceTask;
import org.dronewatch.placement.SearchEnd;
import org.dronewatch.placement.SolverLimits;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.site.FrontSearch;
import org.dronewatch.report.placement.AttackedPlaceResults;
import org.dronewatch.report.placement.PlaceDirectory;
import org.dronewatch.report.placement.PlaceResults;
import org.dronewatch.report.placement.UnattackedPlaceResults;
import org.dronewatch.report.provenance.Provenance;
import org.dronewatch.scenario.InputFiles;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Quantity;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import picocli.CommandLine.Spec;

/** Finds the best layout of sensors for a budget. */
@Command(
        name = "place",
        mixinStandardHelpOptions = true,
        description =
                "Chooses, from the sensors that can be bought and the places where they can be installed, those that cover the"
                        + " most airspace within a budget, give the longest warning, or maximise a drone's exposure"
                        + " on its least exposed route; prints the layout, a bound on what any other could achieve, and the order in which to"
                        + " buy its sensors.",
        footer = {
            "",
            "Examples:",
            "  dronewatch place scenes/palace.place.yaml",
            "  dronewatch place scenes/palace.place.yaml --budget 100000 --out layout",
            "  dronewatch place scenes/palace.place.yaml --campaign scenes/two-radars.campaign.yaml --runs 200"
        })
final class PlaceCommand implements Callable<Integer> {
    private static final double DEFAULT_GAP = 0.001;
    private static final double DEAREST = 1e12;
    private static final double LEAST_TIME = 1e-3;
    private static final double MOST_TIME = 1e6;

    @Parameters(
            index = "0",
            paramLabel = "FILE.yaml",
            description = "Placement file: scene, candidates with their places and prices, budget, and conditions.")
    private String file;

    @Option(names = "--budget", paramLabel = "N", description = "Budget in place of the one in the file.")
    private String budget;

    @Option(
            names = "--cell",
            paramLabel = "LENGTH",
            description = "Length of a cell's side in place of the one in the file, with a unit or in m.")
    private String cell;

    @Option(
            names = "--gap",
            paramLabel = "G",
            description =
                    "Ends the search once no layout can exceed the value of the best so far by more than this fraction"
                            + " of it, 0 to 1; 0.001 by default; with 0, the search ends once the best is proven"
                            + " optimal.")
    private double gap = DEFAULT_GAP;

    @Option(
            names = "--time",
            paramLabel = "S",
            description = "Ends the search this long after the candidates have been assessed, with a unit or in s: the"
                    + " best layout so far is then stated with a bound. Flights, attacks and the coverage of the layout"
                    + " are left out where they are not complete 10 s later. With a limit, the result depends on the"
                    + " speed of the machine. No limit by default.")
    private String time;

    @Option(
            names = "--budgets",
            paramLabel = "N",
            description = "Maximum number of budgets for which the best layout is sought, the full one included, 1 to"
                    + " 12; 12 by default.")
    private int budgets = FrontSearch.MOST;

    @Mixin
    private PlaceAttacks attacks = new PlaceAttacks();

    @Mixin
    private SeedOption seed = new SeedOption();

    @Option(
            names = "--set",
            paramLabel = "PATH=VALUE",
            description = "Overrides a setting of the scene by its path, with a unit or without.")
    private List<String> overrides = new ArrayList<>();

    @Option(
            names = "--out",
            paramLabel = "DIR",
            description = "Directory for report.html, place.json, maps, and the layout as a scene, layout.yaml.")
    private String out;

    @Mixin
    private ThreadsOption threads = new ThreadsOption();

    @Mixin
    private ProgressOptions display = new ProgressOptions();

    @Mixin
    private JsonOption json = new JsonOption();

    @ParentCommand
    private Main main;

    @Spec
    private CommandSpec spec;

    private final Instant started = Instant.now();

    @Override
    public Integer call() {
        threads.number();
        SolverLimits limits = limits();
        Path given = PathWord.of("placement file", file);
        TaskProgress shown = display.on(spec.commandLine().getErr());
        PlacePlan read = PlacePlan.read(given, this::configure, shown.notes());
        PlacePlan fine =
                cell == null ? read : read.withCell((double) FieldOptions.value("cell", cell, FieldGrid.class, "cell"));
        PlacePlan plan = budget == null ? fine : fine.withBudget(budget());
        try (PlaceDirectory target = out == null ? null : new PlaceDirectory(PathWord.of("--out", out), given, plan)) {
            return threads.call(() -> {
                attacks.check(plan, seed.number());
                if (target != null) {
                    target.foresee(shown.notes());
                }
                PlaceResults results = attacks.flown(
                        results(given, plan, limits, shown),
                        seed.number(),
                        overrides,
                        limits,
                        main.interruption(),
                        shown);
                main.interruption().letFinish();
                Optional<String> layout = target == null
                        ? Optional.empty()
                        : target.write(results, provenance(given, plan), threads.number(), shown.notes());
                return printed(results, layout);
            });
        }
    }

    /**
     * Prints the results; returns the exit code: that of a failure if no attack could be flown.
     *
     * @param layout the file of the layout, as a command-line argument; empty if it was not written
     */
    private int printed(PlaceResults results, Optional<String> layout) {
        PrintWriter err = spec.commandLine().getErr();
        Optional<AttackedPlaceResults> attacked =
                results instanceof AttackedPlaceResults its ? Optional.of(its) : Optional.empty();
        json.print(results::toJson, target -> {
            results.lines().forEach(target::println);
            layout.map(attacked.map(AttackedPlaceResults::found).orElse(results)::reproduction)
                    .ifPresent(sentences -> sentences.forEach(target::println));
            attacked.ifPresent(its -> {
                target.println();
                CampaignLines.print(its.plan(), its.result(), target);
                layout.map(its::sentence).ifPresent(target::println);
            });
        });
        if (results.isInterrupted()) {
            err.println("interrupted: " + soFar(results));
        }
        return attacked.map(its -> CampaignLines.warn(its.result().summary(), err))
                .orElse(0);
    }

    private static String soFar(PlaceResults results) {
        if (results instanceof AttackedPlaceResults) {
            return "these are the results of the attacks that were complete";
        }
        return "this is the best layout so far"
                + (results instanceof UnattackedPlaceResults ? "; no attacks were flown" : "");
    }

    private PlaceResults results(Path given, PlacePlan plan, SolverLimits limits, TaskProgress shown) {
        try {
            PlaceTask task = PlaceTask.of(plan, limits, budgets, main.interruption(), shown);
            return PlaceFinder.of(plan.settings().objective()).find(task);
        } catch (InputException e) {
            throw PlacePlan.placed(given, e);
        } catch (CancellationException e) {
            throw main.interruption().isOutOfTime() ? tooLittleTime(limits, e) : e;
        }
    }

    private InputException tooLittleTime(SolverLimits limits, CancellationException cause) {
        main.interruption().letFinish();
        return new InputException(
                GivenOption.words("--time", time) + ": "
                        + Quantity.DURATION.inWords(limits.end().seconds() + SearchEnd.FOLLOW_UP)
                        + " after the candidates were assessed, no layout had been tested against the weakest routes"
                        + " past its sensors; more time is needed",
                cause);
    }

    private SolverLimits limits() {
        if (!(gap >= 0.0 && gap <= 1.0)) {
            throw new InputException("--gap " + gap + ": must be 0 to 1");
        }
        if (budget != null) {
            budget();
        }
        if (budgets < 1 || budgets > FrontSearch.MOST) {
            throw new InputException("--budgets " + budgets + ": must be 1 to " + FrontSearch.MOST);
        }
        Interruption interruption = main.interruption();
        return new SolverLimits(
                gap,
                time == null ? Double.POSITIVE_INFINITY : seconds(time),
                () -> interruption.happened() && !interruption.isOutOfTime());
    }

    private double budget() {
        double amount;
        try {
            amount = Quantity.NUMBER.parse(budget);
        } catch (IllegalArgumentException e) {
            throw new InputException(GivenOption.words("--budget", budget) + ": must be a number without a unit", e);
        }
        if (!(amount >= 0.0 && amount <= DEAREST)) {
            throw new InputException(GivenOption.words("--budget", budget) + ": must be 0 to 1e12");
        }
        return amount;
    }

    private static double seconds(String text) {
        double seconds;
        try {
            seconds = Quantity.DURATION.parse(text);
        } catch (IllegalArgumentException e) {
            throw new InputException(GivenOption.words("--time", text) + ": " + e.getMessage(), e);
        }
        if (!(seconds >= LEAST_TIME && seconds <= MOST_TIME)) {
            throw new InputException(GivenOption.words("--time", text) + ": must be 0.001 to 1,000,000 s");
        }
        return seconds;
    }

    private void configure(SceneRunner runner) {
        runner.store(StoreSwitch.of(spec));
        SetOption.parsed("--set", overrides).forEach(runner::set);
        seed.apply(runner);
    }

    /** The placement file and its conditions count among the files that describe the scene. */
    private Provenance provenance(Path given, PlacePlan plan) {
        InputFiles inputs = plan.runner().inputs();
        List<Path> files = new ArrayList<>(List.of(given));
        plan.conditionsFile().ifPresent(files::add);
        files.addAll(attacks.files());
        return new Provenance(
                started,
                spec.root().commandLine().getParseResult().originalArgs(),
                inputs.withScene(inputs.scene(), files));
    }
}
