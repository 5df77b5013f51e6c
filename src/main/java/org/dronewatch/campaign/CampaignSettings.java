package org.dronewatch.campaign;

import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.campaign.outcome.SensitivitySettings;
import org.dronewatch.campaign.outcome.UntilSettings;
import org.dronewatch.campaign.variation.Variation;
import org.dronewatch.setting.Check;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * A campaign: many cases of a scene with settings drawn at random, each of them run with every variant.
 *
 * @param scene a packaged scene by name, or a scene file in the directory of this file or below it
 * @param vary how settings vary from case to case, by path, such as {@code drones.intruder.speed}
 * @param table a CSV file in the directory of this file or below it, whose columns are paths of settings and whose rows
 *     are the cases
 * @param variants what each variant changes, by name of the variant: values of settings by path, as for {@code --set},
 *     and {@code scene} for another scene; if there are none, the only variant is the scene as it is
 * @param runs number of cases, 1 to a million, 1,000 by default; with {@code until}, the largest number
 * @param until how precisely a probability is to be known, instead of a fixed number of cases
 * @param sensitivity how to determine which settings matter
 * @param expect what the campaign is expected to show
 * @param seed seed of the values drawn for the cases, and of their runs
 */
public record CampaignSettings(
        String scene,
        Map<String, Variation> vary,
        Optional<String> table,
        Map<String, Map<String, String>> variants,
        @In(value = Quantity.NUMBER, from = 1, to = 1e6) Optional<Integer> runs,
        Optional<UntilSettings> until,
        Optional<SensitivitySettings> sensitivity,
        List<Expectation> expect,
        long seed) {
    /** Name of the only variant of a campaign that specifies none. */
    public static final String ALONE = "scene";

    /** The name under which a variant specifies another scene. */
    public static final String SCENE = "scene";

    private static final int RUNS = 1000;
    private static final int MOST_VARIANTS = 100;

    /** Checks the limits and copies the maps. */
    public CampaignSettings {
        Check.present("scene", scene);
        vary = Collections.unmodifiableMap(new LinkedHashMap<>(Check.present("vary", vary)));
        variants = Collections.unmodifiableMap(new LinkedHashMap<>(Check.present("variants", variants)));
        Check.present("table", table);
        Check.present("runs", runs);
        Check.present("until", until);
        Check.present("sensitivity", sensitivity);
        expect = List.copyOf(Check.present("expect", expect));
        Limits.check(CampaignSettings.class, scene, vary, table, variants, runs, until, sensitivity, expect, seed);
        if (variants.size() > MOST_VARIANTS) {
            throw new IllegalArgumentException(
                    "variants has " + variants.size() + " entries but must have at most 100");
        }
        vary.forEach(CampaignSettings::checkVariation);
        checkVaried(vary.keySet());
        for (Map.Entry<String, Map<String, String>> variant : variants.entrySet()) {
            checkVariant(variant.getKey(), variant.getValue(), vary.keySet());
        }
        if (until.isPresent() && until.get().variant().isPresent()) {
            checkNamed("until.variant", until.get().variant().get(), variants);
        }
        if (sensitivity.isPresent() && sensitivity.get().variant().isPresent()) {
            checkNamed("sensitivity.variant", sensitivity.get().variant().get(), variants);
        }
        for (Expectation one : expect) {
            if (one.variant().isPresent()) {
                checkNamed("expect.variant", one.variant().get(), variants);
            }
        }
        if (until.isPresent() && until.get().variant().isEmpty() && variants.size() > 1) {
            throw new IllegalArgumentException("until needs 'variant': one of " + String.join(", ", variants.keySet()));
        }
    }

    /** A campaign of 1,000 cases of a scene as it is, with seed 1. */
    @Defaults("scene")
    public static CampaignSettings of(String scene) {
        return new CampaignSettings(
                scene,
                Map.of(),
                Optional.empty(),
                Map.of(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                List.of(),
                1L);
    }

    /**
     * A copy for another scene, without variants and expectations, which ends after a fixed number of cases and
     * estimates no sensitivities.
     */
    public CampaignSettings forScene(String other) {
        return new CampaignSettings(
                other, vary, table, Map.of(), runs, Optional.empty(), Optional.empty(), List.of(), seed);
    }

    /** A copy in which other settings vary. */
    public CampaignSettings withVary(Map<String, Variation> others) {
        return SettingsForm.with(this, "vary", others);
    }

    /** A copy with other variants. */
    public CampaignSettings withVariants(Map<String, Map<String, String>> others) {
        return SettingsForm.with(this, "variants", others);
    }

    /**
     * A copy with settings that apply to all variants, unless a variant sets them itself.
     *
     * @param shared values of settings by path
     * @throws org.dronewatch.setting.InputException when one of these settings varies
     */
    public CampaignSettings withCommon(Map<String, String> shared) {
        Map<String, Map<String, String>> others = new LinkedHashMap<>();
        Map<String, Map<String, String>> named = variants.isEmpty() ? Map.of(ALONE, Map.of()) : variants;
        named.forEach((name, changes) -> {
            Map<String, String> all = new LinkedHashMap<>(shared);
            all.putAll(changes);
            others.put(name, all);
        });
        try {
            return withVariants(others);
        } catch (IllegalArgumentException e) {
            throw new InputException("--set: " + e.getMessage(), e);
        }
    }

    /** The number of cases, or, if it depends on their outcomes, the largest number. */
    public int most() {
        return runs.orElseGet(() -> until.map(one -> one.rule().most()).orElse(RUNS));
    }

    private static void checkNamed(String setting, String name, Map<String, ?> variants) {
        if (!variants.containsKey(name) && !(variants.isEmpty() && name.equals(ALONE))) {
            throw new IllegalArgumentException(
                    setting + " " + PlainText.value(name) + ": no such variant; the campaign has "
                            + (variants.isEmpty() ? ALONE : String.join(", ", variants.keySet())));
        }
    }

    private static void checkVariation(String path, Variation variation) {
        try {
            variation.check();
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("vary." + path + ": " + e.getMessage(), e);
        }
    }

    private static void checkVaried(Collection<String> paths) {
        try {
            VariedPaths.check(paths);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("vary." + e.getMessage(), e);
        }
    }

    private static void checkVariant(String name, Map<String, String> changes, Collection<String> vary) {
        if (!name.matches("[A-Za-z0-9][\\w.-]{0,63}")) {
            throw new IllegalArgumentException("variants." + name + ": a name must have 1 to 64 letters, digits,"
                    + " dots, hyphens and underscores, and begin with a letter or digit");
        }
        try {
            changes.keySet().forEach(VariedPaths::checkSeed);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("variants." + name + "." + e.getMessage(), e);
        }
        checkFixed(name, changes, vary);
    }

    /** Checks that a variant does not set what varies. */
    static void checkFixed(String name, Map<String, String> changes, Collection<String> vary) {
        for (String path : changes.keySet()) {
            for (String varied : vary) {
                if (VariedPaths.overlap(path, varied)) {
                    throw new IllegalArgumentException("variants." + name + ": '" + path + "' would override '" + varied
                            + "', which varies from case to case");
                }
            }
        }
    }
}
