package org.dronewatch.terrain;

import java.util.Map;

/** The colours of ground in daylight, by name of its acoustic surface: red, green and blue in the lowest 24 bits. */
final class GroundColours {
    private static final Map<String, Integer> COLOURS = Map.ofEntries(
            Map.entry("asphalt", 0x6F7173),
            Map.entry("asphalt_dense", 0x5C5E60),
            Map.entry("concrete_smooth", 0xB4B2AC),
            Map.entry("concrete_rough", 0xA5A39C),
            Map.entry("limestone", 0xCDBE9D),
            Map.entry("gravel_road", 0xA29783),
            Map.entry("gravel_loose_moist", 0x8C857A),
            Map.entry("compacted_field", 0x8A8550),
            Map.entry("pasture_uncompacted", TerrainSettings.COLOUR),
            Map.entry("grass_50mm", 0x5F7F34),
            Map.entry("grass_turf", 0x55793A),
            Map.entry("soil_rough", 0x7A624A),
            Map.entry("forest_floor", 0x4C5A33),
            Map.entry("snow_fresh_100mm", 0xF2F4F6),
            Map.entry("snow_or_moss", 0xC9D2C4),
            Map.entry("water_surface", 0x3F6C8A));

    private GroundColours() {}

    /** The colour of a material, whose name may end in a variant after a colon; meadows where none is known. */
    static int of(String material) {
        return COLOURS.getOrDefault(material.replaceFirst(":.*", ""), TerrainSettings.COLOUR);
    }
}
