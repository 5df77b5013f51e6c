package org.dronewatch.buildings.land;

import java.util.List;

/**
 * A class of land cover. Its material is a name in the table of acoustic surfaces with a variant after a colon, so that
 * a scene can give roads, for instance, a different surface from that of car parks. CNOSSOS-EU (Directive (EU)
 * 2015/996, table 2.5.a) classifies forest floors, pasture and normal uncompacted ground, compacted fields and park
 * areas, gravel roads, asphalt and water by their flow resistivity; which surface represents which tag is a choice of
 * this program.
 */
public enum LandClass {
    /** Not stated by the map: the ground keeps its material. */
    NONE("", "no land cover", 0),
    WATER("water_surface:water", "water", 0x3F6C8A),
    RESIDENTIAL("compacted_field:residential", "residential area", 0xA89F90),
    BUILT_UP("asphalt:built-up", "industrial or commercial area", 0x9A948E),
    FARMLAND("pasture_uncompacted:farmland", "farmland", 0x93904F),
    GRASS("grass_turf:grass", "grass", 0x64853B),
    SCRUB("pasture_uncompacted:scrub", "scrub", 0x6C7142),
    WOOD("forest_floor:wood", "wood", 0x435F31),
    WETLAND("pasture_uncompacted:wetland", "wetland", 0x61765A),
    ROCK("concrete_rough:rock", "rock", 0x9D968B),
    SAND("soil_rough:sand", "sand", 0xCFBE90),
    EARTH("compacted_field:earth", "bare earth", 0x8A7453),
    PAVED("asphalt:paved", "paved area", 0x8C8A86),
    UNPAVED("gravel_road:unpaved", "gravel", 0xA09179),
    RAILWAY("gravel_road:railway", "railway", 0x74695F),
    ROAD("asphalt:road", "road", 0x6A6A69);

    /** All, by their codes in rasters. */
    private static final List<LandClass> ALL = List.of(values());

    private final String material;
    private final String words;
    private final int colour;

    LandClass(String material, String words, int colour) {
        this.material = material;
        this.words = words;
        this.colour = colour;
    }

    /** All classes, each at the index of its code. */
    public static List<LandClass> all() {
        return ALL;
    }

    /** The code of this class in rasters. */
    public int code() {
        return ordinal();
    }

    /** The name of the material of this class; empty for {@link #NONE}. */
    public String material() {
        return material;
    }

    /** The name of this class in reports. */
    public String words() {
        return words;
    }

    /** The colour of this class in daylight: red, green and blue in the lowest 24 bits. */
    public int colour() {
        return colour;
    }
}
