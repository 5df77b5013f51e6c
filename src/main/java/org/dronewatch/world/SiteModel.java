package org.dronewatch.world;

import java.util.stream.Collectors;
import org.dronewatch.buildings.BuildingSettings;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.setting.input.PackagedSite;
import org.dronewatch.terrain.TerrainSettings;

/**
 * One of the models that a world was merged from.
 *
 * @param file its file, without the prefix of packaged models; empty for a world made from a finished kd-tree instead
 *     of files
 * @param role its role on the site
 */
public record SiteModel(String file, ModelRole role) {
    /** A model about which nothing is known: a building without a file. */
    static final SiteModel UNNAMED = new SiteModel("", ModelRole.BUILDING);

    /** The ground of a scene's terrain. */
    public static SiteModel of(TerrainSettings settings) {
        return new SiteModel(
                settings.allFiles().stream().map(PackagedSite::plain).collect(Collectors.joining(", ")),
                ModelRole.TERRAIN);
    }

    /** The buildings of a map. */
    public static SiteModel of(BuildingSettings settings) {
        return new SiteModel(settings.file().map(PackagedSite::plain).orElse(""), ModelRole.BUILDING);
    }

    /** The woods of a map. */
    public static SiteModel ofWoods(BuildingSettings settings) {
        return new SiteModel(of(settings).file(), ModelRole.VEGETATION);
    }

    /** The model that settings describe. */
    public static SiteModel of(ModelSettings settings) {
        return new SiteModel(settings.shownFile(), settings.role());
    }
}
