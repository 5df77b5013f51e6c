package org.dronewatch.app;

import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.dronewatch.app.console.Interruption;
import org.dronewatch.app.console.LoadingNotes;
import org.dronewatch.app.console.ProgressOptions;
import org.dronewatch.app.console.TaskProgress;
import org.dronewatch.app.option.JsonOption;
import org.dronewatch.app.option.PathWord;
import org.dronewatch.app.option.SceneChoice;
import org.dronewatch.app.option.StoreSwitch;
import org.dronewatch.app.option.ThreadsOption;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.campaign.CampaignResult;
import org.dronewatch.campaign.CampaignRun;
import org.dronewatch.campaign.CampaignScenes;
import org.dronewatch.campaign.CampaignSettings;
import org.dronewatch.campaign.CaseExecution;
import org.dronewatch.campaign.SummedCases;
import org.dronewatch.report.campaign.CampaignFile;
import org.dronewatch.report.campaign.CampaignFiles;
import org.dronewatch.run.store.StorePlace;
import org.dronewatch.setting.InputException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParentCommand;
import picocli.CommandLine.Spec;

/** Compares two layouts under the same attacks. */
@Command(
        name = "compare",
        mixinStandardHelpOptions = true,
        description =
                "Flies the same attacks against two scenes, or against a scene and the same scene with changes; prints"
                        + " how often the sensors of each detect the drone, how often the alert is in time, the"
                        + " difference with its 95 %% confidence interval, and the cases that decide it.",
        footer = {
            "",
            "Unless --vary states what varies, the attacks come from all bearings.",
            "",
            "Examples:",
            "  dronewatch compare scenes/palace.yaml --with sensors.north=spotterrf-c550ext",
            "  dronewatch compare scenes/palace.yaml --with sensors.east.enabled=false --runs 200 --out without-east",
            "  dronewatch compare scenes/palace.yaml --with sensors.east.enabled=false --case 7 --view",
            "  dronewatch compare scenes/palace.yaml scenes/monaco.yaml --vary scenes/two-radars.campaign.yaml"
        })
final class CompareCommand implements Callable<Integer> {
    private static final String NAME = "compare";

    @Mixin
    private ComparedScenes scenes = new ComparedScenes();

    @Option(
            names = "--out",
            paramLabel = "DIR",
            description = "New directory for all results, in the same files as those of a campaign.")
    private String out;

    @Option(
            names = "--resume",
            description = "Completes the results that an interrupted run of the same comparison left in the directory"
                    + " given by --out.")
    private boolean resume;

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
        if (resume && out == null) {
            throw new InputException("--resume: needs --out DIR, the directory to be completed");
        }
        boolean isSingle = single.isAsked();
        TaskProgress shown = display.on(spec.commandLine().getErr());
        StorePlace store = StoreSwitch.of(spec);
        CampaignSettings settings = scenes.settings(store);
        settings.vary().forEach((path, variation) -> shown.notes().accept("varies: " + path));
        if (settings.vary().isEmpty() && settings.table().isEmpty()) {
            shown.notes()
                    .accept(
                            "no attack has a bearing that could vary, so only the random numbers vary; use --vary FILE to"
                                    + " vary settings");
        }
        return threads.call(() -> {
            LoadingNotes loading = new LoadingNotes(shown.notes());
            CampaignScenes named = CampaignScenes.of(SceneChoice::named).withStore(store);
            CampaignPlan plan = new CampaignPlan(settings, directory(), named, loading::note);
            loading.done();
            return isSingle ? single.run(plan, threads.number(), json, shown) : run(plan, shown);
        });
    }

    /** The directory of the file that states what varies; a table is beside it. */
    private Path directory() {
        return scenes.file()
                .orElse(Path.of("compare.yaml"))
                .toAbsolutePath()
                .normalize()
                .getParent();
    }

    private int run(CampaignPlan plan, TaskProgress shown) {
        CampaignResult result =
                out == null ? inMemory(plan, shown) : inDirectory(plan, PathWord.of("--out", out), shown);
        json.print(new CampaignFile(plan, result)::toJson, target -> {
            CampaignLines.print(plan, result, target);
            CampaignLines.printDeciding(plan, result.summary(), target);
        });
        return CampaignLines.warn(result.summary(), spec.commandLine().getErr());
    }

    private CampaignResult inMemory(CampaignPlan plan, TaskProgress shown) {
        SummedCases kept = new SummedCases(plan);
        if (!run(plan, kept, shown)) {
            spec.commandLine()
                    .getErr()
                    .println("interrupted: these are the results of the cases that were complete; had --out DIR"
                            + " been given, --resume could complete the comparison");
        }
        return kept.result();
    }

    private CampaignResult inDirectory(CampaignPlan plan, Path directory, TaskProgress shown) {
        try (CampaignFiles files = new CampaignFiles(plan, directory, resume)) {
            files.writeProvenance(CampaignOrigin.of(
                    plan,
                    scenes.file(),
                    spec.root().commandLine().getParseResult().originalArgs(),
                    threads.number()));
            boolean whole = run(plan, files.chunks(), shown);
            CampaignResult result = files.finish(Optional.of(scenes.caseCommand()));
            if (!whole) {
                spec.commandLine().getErr().println("interrupted: --resume runs the cases that are missing");
            }
            shown.notes().accept("results in " + directory);
            return result;
        }
    }

    /** Returns whether all cases were run. */
    private boolean run(CampaignPlan plan, CampaignRun.Chunks kept, TaskProgress shown) {
        Interruption interruption = main.interruption();
        boolean whole = new CaseRuns(interruption, shown, CaseExecution.HERE).run(new CampaignRun(plan), kept, NAME);
        interruption.letFinish();
        return whole;
    }
}
