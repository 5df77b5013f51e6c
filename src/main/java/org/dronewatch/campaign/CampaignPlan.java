package org.dronewatch.campaign;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.dronewatch.campaign.outcome.Cases;
import org.dronewatch.campaign.outcome.SensitivitySettings;
import org.dronewatch.campaign.outcome.UntilSettings;
import org.dronewatch.run.store.StorePlace;
import org.dronewatch.scenario.InputFiles;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.GivenScene;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.Draws;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsPath;
import org.dronewatch.setting.input.FileHash;
import org.dronewatch.world.SiteMemory;

/**
 * The cases of a campaign, and its variants with their models. In case k, the seed depends only on the
 * campaign's seed and on k, and the value drawn for a setting also on that setting's path and distribution; neither
 * depends on the number of cases, on the variants, or on what else varies. Immutable and thread-safe.
 */
public final class CampaignPlan implements Cases {
    /** Purpose of the draws of settings that vary; the path takes the place of the sensor's name. */
    private static final String VARIATION = "variation";

    private static final String CASE = "case";

    /** The heap divided by this number is the memory for results that are computed from the sites without drones. */
    private static final int MEMORY_SHARE = 4;

    private final CampaignSettings settings;
    private final StorePlace store;
    private final FactorTable table;
    private final SiteMemory memory = new SiteMemory(Runtime.getRuntime().maxMemory() / MEMORY_SHARE);
    private final Map<String, CampaignVariant> variants = new LinkedHashMap<>();
    private final Map<String, Quantity> quantities = new LinkedHashMap<>();
    private final VariedFiles varied = new VariedFiles();

    /**
     * Reads the scenes of all variants, loads their models, and checks that the least and greatest values of all
     * settings that vary are valid.
     *
     * @param directory directory of the campaign file
     * @param notes receives a line for each file read, and each warning
     * @throws InputException when anything is wrong, with a message of one line
     */
    public CampaignPlan(CampaignSettings settings, Path directory, Consumer<String> notes) {
        this(settings, directory, CampaignScenes.beside(directory), notes);
    }

    /**
     * Reads the scenes of all variants, supplied by the caller, loads their models, and checks that the least and
     * greatest values of all settings that vary are valid.
     *
     * @param directory directory against which the name of the campaign's table of settings (CSV) is resolved
     * @param scenes supplies a scene by its name, and states where prepared sites are kept
     * @param notes receives a line for each file read, and each warning
     * @throws InputException when anything is wrong, with a message of one line
     */
    public CampaignPlan(CampaignSettings settings, Path directory, CampaignScenes scenes, Consumer<String> notes) {
        this.settings = settings;
        this.store = scenes.store();
        this.table =
                settings.table().map(name -> FactorTable.read(directory, name)).orElse(FactorTable.NONE);
        checkPaths();
        Map<String, Map<String, String>> named =
                settings.variants().isEmpty() ? Map.of(CampaignSettings.ALONE, Map.of()) : settings.variants();
        named.forEach((name, changes) -> {
            CampaignVariant variant = CampaignVariant.of(
                    name,
                    scenes,
                    settings.scene(),
                    changes,
                    variants.values().stream().findFirst(),
                    notes);
            checkDrawn(variant);
            checkTable(variant);
            variant.models().share(memory);
            variants.put(name, variant);
        });
        new AskedOutcomes(this).check();
    }

    /** Checks that no column of the table is a setting that a variant sets or whose values are drawn. */
    private void checkPaths() {
        try {
            settings.variants().forEach((name, changes) -> CampaignSettings.checkFixed(name, changes, table.paths()));
        } catch (IllegalArgumentException e) {
            throw new InputException(e.getMessage(), e);
        }
        for (String path : table.paths()) {
            for (String drawn : settings.vary().keySet()) {
                if (VariedPaths.overlap(path, drawn)) {
                    throw new InputException("vary." + drawn + ": "
                            + (path.equals(drawn) ? "is also" : "overlaps '" + path + "',") + " a column of "
                            + settings.table().orElseThrow());
                }
            }
        }
    }

    private void checkDrawn(CampaignVariant variant) {
        settings.vary().forEach((path, variation) -> {
            try {
                new SettingsPath(path).read(variant.settings());
                Quantity quantity = new SettingsPath(path).quantity(variant.settings());
                quantities.put(path, quantity);
                for (String value : variation.extremes(quantity)) {
                    varied.read(variant, variant.with(variant.settings(), path, value), value);
                }
            } catch (IllegalArgumentException | InputException e) {
                throw new InputException("vary." + path + of(variant) + ": " + e.getMessage(), e);
            }
        });
    }

    private void checkTable(CampaignVariant variant) {
        List<String> columns = table.paths();
        for (int column = 0; column < columns.size(); column++) {
            Set<String> checked = new HashSet<>();
            for (int row = 0; row < table.size(); row++) {
                String value = table.row(row).get(column);
                if (checked.add(value)) {
                    check(variant, columns.get(column), value, table.location(row, column));
                }
            }
        }
    }

    private void check(CampaignVariant variant, String path, String value, String location) {
        try {
            new SettingsPath(path).read(variant.settings());
            varied.read(variant, variant.with(variant.settings(), path, value), value);
        } catch (IllegalArgumentException | InputException e) {
            throw new InputException(location + of(variant) + ": " + e.getMessage(), e);
        }
    }

    private String of(CampaignVariant variant) {
        return settings.variants().isEmpty() ? "" : " (variant " + variant.name() + ")";
    }

    /** The campaign. */
    public CampaignSettings settings() {
        return settings;
    }

    /** The number of cases, or, if it depends on their outcomes, the largest number. */
    public int runs() {
        return size();
    }

    @Override
    public int size() {
        boolean isStated = settings.runs().isPresent() || settings.until().isPresent();
        int rows = table.size() == 0 ? Integer.MAX_VALUE : table.size();
        return isStated || rows == Integer.MAX_VALUE ? Math.min(settings.most(), rows) : rows;
    }

    /** The paths of the settings that vary: the columns of the table, then those whose values are drawn. */
    public List<String> paths() {
        List<String> paths = new ArrayList<>(table.paths());
        paths.addAll(settings.vary().keySet());
        return paths;
    }

    /** SHA-256 hash of the table; empty if there is none. */
    public Optional<String> tableHash() {
        return settings.table().map(name -> table.hash());
    }

    /**
     * SHA-256 hashes of the files named by values of settings that vary, apart from the models of the variants; in a
     * fixed order.
     */
    public List<String> variedHashes() {
        return varied.hashes();
    }

    /**
     * The variant whose outcomes decide when the campaign ends; the first variant if the campaign names none for this.
     */
    public String observed() {
        return settings.until()
                .flatMap(UntilSettings::variant)
                .orElseGet(() -> variants.keySet().iterator().next());
    }

    /** The variants, in the order of the campaign. */
    @Override
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

    @Override
    public List<String> values(int number) {
        List<String> values = new ArrayList<>(table.size() == 0 ? List.of() : table.row(number));
        settings.vary().keySet().forEach(path -> {
            double u =
                    Draws.stream(settings.seed(), path, "", number, VARIATION).nextDouble();
            values.add(value(path, u));
        });
        return values;
    }

    @Override
    public long seed(int number) {
        return Draws.derivedSeed(settings.seed(), CASE, number);
    }

    /**
     * The settings of a case.
     *
     * @throws InputException when its values are not valid together
     */
    public SceneSettings settings(int number, String variant) {
        return settings(this, number, variant);
    }

    /** Where the prepared sites of the campaign's scenes are kept. */
    public StorePlace store() {
        return store;
    }

    /**
     * A case as a scene.
     *
     * @throws InputException when its values are not valid together
     */
    public CaseScene scene(int number, String variant) {
        CampaignVariant of = variants.get(variant);
        Scene scene = new GivenScene(name(number, variant), of.described().directory(), settings(number, variant));
        return new CaseScene(scene, new SceneRunner(scene).store(store).share(of.models()));
    }

    /** The name of a case in pictures: {@code palace, case 10 (spotter)}. */
    String name(int number, String variant) {
        return variants.get(variant).described().name() + ", case " + number
                + (settings.variants().isEmpty() ? "" : " (" + variant + ")");
    }

    SceneSettings settings(Cases cases, int number, String variant) {
        CampaignVariant of = variants.get(variant);
        SceneSettings one = new SettingsPath("run.seed").write(of.settings(), Long.toString(cases.seed(number)));
        List<String> values = cases.values(number);
        int i = 0;
        for (String path : paths()) {
            one = of.with(one, path, values.get(i++));
        }
        return one;
    }

    /** The settings and files from which a variant was read, with its models. */
    public InputFiles inputs(String variant) {
        return variants.get(variant).runner().inputs();
    }

    /** The cache of results computed from the sites without drones, which all cases and variants share. */
    public SiteMemory memory() {
        return memory;
    }

    /** For a setting that varies, the value at a quantile of its distribution, 0 or more and below 1. */
    String value(String path, double quantile) {
        return settings.vary().get(path).value(quantities.get(path), quantile);
    }

    /** The further cases that show which settings matter, if the campaign asks for them. */
    public Optional<SensitivityCases> sensitivity() {
        return settings.sensitivity()
                .filter(one -> one.method() != SensitivitySettings.Method.NONE)
                .map(one -> new SensitivityCases(this, one));
    }

    CampaignVariant variant(String name) {
        return variants.get(name);
    }
}
