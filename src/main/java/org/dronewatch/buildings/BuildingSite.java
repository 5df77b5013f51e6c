package org.dronewatch.buildings;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.dronewatch.buildings.io.MapFeature;
import org.dronewatch.buildings.io.MapFeatures;
import org.dronewatch.geo.CoordinateReferenceSystem;
import org.dronewatch.geo.GeoPoint;
import org.dronewatch.geo.Geodesy;
import org.dronewatch.geo.MapTransform;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.input.PackagedSite;
import org.dronewatch.terrain.TerrainGround;

/**
 * What all buildings of a map have in common: the position of the map on the earth, the ground, and how features become
 * solids.
 */
final class BuildingSite {
    /** Thickness of the roof of a building without walls, m. */
    private static final double SLAB = 0.3;

    /** Corners of an outline that are nearer to each other than this count as one, m. */
    private static final double NEAR = 1e-3;

    /** A smaller outline is not a building, m2. */
    private static final double SMALLEST = 0.1;

    /** The largest difference between an outline and the pieces of its roof, as a fraction of its area. */
    private static final double PRECISION = 1e-4;

    private final BuildingSettings settings;
    private final Origin origin;
    private final Geodesy geodesy;
    private final Optional<GroundUnder> ground;
    private final BuildingReport report;

    /** What the scene states about the coordinates of the map. */
    private final Optional<CoordinateReferenceSystem> given;

    BuildingSite(BuildingSettings settings, Origin origin, Optional<TerrainGround> terrain, BuildingReport report) {
        this.settings = settings;
        this.origin = origin;
        this.geodesy = new Geodesy(origin);
        this.ground = terrain.map(below -> new GroundUnder(below, geodesy));
        this.report = report;
        this.given = settings.crs().map(CoordinateReferenceSystem::of);
    }

    private CoordinateReferenceSystem crs(MapFeatures map) {
        return map.system().crs(file(), given);
    }

    /** A warning if the scene's system is used instead of the file's. */
    Optional<String> overruled(MapFeatures map) {
        return given.flatMap(map.system()::overruled)
                .map(stated -> file() + ": states " + stated + ", but is read as " + given.orElseThrow()
                        + " (world.buildings.crs)");
    }

    MapTransform transform(MapFeatures map) {
        return new MapTransform(crs(map), origin);
    }

    /** The buildings near the origin, with their outlines at its level. */
    List<Building> buildings(MapFeatures map) {
        MapTransform transform = transform(map);
        boolean isPlain = crs(map).equals(CoordinateReferenceSystem.wgs84());
        List<Building> buildings = new ArrayList<>();
        for (MapFeature feature : map.features()) {
            if (feature.isWood()) {
                continue;
            }
            List<double[]> outers = new ArrayList<>();
            List<double[]> inners = new ArrayList<>();
            feature.outers().forEach(ring -> outers.add(inWorld(ring, transform, isPlain)));
            feature.inners().forEach(ring -> inners.add(inWorld(ring, transform, isPlain)));
            if (Rings.isWithin(settings.radius(), outers, inners)) {
                add(feature, outers, inners, buildings);
            }
        }
        return buildings;
    }

    /** The woods near the origin. */
    List<Footprint> woods(MapFeatures map) {
        List<Footprint> woods = new ArrayList<>();
        MapTransform transform = transform(map);
        boolean isPlain = crs(map).equals(CoordinateReferenceSystem.wgs84());
        for (MapFeature feature : map.features()) {
            if (feature.isWood()) {
                List<double[]> inners = feature.inners().stream()
                        .map(ring -> inWorld(ring, transform, isPlain))
                        .toList();
                feature.outers().stream()
                        .map(ring -> inWorld(ring, transform, isPlain))
                        .filter(outer -> outer.length >= 6
                                && Rings.isWithin(settings.radius(), List.of(outer), courts(outer, inners)))
                        .map(outer -> Footprint.of(outer, courts(outer, inners)))
                        .forEach(woods::add);
            }
        }
        return woods;
    }

    private static List<double[]> courts(double[] outer, List<double[]> inners) {
        return inners.stream()
                .filter(inner -> inner.length >= 6
                        && Math.abs(Rings.signedArea(inner)) >= SMALLEST
                        && Rings.contains(outer, inner[0], inner[1]))
                .toList();
    }

    /** From coordinates of the map to the plane of the world frame, x and y of each corner in turn. */
    UnaryOperator<double[]> projection(MapFeatures map) {
        MapTransform transform = transform(map);
        boolean isPlain = crs(map).equals(CoordinateReferenceSystem.wgs84());
        return line -> flat(line, transform, isPlain);
    }

    private double[] inWorld(double[] ring, MapTransform transform, boolean isPlain) {
        return Rings.cleaned(flat(ring, transform, isPlain), NEAR);
    }

    private double[] flat(double[] ring, MapTransform transform, boolean isPlain) {
        try {
            return onPlane(ring, transform, isPlain);
        } catch (InputException e) {
            throw new InputException(file() + ": " + e.getMessage(), e);
        }
    }

    private String file() {
        return PackagedSite.plain(settings.file().orElse(""));
    }

    private double[] onPlane(double[] ring, MapTransform transform, boolean isPlain) {
        double[] flat = new double[ring.length];
        double level = origin.height().orElse(0.0);
        for (int i = 0; i < ring.length; i += 2) {
            Position corner = isPlain
                    ? geodesy.inWorld(Math.toRadians(ring[i + 1]), Math.toRadians(ring[i]), level)
                    : transform.inWorld(ring[i], ring[i + 1], level);
            flat[i] = corner.x();
            flat[i + 1] = corner.y();
        }
        return flat;
    }

    private void add(MapFeature feature, List<double[]> outers, List<double[]> inners, List<Building> target) {
        String part = feature.tags().get("building:part");
        boolean isPart = part != null && !part.equals("no");
        for (double[] outer : outers) {
            if (outer.length < 6 || Math.abs(Rings.signedArea(outer)) < SMALLEST) {
                report.leave("outline without an area");
                continue;
            }
            Building building =
                    new Building(feature.id(), Footprint.of(outer, courts(outer, inners)), feature.tags(), isPart);
            if (building.isUnderground()) {
                report.leave("building underground");
            } else {
                target.add(building);
            }
        }
    }

    /** Builds a building, unless its parts are built instead. */
    void build(Building building, BuildingParts parts, SolidMesh solids) {
        if (!building.isPart() && parts.replace(building)) {
            return;
        }
        if (!building.isPart() && parts.replaceSomeOf(building)) {
            report.doubt("parts cover less than nine tenths of the outline, so it is modelled as well", building.id());
        }
        double level = origin.height().orElse(0.0);
        if (ground.isPresent()) {
            level = ground.get().range(parts.ownerOf(building).footprint())[0];
            if (Double.isNaN(level)) {
                report.leave("building without ground below");
                return;
            }
        }
        Footprint there = building.footprint();
        Dimensions dimensions = Dimensions.of(building.tags(), settings, there.outer());
        dimensions.doubts().forEach(doubt -> report.doubt(doubt, building.id()));
        if (dimensions.top() <= dimensions.bottom()) {
            report.leave("building of no height");
            return;
        }
        Upright upright = upright(there.outer()[0], there.outer()[1], level);
        solids.begin(upright, BuildingMaterials.name(building.tags(), settings.material(), dimensions.isAssumed()));
        solid(building.id(), relativeTo(there.outer()[0], there.outer()[1], there), dimensions, solids);
        report.add(building, dimensions, there.area());
        if (ground.isPresent()) {
            report.compare(building.id(), dimensions.top(), ground.get().range(there)[1] - level);
        }
    }

    /** The vertical through a corner of an outline, which lies at the level of the origin. */
    private Upright upright(double x, double y, double level) {
        double z = 0.0;
        GeoPoint corner = geodesy.onEarth(new Position(x, y, z));
        for (int i = 0; i < 2; i++) {
            z += origin.height().orElse(0.0) - corner.height();
            corner = geodesy.onEarth(new Position(x, y, z));
        }
        return new Upright(geodesy, new GeoPoint(corner.longitude(), corner.latitude(), level));
    }

    /** The outline from its first corner on. */
    private static Footprint relativeTo(double x, double y, Footprint footprint) {
        return new Footprint(
                shifted(footprint.outer(), x, y),
                footprint.courts().stream().map(court -> shifted(court, x, y)).toList());
    }

    private static double[] shifted(double[] ring, double x, double y) {
        double[] shifted = new double[ring.length];
        for (int i = 0; i < ring.length; i += 2) {
            shifted[i] = ring[i] - x;
            shifted[i + 1] = ring[i + 1] - y;
        }
        return shifted;
    }

    private void solid(String id, Footprint footprint, Dimensions dimensions, SolidMesh solids) {
        Footprint.Cut cut = footprint.cut();
        if (!cut.isWhole()) {
            report.doubt("the outline crosses itself, so its roof may have gaps", id);
        }
        double eaves = dimensions.top() - dimensions.rise();
        double bottom = dimensions.bottom() > 0.0 ? dimensions.bottom() : -BuildingLoader.BELOW;
        if (dimensions.isOpen() && dimensions.bottom() == 0.0) {
            bottom = Math.max(0.0, eaves - SLAB);
        }
        if (dimensions.roof() == RoofShape.FLAT) {
            solids.prism(footprint, cut, bottom, dimensions.top());
            return;
        }
        RoofPlanes roof = RoofPlanes.of(footprint.outer(), dimensions);
        List<Footprint> pieces = footprint.courts().isEmpty() ? pieces(footprint, roof) : List.of();
        if (pieces.isEmpty()) {
            report.doubt("the outline is too complicated for the stated roof shape, so the roof is made flat", id);
            solids.prism(footprint, cut, bottom, dimensions.top());
        } else {
            solids.underRoof(footprint, cut, bottom, eaves, roof, pieces);
        }
    }

    /** The pieces of a roof; empty if they do not cover the outline. */
    private static List<Footprint> pieces(Footprint footprint, RoofPlanes roof) {
        List<Footprint> pieces = new ArrayList<>();
        double covered = 0.0;
        for (double[] ring : roof.pieces(footprint.outer())) {
            if (ring.length >= 6 && Rings.signedArea(ring) > 1e-9) {
                Footprint piece = new Footprint(ring, List.of());
                pieces.add(piece);
                covered += piece.cut().area();
            }
        }
        return Math.abs(covered - footprint.area()) <= PRECISION * footprint.area() ? pieces : List.of();
    }
}
