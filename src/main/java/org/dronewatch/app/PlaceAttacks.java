package org.dronewatch.app;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.app.console.Interruption;
import org.dronewatch.app.console.TaskProgress;
import org.dronewatch.app.option.PathWord;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.campaign.CampaignReader;
import org.dronewatch.campaign.CampaignRun;
import org.dronewatch.campaign.CampaignScenes;
import org.dronewatch.campaign.CampaignSettings;
import org.dronewatch.campaign.CaseExecution;
import org.dronewatch.campaign.SummedCases;
import org.dronewatch.placement.SolverLimits;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.site.Layout;
import org.dronewatch.placement.site.LeftOut;
import org.dronewatch.report.file.ShellWord;
import org.dronewatch.report.placement.AttackedPlaceResults;
import org.dronewatch.report.placement.PlaceResults;
import org.dronewatch.report.placement.UnattackedPlaceResults;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.GivenScene;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.SettingsPath;
import picocli.CommandLine.Option;

/** The options for the attacks that {@code place} flies against the layout and against the scene's own sensors. */
final class PlaceAttacks {
    private static final String TODAY = "today";
    private static final String LAYOUT = "layout";

    /** Stands for the layout where a scene is named; no scene has such a name. */
    private static final String LAYOUT_SCENE = "the layout";

    private static final String SENSORS = "sensors";

    @Option(
            names = "--campaign",
            paramLabel = "FILE.yaml",
            description = "Campaign file that states what varies (vary, table), runs and seed: the same attacks are"
                    + " flown against the layout and against the scene's own sensors.")
    private String file;

    @Option(
            names = "--runs",
            paramLabel = "N",
            description = "With --campaign: number of attacks, in place of the one in the campaign file.")
    private Integer runs;

    /** The campaign file and its table; none without a campaign. */
    List<Path> files() {
        List<Path> files = new ArrayList<>();
        if (file != null) {
            files.add(given());
            CampaignReader.read(given()).table().map(directory()::resolve).ifPresent(files::add);
        }
        return files;
    }

    private Path given() {
        return PathWord.of("--campaign", file);
    }

    private Path directory() {
        return given().toAbsolutePath().normalize().getParent();
    }

    /**
     * Checks the campaign against the scene as it is, before the search for a layout, which may take long.
     *
     * @param seed in place of the one in the campaign file
     * @throws InputException with a one-line message when anything is wrong
     */
    void check(PlacePlan plan, Optional<Long> seed) {
        if (file == null) {
            if (runs != null) {
                throw new InputException("--runs " + runs + ": needs --campaign FILE, which states what varies");
            }
            return;
        }
        CampaignPlan alone = plan(settings(plan, seed), plan, plan.present());
        for (String path : alone.paths()) {
            String[] steps = path.split("[.]", 3);
            if (steps[0].equals(SENSORS)
                    && (steps.length == 1 || !plan.settings().keep().contains(steps[1]))) {
                throw new InputException("--campaign " + PlainText.value(file) + ": '" + PlainText.value(path)
                        + "' cannot vary: only sensors named in 'keep' are in every layout");
            }
        }
    }

    private CampaignSettings settings(PlacePlan plan, Optional<Long> seed) {
        try {
            CampaignSettings settings =
                    CampaignReader.read(given()).forScene(plan.settings().scene());
            settings = seed.isEmpty() ? settings : new SettingsPath("seed").write(settings, Long.toString(seed.get()));
            return runs == null ? settings : new SettingsPath("runs").write(settings, Integer.toString(runs));
        } catch (InputException e) {
            throw runs != null && e.getMessage().startsWith("runs") ? new InputException("--" + e.getMessage(), e) : e;
        }
    }

    private CampaignPlan plan(CampaignSettings settings, PlacePlan plan, SceneSettings layout) {
        CampaignScenes scenes = CampaignScenes.of(name -> new GivenScene(
                        plan.scene().name(),
                        plan.scene().directory(),
                        name.equals(LAYOUT_SCENE) ? layout : plan.present()))
                .withStore(plan.runner().store());
        try {
            // What is read was reported when the placement was read.
            return new CampaignPlan(settings, directory(), scenes, note -> {});
        } catch (InputException e) {
            throw CampaignReader.placed(given(), e);
        }
    }

    /**
     * Flies the attacks, on the {@link org.dronewatch.parallel.Workers} of the calling thread.
     *
     * @param seed in place of the one in the campaign file
     * @param overrides overrides of the scene's settings
     * @param limits limits of the search
     * @return the results with those of the attacks; without them if none are asked for, if they cannot be flown, or
     *     after an interruption or the end of the time
     */
    PlaceResults flown(
            PlaceResults results,
            Optional<Long> seed,
            List<String> overrides,
            SolverLimits limits,
            Interruption interruption,
            TaskProgress shown) {
        PlacePlan plan = results.best().plan();
        if (file == null || results.best().chosen().isEmpty()) {
            return results;
        }
        if (interruption.happened() || results.isInterrupted()) {
            return new UnattackedPlaceResults(incomplete(results, limits, interruption));
        }
        CaseRuns runner = new CaseRuns(interruption, shown, CaseExecution.HERE);
        SceneSettings layout;
        try {
            layout = Layout.of(plan, results.best().chosen());
        } catch (InputException e) {
            runner.shown().notes().accept("the attacks are not flown against the layout: " + e.getMessage());
            return results;
        }
        Map<String, Map<String, String>> variants = new LinkedHashMap<>();
        variants.put(LAYOUT, Map.of(CampaignSettings.SCENE, LAYOUT_SCENE));
        if (!plan.present().enabledSensors().isEmpty()) {
            variants.put(TODAY, Map.of());
        }
        CampaignPlan attacks = plan(settings(plan, seed).withVariants(variants), plan, layout);
        Optional<Integer> given = Optional.ofNullable(runs);
        SummedCases kept = new SummedCases(attacks);
        boolean isWhole = runner.run(new CampaignRun(attacks), kept, "attacks");
        if (isWhole) {
            return new AttackedPlaceResults(results, attacks, kept.result(), again(plan, seed, overrides, given));
        }
        PlaceResults incomplete = incomplete(results, limits, interruption);
        int flown = kept.result().summary().variants().get(LAYOUT).cases();
        return flown == 0
                ? new UnattackedPlaceResults(incomplete)
                : new AttackedPlaceResults(
                        incomplete, attacks, kept.result(), again(plan, seed, overrides, Optional.of(flown)));
    }

    /** The results without all of the attacks, because the user does not wait for them or the time is up. */
    private static PlaceResults incomplete(PlaceResults results, SolverLimits limits, Interruption interruption) {
        return interruption.isOutOfTime() ? results.without(LeftOut.ATTACKS, limits) : results;
    }

    /** The scene as an argument of a command: a file names it relative to its own directory, a command does not. */
    private static String scene(PlacePlan plan) {
        String name = plan.settings().scene();
        return SceneFile.isFileName(name)
                ? ShellWord.of(plan.scene().directory().resolve(Path.of(name).getFileName()))
                : ShellWord.of(name);
    }

    /**
     * The comparison that gives the same figures, as the arguments that follow the layout.
     *
     * @param cases number of attacks, in place of the one in the campaign file
     */
    private String again(PlacePlan plan, Optional<Long> seed, List<String> overrides, Optional<Integer> cases) {
        StringBuilder words = new StringBuilder(scene(plan)).append(" --vary ").append(ShellWord.of(file));
        overrides.forEach(one -> words.append(" --set ").append(ShellWord.of(one)));
        return words
                + cases.map(one -> " --runs " + one).orElse("")
                + seed.map(one -> " --seed " + one).orElse("");
    }
}
