package org.dronewatch.campaign;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Draws;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsPath;
import org.dronewatch.setting.file.FileHash;

/**
 * The cases of a campaign, and its variants with their models. Case k depends only on the campaign's seed, on k and on
 * the paths of the settings that vary, not on the number of cases, on the variants, or on what else varies. Immutable
 * and thread-safe.
 */
public final class CampaignPlan {
    /** Purpose of the draws of settings that vary; the path takes the place of the sensor's name. */
    private static final String VARIATION = "variation";

    private static final String CASE = "case";

    private final CampaignSettings settings;
    private final Map<String, CampaignVariant> variants = new LinkedHashMap<>();
    private final Map<String, Quantity> quantities = new LinkedHashMap<>();

    /**
     * Reads the scenes of all variants, loads their models, and checks that the least and greatest values of all
     * settings that vary are valid.
     *
     * @param directory of the campaign file
     * @param notes receives a line for each file read, and each warning
     * @throws InputException in one line when anything is wrong
     */
    public CampaignPlan(CampaignSettings settings, Path directory, Consumer<String> notes) {
        this.settings = settings;
        Map<String, Map<String, String>> named =
                settings.variants().isEmpty() ? Map.of(CampaignSettings.ALONE, Map.of()) : settings.variants();
        named.forEach((name, changes) -> {
            CampaignVariant variant = CampaignVariant.of(
                    name,
                    directory,
                    settings.scene(),
                    changes,
                    variants.values().stream().findFirst(),
                    notes);
            check(variant);
            variants.put(name, variant);
        });
    }

    private void check(CampaignVariant variant) {
        settings.vary().forEach((path, variation) -> {
            try {
                new SettingsPath(path).read(variant.settings());
                Quantity quantity = new SettingsPath(path).quantity(variant.settings());
                quantities.put(path, quantity);
                for (String value : variation.extremes(quantity)) {
                    variant.with(variant.settings(), path, value);
                }
            } catch (IllegalArgumentException | InputException e) {
                String where = settings.variants().isEmpty() ? "" : " (variant " + variant.name() + ")";
                throw new InputException("vary." + path + where + ": " + e.getMessage(), e);
            }
        });
    }

    /** The campaign. */
    public CampaignSettings settings() {
        return settings;
    }

    /** The number of cases, or, if it depends on their outcomes, the largest number. */
    public int runs() {
        return settings.most();
    }

    /** The variant whose outcomes decide when the campaign ends, if they do. */
    public String observed() {
        return settings.until()
                .flatMap(UntilSettings::variant)
                .orElseGet(() -> variants.keySet().iterator().next());
    }

    /** The names of the variants, in the order of the campaign. */
    public List<String> variants() {
        return List.copyOf(variants.keySet());
    }

    /** The settings that all cases of a variant share. */
    public SceneSettings shared(String variant) {
        return variants.get(variant).settings();
    }

    /** The files of the models of a variant, by the models' names. */
    public Map<String, List<FileHash>> files(String variant) {
        return variants.get(variant).models().files();
    }

    /** The texts of the values of a case, in the order of the campaign. */
    public List<String> values(int number) {
        List<String> values = new ArrayList<>();
        settings.vary().forEach((path, variation) -> {
            double u =
                    Draws.stream(settings.seed(), path, "", number, VARIATION).nextDouble();
            values.add(variation.value(quantities.get(path), u));
        });
        return values;
    }

    /** The seed of the runs of a case, the same for all variants. */
    public long seed(int number) {
        return Draws.derivedSeed(settings.seed(), CASE, number);
    }

    /**
     * The settings of a case.
     *
     * @throws InputException when its values are not valid together
     */
    public SceneSettings settings(int number, String variant) {
        CampaignVariant of = variants.get(variant);
        SceneSettings one = new SettingsPath("run.seed").write(of.settings(), Long.toString(seed(number)));
        List<String> values = values(number);
        int i = 0;
        for (String path : settings.vary().keySet()) {
            one = of.with(one, path, values.get(i++));
        }
        return one;
    }

    CampaignVariant variant(String name) {
        return variants.get(name);
    }
}
