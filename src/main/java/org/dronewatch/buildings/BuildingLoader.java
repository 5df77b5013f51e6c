package org.dronewatch.buildings;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.dronewatch.buildings.io.MapArea;
import org.dronewatch.buildings.io.MapFeatures;
import org.dronewatch.buildings.io.MapFiles;
import org.dronewatch.buildings.io.MapSystem;
import org.dronewatch.buildings.land.LandSurvey;
import org.dronewatch.geo.MapExtent;
import org.dronewatch.geo.MapTransform;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.parallel.LongTask;
import org.dronewatch.setting.Counted;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.input.PackagedSite;
import org.dronewatch.terrain.TerrainGround;

/**
 * Converts the buildings on a map to solids in the world frame. Each building stands on the lowest ground below it,
 * from which its height is measured, and extends {@value #BELOW} m below this ground, so that no gap is left on a
 * slope. Immutable.
 */
public final class BuildingLoader {
    /** How far walls reach below the lowest ground under them, m. */
    static final double BELOW = 1.0;

    /** Parts of a building near the rim may lie this far beyond it, m. */
    private static final double MARGIN = 2000.0;

    /** Making solids of more buildings than this takes seconds. */
    private static final int MANY = 50_000;

    private static final int MOST_TRIANGLES = 50_000_000;

    private final Path directory;
    private final Consumer<String> progress;

    /**
     * A loader of files by name.
     *
     * @param directory directory against which relative paths are resolved
     */
    public BuildingLoader(Path directory) {
        this(directory, line -> {});
    }

    /**
     * A loader of files by name.
     *
     * @param directory directory against which relative paths are resolved
     * @param progress receives a line before each step that takes seconds, unless the step is watched as a {@link
     *     LongTask}
     */
    public BuildingLoader(Path directory, Consumer<String> progress) {
        this.directory = directory;
        this.progress = progress;
    }

    /**
     * Reads the buildings of a map.
     *
     * @param settings settings that name a file
     * @param origin origin of the world frame
     * @param terrain the ground on which the buildings stand; if empty, the level of the origin
     * @throws InputException with a one-line message when the file is missing, damaged or in no known format, or has no
     *     building near the origin
     */
    public LoadedBuildings load(BuildingSettings settings, Origin origin, Optional<TerrainGround> terrain) {
        String file = settings.file().orElseThrow(() -> new InputException("needs a 'file', a map with buildings"));
        MapFeatures map = new MapFiles(directory, progress)
                .read(file, MapArea.about(origin, settings.radius() + MARGIN), settings.landCover());
        BuildingReport report = new BuildingReport(PackagedSite.plain(file), settings, map.leftOut());
        BuildingSite site = new BuildingSite(settings, origin, terrain, report);
        TriangleMesh mesh = map.model().isPresent()
                ? new CityBuildings(map.model().get(), settings, site.transform(map), report).mesh(terrain)
                : mesh(file, map, site, report);
        TriangleMesh woods = woods(map, site, terrain, settings, report);
        Optional<LandSurvey.Found> land = land(map, site, terrain, settings);
        boolean hasLand = land.isPresent() && land.get().cover().isAnywhere();
        if (report.count() == 0 && woods.triangleCount() == 0 && !hasLand) {
            throw new InputException(nothing(settings, origin, map, site, report));
        }
        Map<String, Integer> colours = new HashMap<>(BuildingMaterials.colours(mesh.materialNames()));
        colours.put(Canopies.MATERIAL, Canopies.COLOUR);
        List<String> lines = report.lines(map, mesh.triangleCount());
        List<String> warnings = report.warnings();
        site.overruled(map).ifPresent(warnings::add);
        land.ifPresent(found -> {
            // The attribution comes last.
            lines.addAll(lines.size() - (BuildingReport.attribution(map).isPresent() ? 1 : 0), found.description());
            warnings.addAll(found.warnings());
        });
        return new LoadedBuildings(
                mesh,
                woods,
                colours,
                report.outlines(),
                BuildingReport.attribution(map),
                report.count(),
                report.area(),
                report.assumed(),
                map.hash(),
                land.map(LandSurvey.Found::cover),
                lines,
                warnings);
    }

    /** Why there is nothing near the origin: what was left out, and where the map is instead. */
    private static String nothing(
            BuildingSettings settings, Origin origin, MapFeatures map, BuildingSite site, BuildingReport report) {
        boolean isOsm = map.system().rule() == MapSystem.Rule.ALWAYS_DEGREES;
        MapExtent extent = map.system().extent();
        MapTransform transform = site.transform(map);
        return String.format(
                Locale.ROOT,
                "%s: has no building within %s of the origin, at latitude %.5f and longitude %.5f%s: %s%s",
                PackagedSite.plain(settings.file().orElseThrow()),
                Quantity.LENGTH.inWords(settings.radius()),
                Math.toDegrees(origin.latitude()),
                Math.toDegrees(origin.longitude()),
                report.leftOut().map(what -> " (left out: " + what + ")").orElse(""),
                extent.inWords(transform),
                extent.suspicion(
                        transform,
                        origin,
                        settings.radius(),
                        isOsm ? "of the origin" : "of the origin, or those in the file,"));
    }

    private static TriangleMesh woods(
            MapFeatures map,
            BuildingSite site,
            Optional<TerrainGround> terrain,
            BuildingSettings settings,
            BuildingReport report) {
        Canopies canopies = new Canopies(terrain, settings.woodHeight().orElse(0.0));
        for (Footprint wood : site.woods(map)) {
            if (settings.woodHeight().isEmpty()) {
                report.leave("wood");
            } else if (canopies.add(wood)) {
                report.addWood(wood.area());
            } else {
                report.leave("wood without ground below");
            }
        }
        return canopies.mesh();
    }

    /** The land cover of the terrain, as far as the map is read. */
    private static Optional<LandSurvey.Found> land(
            MapFeatures map, BuildingSite site, Optional<TerrainGround> terrain, BuildingSettings settings) {
        String file = PackagedSite.plain(settings.file().orElseThrow());
        double wanted = terrain.map(ground -> reach(ground.mesh().bounds())).orElse(settings.radius());
        // Whole metres, so that cells of a metre fit in.
        double half = Math.max(1.0, Math.ceil(Math.min(wanted, settings.radius() + MARGIN)));
        return settings.landCover()
                ? Optional.of(LandSurvey.of(file, map.land(), half, site.projection(map)))
                : Optional.empty();
    }

    /** Half of the side of the smallest square about the origin that contains a box, m. */
    private static double reach(AABB box) {
        return Math.max(Math.max(-box.minX(), box.maxX()), Math.max(-box.minY(), box.maxY()));
    }

    private TriangleMesh mesh(String file, MapFeatures map, BuildingSite site, BuildingReport report) {
        List<Building> buildings = site.buildings(map);
        BuildingParts parts = new BuildingParts(buildings);
        SolidMesh solids = new SolidMesh();
        int count = buildings.size();
        String what = String.format(Locale.ROOT, "buildings: extruding %s", Counted.of(count, "building"));
        try (LongTask task = LongTask.begin(what, count, count > MANY, progress)) {
            for (Building building : buildings) {
                site.build(building, parts, solids);
                task.advance(1);
                if (solids.triangles() > MOST_TRIANGLES) {
                    throw new InputException(file + ": more than " + MOST_TRIANGLES
                            + " triangles of buildings: choose a smaller radius");
                }
            }
        }
        return solids.mesh();
    }
}
