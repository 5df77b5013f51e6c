package org.dronewatch.campaign;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import org.dronewatch.setting.Check;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * A campaign: many cases of a scene, whose settings are drawn at random, each run with every variant.
 *
 * @param scene a packaged scene by name, or a scene file beside this file or below
 * @param vary how settings vary from case to case, by their paths, such as {@code drones.intruder.speed}
 * @param variants what differs between the variants, by their names: settings by their paths with values, as for
 *     {@code --set}, and {@code scene} for another scene; without any there is one variant, the scene as it is
 * @param runs number of cases, 1 to a million
 * @param seed seed of what is drawn for the cases, and of their runs
 */
public record CampaignSettings(
        String scene,
        Map<String, Variation> vary,
        Map<String, Map<String, String>> variants,
        @In(value = Quantity.NUMBER, from = 1, to = 1e6) int runs,
        long seed) {
    /** Name of the variant of a campaign that states none. */
    public static final String ALONE = "scene";

    /** Under this name a variant states another scene. */
    public static final String SCENE = "scene";

    private static final int MOST_VARIANTS = 100;

    /** Checks the limits and copies the maps. */
    public CampaignSettings {
        Check.present("scene", scene);
        vary = Collections.unmodifiableMap(new LinkedHashMap<>(Check.present("vary", vary)));
        variants = Collections.unmodifiableMap(new LinkedHashMap<>(Check.present("variants", variants)));
        Limits.check(CampaignSettings.class, scene, vary, variants, runs, seed);
        if (variants.size() > MOST_VARIANTS) {
            throw new IllegalArgumentException("variants has " + variants.size() + " entries, must have at most 100");
        }
        vary.forEach(CampaignSettings::checkVariation);
        for (Map.Entry<String, Map<String, String>> variant : variants.entrySet()) {
            checkVariant(variant.getKey(), variant.getValue(), vary);
        }
    }

    /** A campaign of a scene as it is, with seed 1. */
    @Defaults({"scene", "vary", "runs"})
    public static CampaignSettings of(String scene, Map<String, Variation> vary, int runs) {
        return new CampaignSettings(scene, vary, Map.of(), runs, 1L);
    }

    private static void checkVariation(String path, Variation variation) {
        try {
            variation.check();
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("vary." + path + ": " + e.getMessage(), e);
        }
    }

    private static void checkVariant(String name, Map<String, String> changes, Map<String, Variation> vary) {
        if (!name.matches("[A-Za-z0-9][\\w.-]{0,63}")) {
            throw new IllegalArgumentException("variants." + name + ": a name must have 1 to 64 letters, digits,"
                    + " dots, hyphens and underscores, and begin with a letter or digit");
        }
        for (String path : changes.keySet()) {
            for (String varied : vary.keySet()) {
                boolean overlap = varied.equals(path) || varied.startsWith(path + ".") || path.startsWith(varied + ".");
                if (overlap) {
                    throw new IllegalArgumentException("variants." + name + ": '" + path + "' would override '" + varied
                            + "', which varies from case to case");
                }
            }
        }
    }
}
