package org.dronewatch.buildings;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;

/** What buildings are made of, according to the tags of OpenStreetMap, as names in the table of acoustic surfaces. */
final class BuildingMaterials {
    /** Follows the name of the material of a building whose height is assumed. */
    static final String ASSUMED = ":assumed-height";

    /** Colours of buildings whose material is not known, and of those whose height is not known: red, green, blue. */
    private static final int PLAIN = 0xC9C2B6;

    private static final int DOUBTFUL = 0xD8A56B;

    private static final Map<String, String> SURFACES = Map.ofEntries(
            Map.entry("brick", "brick_rough"),
            Map.entry("bricks", "brick_rough"),
            Map.entry("plaster", "brick_rendered"),
            Map.entry("render", "brick_rendered"),
            Map.entry("stucco", "brick_rendered"),
            Map.entry("concrete", "concrete_smooth"),
            Map.entry("reinforced_concrete", "concrete_smooth"),
            Map.entry("cement", "concrete_smooth"),
            Map.entry("cement_block", "concrete_block_coarse"),
            Map.entry("concrete_block", "concrete_block_coarse"),
            Map.entry("glass", "glass_double"),
            Map.entry("metal", "metal_sheet"),
            Map.entry("metal_plates", "metal_sheet"),
            Map.entry("steel", "metal_sheet"),
            Map.entry("stone", "limestone"),
            Map.entry("limestone", "limestone"),
            Map.entry("sandstone", "limestone"),
            Map.entry("granite", "limestone"),
            Map.entry("wood", "wood_16mm"),
            Map.entry("timber", "wood_16mm"),
            Map.entry("tiles", "ceramic_tiles"));

    private static final Map<String, Integer> COLOURS = Map.of(
            "brick_rough", 0xA45A45,
            "concrete_smooth", 0xB4B2AC,
            "concrete_block_coarse", 0xA5A39C,
            "glass_double", 0x8FA6B2,
            "metal_sheet", 0x9AA0A3,
            "limestone", 0xCDBE9D,
            "wood_16mm", 0x9C7950,
            "ceramic_tiles", 0xB08876);

    private BuildingMaterials() {}

    /** The name of a material: that of its acoustic surface, followed by {@link #ASSUMED} if the height is assumed. */
    static String name(Map<String, String> tags, String otherwise, boolean isAssumed) {
        String text = tags.getOrDefault("building:material", tags.getOrDefault("building:facade:material", ""));
        String surface = SURFACES.getOrDefault(text.strip().toLowerCase(Locale.ROOT), otherwise);
        return isAssumed ? surface + ASSUMED : surface;
    }

    /** The colours of materials in daylight. */
    static Map<String, Integer> colours(Iterable<String> names) {
        Map<String, Integer> colours = new HashMap<>();
        for (String name : names) {
            Integer known = COLOURS.get(name);
            if (known != null) {
                colours.put(name, known);
            } else {
                colours.put(name, name.endsWith(ASSUMED) ? DOUBTFUL : PLAIN);
            }
        }
        return colours;
    }
}
