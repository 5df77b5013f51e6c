package org.dronewatch.app;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import org.dronewatch.app.console.Interruption;
import org.dronewatch.app.console.LoadingNotes;
import org.dronewatch.app.console.ProgressOptions;
import org.dronewatch.app.console.TaskProgress;
import org.dronewatch.app.option.JsonOption;
import org.dronewatch.app.option.PathWord;
import org.dronewatch.app.option.SetOption;
import org.dronewatch.app.option.StoreSwitch;
import org.dronewatch.app.option.ThreadsOption;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.campaign.CampaignReader;
import org.dronewatch.campaign.CampaignResult;
import org.dronewatch.campaign.CampaignRun;
import org.dronewatch.campaign.CampaignScenes;
import org.dronewatch.campaign.CampaignSettings;
import org.dronewatch.campaign.SensitivityCases;
import org.dronewatch.campaign.outcome.Shard;
import org.dronewatch.report.campaign.CampaignFile;
import org.dronewatch.report.campaign.CampaignFiles;
import org.dronewatch.report.file.ShellWord;
import org.dronewatch.report.file.WholeFile;
import org.dronewatch.run.store.StorePlace;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.SettingsPath;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import picocli.CommandLine.Spec;
import tools.jackson.databind.node.ObjectNode;

/** Runs a scene many times with values drawn at random. */
@Command(
        name = "campaign",
        mixinStandardHelpOptions = true,
        description =
                "Runs a scene many times with settings that vary at random, every variant in the same cases; prints and"
                        + " writes how often the drone is detected and how often an alert comes in time, with 95 %%"
                        + " confidence intervals, and compares the variants case by case.",
        footer = {
            "",
            "Examples:",
            "  dronewatch campaign scenes/two-radars.campaign.yaml --out vendors",
            "  dronewatch campaign scenes/two-radars.campaign.yaml --out vendors --resume",
            "  dronewatch campaign scenes/two-radars.campaign.yaml --case 10 --view --variant spotter",
            "  dronewatch campaign scenes/two-radars.campaign.yaml --shard 1/4 --out part-1"
        })
final class CampaignCommand implements Callable<Integer> {
    @Parameters(index = "0", paramLabel = "FILE.yaml", description = "Campaign file: what is run, and what varies.")
    private String file;

    @Option(names = "--runs", paramLabel = "N", description = "Number of cases, in place of the one in the file.")
    private Integer runs;

    @Option(
            names = "--seed",
            paramLabel = "N",
            description = "Seed of all random numbers, in place of the one in the file.")
    private Long seed;

    @Option(
            names = "--set",
            paramLabel = "PATH=VALUE",
            description = "Overrides a setting in every variant that does not set it itself.")
    private List<String> overrides = new ArrayList<>();

    @Option(
            names = "--out",
            paramLabel = "DIR",
            description = "New directory for results; target/campaigns/NAME by default.")
    private String out;

    @Option(
            names = "--resume",
            description = "Completes the results that an interrupted run of the same campaign left in the directory.")
    private boolean resume;

    @Option(
            names = "--shard",
            paramLabel = "I/N",
            description = "Runs the I-th of N parts of the cases; 'merge' joins the parts.")
    private String shard;

    @Option(
            names = "--junit",
            paramLabel = "FILE.xml",
            description = "Also writes expectations and cases as test results in JUnit's XML format, for CI servers.")
    private String junit;

    @Mixin
    private CaseOptions single = new CaseOptions();

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

    @Override
    public Integer call() {
        Path given = PathWord.of("campaign file", file);
        Shard part = shard();
        boolean isSingle = single.isAsked();
        TaskProgress shown = display.on(spec.commandLine().getErr());
        return threads.call(() -> {
            CampaignPlan plan = plan(StoreSwitch.of(spec), shown.notes());
            if (!part.isAll() && plan.settings().until().isPresent()) {
                throw new InputException("--shard " + part
                        + ": a campaign with 'until' cannot be divided, because the results of the"
                        + " cases determine how many are run");
            }
            return isSingle ? runOne(plan, shown) : runAll(plan, part, name(given), shown);
        });
    }

    private Shard shard() {
        try {
            return shard == null ? Shard.ALL : Shard.parse(shard);
        } catch (IllegalArgumentException e) {
            throw new InputException("--shard " + PlainText.value(shard) + ": " + e.getMessage(), e);
        }
    }

    /**
     * Reads the campaign and loads its models.
     *
     * @param store where prepared sites are kept
     */
    CampaignPlan plan(StorePlace store, Consumer<String> notes) {
        Path given = PathWord.of("campaign file", file);
        LoadingNotes loaded = new LoadingNotes(notes);
        CampaignSettings settings = settings(given);
        try {
            CampaignScenes scenes = CampaignScenes.beside(directory(given)).withStore(store);
            CampaignPlan plan = new CampaignPlan(settings, directory(given), scenes, loaded::note);
            loaded.done();
            return plan;
        } catch (InputException e) {
            throw CampaignReader.placed(given, e);
        }
    }

    private static Path directory(Path given) {
        return given.toAbsolutePath().normalize().getParent();
    }

    /**
     * The origin of the results.
     *
     * @param command the arguments of the command line that produces them
     */
    ObjectNode provenance(CampaignPlan plan, List<String> command) {
        return CampaignOrigin.of(plan, Optional.of(PathWord.of("campaign file", file)), command, threads.number());
    }

    private CampaignSettings settings(Path given) {
        CampaignSettings settings = CampaignReader.read(given);
        if (!overrides.isEmpty()) {
            settings = settings.withCommon(SetOption.parsed("--set", overrides));
        }
        try {
            settings = seed == null ? settings : new SettingsPath("seed").write(settings, Long.toString(seed));
            return runs == null ? settings : new SettingsPath("runs").write(settings, Integer.toString(runs));
        } catch (InputException e) {
            throw new InputException("--" + e.getMessage(), e);
        }
    }

    /** The command that runs a case of this campaign again, without {@code --case} and its number. */
    String caseCommand() {
        StringBuilder words = new StringBuilder("dronewatch campaign ").append(ShellWord.of(file));
        overrides.forEach(one -> words.append(" --set ").append(ShellWord.of(one)));
        return words + (runs == null ? "" : " --runs " + runs) + (seed == null ? "" : " --seed " + seed);
    }

    private static String name(Path given) {
        return String.valueOf(given.getFileName()).replaceFirst("(?i)(\\.campaign)?\\.ya?ml$", "");
    }

    private int runOne(CampaignPlan plan, TaskProgress shown) {
        return single.run(plan, threads.number(), json, shown);
    }

    private int runAll(CampaignPlan plan, Shard part, String name, TaskProgress shown) {
        PrintWriter err = spec.commandLine().getErr();
        Path directory = out == null ? Path.of("target", "campaigns", name) : PathWord.of("--out", out);
        WholeFile report = junit == null ? null : new WholeFile("--junit", junit);
        int code;
        Interruption interruption = main.interruption();
        plan.sensitivity().ifPresent(cases -> shown.notes().accept(CampaignLines.cost(plan, cases)));
        try (CampaignFiles files = new CampaignFiles(plan, directory, resume)) {
            files.writeProvenance(
                    provenance(plan, spec.root().commandLine().getParseResult().originalArgs()));
            CaseRuns runner =
                    new CaseRuns(interruption, shown, main.cluster().forCampaign(PathWord.of("campaign file", file)));
            boolean whole = runner.run(new CampaignRun(plan, plan, part), files.chunks(), name);
            if (whole && plan.sensitivity().isPresent()) {
                SensitivityCases further = plan.sensitivity().get();
                whole = runner.run(new CampaignRun(plan, further, part), files.chunks(further), name + ": sensitivity");
            }
            interruption.letFinish();
            CampaignResult result = files.finish(Optional.of(caseCommand()));
            json.print(new CampaignFile(plan, result)::toJson, target -> CampaignLines.print(plan, result, target));
            int failure = CampaignLines.warn(result.summary(), err);
            if (report != null) {
                report.write(stream -> files.writeJunit(result, stream));
            }
            code = whole && part.isAll() ? Math.max(failure, CampaignLines.judge(plan, result.summary(), err)) : 0;
            if (!whole) {
                err.println("interrupted: --resume runs the cases that are missing");
            }
            if (!part.isAll()) {
                shown.notes().accept("part " + part + " of the campaign: 'merge' joins the parts");
            }
            shown.notes().accept("results in " + directory);
        }
        return code;
    }
}
