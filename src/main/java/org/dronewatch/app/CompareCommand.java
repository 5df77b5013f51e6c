package org.dronewatch.app;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.campaign.CampaignReader;
import org.dronewatch.campaign.CampaignResult;
import org.dronewatch.campaign.CampaignRun;
import org.dronewatch.campaign.CampaignSettings;
import org.dronewatch.campaign.KeptCases;
import org.dronewatch.campaign.Uniform;
import org.dronewatch.campaign.Variation;
import org.dronewatch.report.campaign.CampaignFiles;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneRunner;
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

/** Compares two layouts by the same attacks. */
@Command(
        name = "compare",
        mixinStandardHelpOptions = true,
        description =
                "Flies the same attacks against two scenes, or against a scene and the same scene with changes; prints"
                        + " how often each detects the drone and alerts in time, the difference with its 95 %%"
                        + " confidence interval, and the cases that decide it.",
        footer = {
            "",
            "Unless --vary states what varies, the attacks come from all bearings.",
            "",
            "Examples:",
            "  dronewatch compare scenes/palace.yaml --with sensors.north=spotterrf-c550ext",
            "  dronewatch compare scenes/palace.yaml --with sensors.east.enabled=false --runs 200",
            "  dronewatch compare scenes/palace.yaml scenes/monaco.yaml --vary scenes/two-radars.campaign.yaml"
        })
final class CompareCommand implements Callable<Integer> {
    @Parameters(index = "0", paramLabel = "A", description = "A packaged scene, a scene file, or a class.")
    private String first;

    @Parameters(
            index = "1",
            arity = "0..1",
            paramLabel = "B",
            description = "The scene to compare it with; without it, scene A with the changes of --with.")
    private String second;

    @Option(
            names = "--with",
            paramLabel = "PATH=VALUE",
            description = "What is different in the second scene, as for --set.")
    private List<String> changes = new ArrayList<>();

    @Option(
            names = "--vary",
            paramLabel = "FILE.yaml",
            description = "Campaign file that states what varies (vary, table), runs and seed.")
    private String vary;

    @Option(names = "--runs", paramLabel = "N", description = "Number of cases; 1,000 by default.")
    private Integer runs;

    @Option(names = "--seed", paramLabel = "N", description = "Seed of all random numbers.")
    private Long seed;

    @Option(
            names = "--out",
            paramLabel = "DIR",
            description = "New directory for all results, in the files of a campaign.")
    private String out;

    @Mixin
    private ThreadsOption threads = new ThreadsOption();

    @ParentCommand
    private Main main;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        if (second == null && changes.isEmpty()) {
            throw new InputException(
                    "compare needs a second scene, or --with PATH=VALUE for what is different in the second one");
        }
        PrintWriter err = spec.commandLine().getErr();
        Path file = vary == null ? Path.of("compare.yaml") : PathWord.of("--vary", vary);
        CampaignSettings settings = settings(file);
        settings.vary().forEach((path, variation) -> err.println("varies: " + path));
        if (settings.vary().isEmpty() && settings.table().isEmpty()) {
            err.println("no attack has a bearing that could vary, so only chance varies; name other settings that"
                    + " vary with --vary FILE");
        }
        Path directory = file.toAbsolutePath().normalize().getParent();
        return threads.call(() -> {
            LoadingNotes loading = new LoadingNotes(err);
            CampaignPlan plan = new CampaignPlan(settings, directory, SceneChoice::named, loading::note);
            loading.done();
            return run(plan);
        });
    }

    private CampaignSettings settings(Path file) {
        CampaignSettings settings = vary == null
                ? CampaignSettings.of(first).withVary(allBearings())
                : CampaignReader.read(file).withScene(first);
        Map<String, String> other = new LinkedHashMap<>();
        if (second != null) {
            other.put(CampaignSettings.SCENE, second);
        }
        for (String change : changes) {
            int equals = change.indexOf('=');
            if (equals < 1) {
                throw new InputException("--with " + PlainText.value(change) + ": must be PATH=VALUE");
            }
            other.put(
                    change.substring(0, equals).strip(),
                    change.substring(equals + 1).strip());
        }
        Map<String, Map<String, String>> variants = new LinkedHashMap<>();
        variants.put(name(first, ""), Map.of());
        String name = name(second == null ? first : second, "");
        variants.put(variants.containsKey(name) ? name(name, "-changed") : name, other);
        try {
            settings = settings.withVariants(variants);
            settings = runs == null ? settings : new SettingsPath("runs").write(settings, Integer.toString(runs));
            return seed == null ? settings : new SettingsPath("seed").write(settings, Long.toString(seed));
        } catch (IllegalArgumentException e) {
            throw new InputException(e.getMessage(), e);
        } catch (InputException e) {
            throw new InputException("--" + e.getMessage(), e);
        }
    }

    /** All bearings are equally likely for every drone, birds apart, whose flight has one. */
    private Map<String, Variation> allBearings() {
        SceneSettings scene = new SceneRunner(SceneChoice.named(first)).settings();
        Variation any = Variation.of(new Uniform("0 deg", "360 deg"));
        Map<String, Variation> vary = new LinkedHashMap<>();
        for (String drone : scene.drones().keySet()) {
            String path = "drones." + drone + ".flight.bearing";
            if (!scene.birds().contains(drone) && isThere(scene, path)) {
                vary.put(path, any);
            }
        }
        return vary;
    }

    private static boolean isThere(SceneSettings scene, String path) {
        try {
            new SettingsPath(path).read(scene);
            return true;
        } catch (InputException e) {
            // A flight of another kind, which has no bearing.
            return false;
        }
    }

    private static String name(String scene, String suffix) {
        String plain = scene.replaceFirst("(?i)\\.ya?ml$", "")
                .replaceFirst(".*[/\\\\]", "")
                .replaceAll("[^\\w.-]", "-")
                .replaceFirst("^[^A-Za-z0-9]+", "");
        String stem = plain.isEmpty() ? CampaignSettings.SCENE : plain;
        return stem.substring(0, Math.min(stem.length(), 50)) + suffix;
    }

    private int run(CampaignPlan plan) {
        PrintWriter target = spec.commandLine().getOut();
        CampaignResult result;
        if (out == null) {
            KeptCases kept = new KeptCases(plan);
            run(plan, kept);
            result = kept.result();
        } else {
            try (CampaignFiles files = new CampaignFiles(plan, PathWord.of("--out", out), false)) {
                run(plan, files.chunks());
                result = files.finish(Optional.empty());
            }
        }
        CampaignLines.print(plan, result, target);
        CampaignLines.printDeciding(plan, result.summary(), target);
        return 0;
    }

    private void run(CampaignPlan plan, CampaignRun.Chunks kept) {
        PrintWriter err = spec.commandLine().getErr();
        Interruption interruption = main.interruption();
        try (CaseProgress progress = new CaseProgress("compare", plan.runs(), err)) {
            new CampaignRun(plan).run(kept, progress);
        } catch (CancellationException e) {
            if (!interruption.happened()) {
                throw e;
            }
            err.println("interrupted: these are the results of the cases that were complete");
        }
        interruption.letFinish();
    }
}
