package org.dronewatch.app;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.app.option.PathWord;
import org.dronewatch.app.option.SceneChoice;
import org.dronewatch.app.option.SetOption;
import org.dronewatch.campaign.CampaignReader;
import org.dronewatch.campaign.CampaignSettings;
import org.dronewatch.campaign.variation.Uniform;
import org.dronewatch.campaign.variation.Variation;
import org.dronewatch.report.file.ShellWord;
import org.dronewatch.run.store.StorePlace;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.SettingsPath;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** What {@code compare} compares, as a campaign of two variants. */
final class ComparedScenes {
    @Parameters(index = "0", paramLabel = "A", description = "A packaged scene, a scene file, or a class.")
    private String first;

    @Parameters(
            index = "1",
            arity = "0..1",
            paramLabel = "B",
            description = "The scene to compare A with; if omitted, A with the changes given by --with.")
    private String second;

    @Option(
            names = "--with",
            paramLabel = "PATH=VALUE",
            description = "Overrides a setting in the second scene only, as --set does in both.")
    private List<String> changes = new ArrayList<>();

    @Option(
            names = "--set",
            paramLabel = "PATH=VALUE",
            description = "Overrides a setting in both scenes; --with overrides one in the second only.")
    private List<String> common = new ArrayList<>();

    @Option(
            names = "--vary",
            paramLabel = "FILE.yaml",
            description = "Campaign file that states what varies (vary, table), runs and seed.")
    private String vary;

    @Option(
            names = "--runs",
            paramLabel = "N",
            description = "Number of cases; by default the number in the --vary file, or else 1,000.")
    private Integer runs;

    @Option(names = "--seed", paramLabel = "N", description = "Seed of all random numbers.")
    private Long seed;

    /** The campaign file that states what varies, if one does. */
    Optional<Path> file() {
        return Optional.ofNullable(vary).map(name -> PathWord.of("--vary", name));
    }

    /**
     * The campaign.
     *
     * @param store where prepared sites are kept
     * @throws InputException with a one-line message when anything is wrong
     */
    CampaignSettings settings(StorePlace store) {
        if (second == null && changes.isEmpty()) {
            throw new InputException(
                    "compare needs a second scene, or --with PATH=VALUE for each setting that differs");
        }
        CampaignSettings settings = file().map(path -> CampaignReader.read(path).forScene(first))
                .orElseGet(() -> CampaignSettings.of(first).withVary(allBearings(store)));
        Map<String, String> both = SetOption.parsed("--set", common);
        Map<String, String> other = new LinkedHashMap<>(both);
        if (second != null) {
            other.put(CampaignSettings.SCENE, second);
        }
        other.putAll(SetOption.parsed("--with", changes));
        Map<String, Map<String, String>> variants = new LinkedHashMap<>();
        variants.put(name(first, ""), both);
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

    /** Every bearing is equally likely for each drone whose flight has one, except for birds. */
    private Map<String, Variation> allBearings(StorePlace store) {
        SceneSettings scene =
                new SceneRunner(SceneChoice.named(first)).store(store).settings();
        Variation any = Variation.of(new Uniform("0 deg", "360 deg"));
        Map<String, Variation> bearings = new LinkedHashMap<>();
        for (String drone : scene.drones().keySet()) {
            String path = "drones." + drone + ".flight.bearing";
            if (!scene.birds().contains(drone) && isThere(scene, path)) {
                bearings.put(path, any);
            }
        }
        return bearings;
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

    /** The command that runs a case of the comparison again, without {@code --case} and its number. */
    String caseCommand() {
        StringBuilder words = new StringBuilder("dronewatch compare ").append(ShellWord.of(first));
        if (second != null) {
            words.append(' ').append(ShellWord.of(second));
        }
        changes.forEach(change -> words.append(" --with ").append(ShellWord.of(change)));
        common.forEach(change -> words.append(" --set ").append(ShellWord.of(change)));
        if (vary != null) {
            words.append(" --vary ").append(ShellWord.of(vary));
        }
        return words + (runs == null ? "" : " --runs " + runs) + (seed == null ? "" : " --seed " + seed);
    }
}
