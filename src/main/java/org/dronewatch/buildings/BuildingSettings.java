package org.dronewatch.buildings;

import java.util.Optional;
import org.dronewatch.geo.CoordinateReferenceSystem;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.FileName;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Minor;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.setting.input.PackagedSite;

/**
 * The buildings of a real place, from a map: OpenStreetMap (.osm, .osm.gz or .osm.pbf), outlines in GeoJSON, or a city
 * model in CityJSON. Buildings stand on the scene's terrain, around its geographic origin, {@code world.origin}, which
 * such a scene must state.
 *
 * @param file the map, or {@code packaged:NAME} for one in the library
 * @param crs coordinate reference system of GeoJSON or CityJSON by its EPSG code; omit it if the coordinates are
 *     longitude and latitude, or if the file states its system
 * @param radius distance from the origin within which buildings are included, 10 m to 20 km
 * @param height height of buildings for which the map states neither a height nor levels, 1 to 200 m
 * @param levelHeight height of a level, for buildings for which the map states only the number of levels, 1 to 20 m
 * @param verticalOffset offset that is added to the heights of a city model, -1000 to 1000 m: for one whose heights
 *     are not measured from the same level as {@code world.origin.height} and the terrain
 * @param woodHeight height of the woods on the map, which are modelled as opaque canopies, 1 to 100 m; omit it to leave
 *     out woods
 * @param landCover whether the ground of {@code world.terrain} has the colours and the acoustic surfaces of what the
 *     map shows there (water, roads, woods, ...); ground for which the map has no land cover keeps the material of the
 *     terrain
 * @param material material of buildings for which the map states none: a name in the table of surfaces
 */
public record BuildingSettings(
        @FileName(unless = PackagedSite.PREFIX) Optional<String> file,
        Optional<String> crs,
        @In(value = Quantity.LENGTH, from = 10, to = 20_000) double radius,
        @In(value = Quantity.LENGTH, from = 1, to = 200) double height,
        @In(value = Quantity.LENGTH, from = 1, to = 20) double levelHeight,
        @In(value = Quantity.LENGTH, from = -1000, to = 1000) double verticalOffset,
        @In(value = Quantity.LENGTH, from = 1, to = 100) Optional<Double> woodHeight,
        @Minor boolean landCover,
        String material) {
    /**
     * Buildings within 2 km, of rendered brick and three levels of 3 m where the map states nothing else; without a
     * file yet.
     */
    @Defaults
    public static final BuildingSettings DEFAULT = new BuildingSettings(
            Optional.empty(), Optional.empty(), 2000.0, 9.0, 3.0, 0.0, Optional.empty(), false, "brick_rendered");

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range, a text is empty, or the code of the coordinate
     *     reference system is not known
     */
    public BuildingSettings {
        Limits.check(
                BuildingSettings.class,
                file,
                crs,
                radius,
                height,
                levelHeight,
                verticalOffset,
                woodHeight,
                landCover,
                material);
        if (material.isBlank()) {
            throw new IllegalArgumentException("material is empty: it must be a name");
        }
        CoordinateReferenceSystem.checkSetting(crs);
    }

    /** Buildings from a map. */
    public static BuildingSettings of(String file) {
        return SettingsForm.with(DEFAULT, "file", Optional.of(file));
    }

    /** These settings with another coordinate reference system, such as {@code EPSG:25832}. */
    public BuildingSettings withCrs(String code) {
        return SettingsForm.with(this, "crs", Optional.of(code));
    }

    /** These settings with another radius, m. */
    public BuildingSettings withRadius(double metres) {
        return SettingsForm.with(this, "radius", metres);
    }

    /** These settings with another height of buildings whose height is not known, m. */
    public BuildingSettings withHeight(double metres) {
        return SettingsForm.with(this, "height", metres);
    }

    /** These settings with another height of a level, m. */
    public BuildingSettings withLevelHeight(double metres) {
        return SettingsForm.with(this, "levelHeight", metres);
    }

    /** These settings with another vertical offset of a city model, m. */
    public BuildingSettings withVerticalOffset(double metres) {
        return SettingsForm.with(this, "verticalOffset", metres);
    }

    /** These settings with the woods of the map as canopies of a given height, m. */
    public BuildingSettings withWoodHeight(double metres) {
        return SettingsForm.with(this, "woodHeight", Optional.of(metres));
    }

    /** These settings with the land cover of the map on the ground, or without it. */
    public BuildingSettings withLandCover(boolean isUsed) {
        return SettingsForm.with(this, "landCover", isUsed);
    }

    /** These settings with another material of buildings whose material is not known. */
    public BuildingSettings withMaterial(String name) {
        return SettingsForm.with(this, "material", name);
    }
}
