package org.dronewatch.run.model;

import java.util.List;
import java.util.Optional;
import org.dronewatch.buildings.BuildingSettings;
import org.dronewatch.bvh.TracingSettings;
import org.dronewatch.geo.Origin;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.terrain.TerrainSettings;
import org.dronewatch.world.WorldSettings;

/** The settings on which the parts of a site depend: runs in which they are the same share these parts. */
final class SiteKeys {
    private SiteKeys() {}

    /** What a terrain depends on. */
    record Place(TerrainSettings terrain, Origin origin) {
        static Optional<Place> of(WorldSettings world) {
            return world.terrain()
                    .map(terrain -> new Place(terrain, world.origin().orElseThrow()));
        }
    }

    /** What buildings depend on: they stand on the terrain. */
    record Town(BuildingSettings buildings, Origin origin, Optional<Place> terrain) {
        static Optional<Town> of(WorldSettings world) {
            return world.buildings()
                    .map(buildings -> new Town(buildings, world.origin().orElseThrow(), Place.of(world)));
        }
    }

    /** What a model depends on: the origin only if it is in coordinates of a national grid. */
    record Model(ModelSettings settings, Optional<Origin> origin) {
        /** A drone's model. */
        static Model of(ModelSettings settings) {
            return new Model(settings, Optional.empty());
        }

        static List<Model> of(WorldSettings world) {
            return world.models().stream()
                    .map(settings -> new Model(settings, settings.crs().flatMap(crs -> world.origin())))
                    .toList();
        }
    }

    /** What an index depends on. */
    record Site(Optional<Place> terrain, Optional<Town> town, List<Model> models, TracingSettings tracing) {
        static Site of(WorldSettings world) {
            return new Site(Place.of(world), Town.of(world), Model.of(world), world.tracing());
        }

        static Site of(ModelSettings model, TracingSettings tracing) {
            return new Site(Optional.empty(), Optional.empty(), List.of(Model.of(model)), tracing);
        }
    }
}
