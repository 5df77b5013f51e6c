package org.dronewatch.buildings.land;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.buildings.io.MapLength;

/** Determines land cover from the tags of OpenStreetMap. */
final class LandTags {
    /** The width of a lane, for roads that state their lanes but no width, m. */
    private static final double LANE = 3.25;

    private static final double WIDEST = 200.0;

    private static final Set<String> UNDERGROUND = Set.of("underground", "multi-storey", "rooftop");

    private static final Set<String> COURTS =
            Set.of("tennis", "basketball", "skateboard", "handball", "volleyball", "multi", "netball", "padel");

    /** Areas, by key and value. */
    private static final Map<String, LandClass> AREAS = Map.ofEntries(
            Map.entry("landuse=residential", LandClass.RESIDENTIAL),
            Map.entry("landuse=industrial", LandClass.BUILT_UP),
            Map.entry("landuse=commercial", LandClass.BUILT_UP),
            Map.entry("landuse=retail", LandClass.BUILT_UP),
            Map.entry("landuse=garages", LandClass.BUILT_UP),
            Map.entry("landuse=port", LandClass.BUILT_UP),
            Map.entry("landuse=depot", LandClass.BUILT_UP),
            Map.entry("landuse=railway", LandClass.RAILWAY),
            Map.entry("landuse=quarry", LandClass.ROCK),
            Map.entry("landuse=landfill", LandClass.EARTH),
            Map.entry("landuse=construction", LandClass.EARTH),
            Map.entry("landuse=brownfield", LandClass.EARTH),
            Map.entry("landuse=farmyard", LandClass.EARTH),
            Map.entry("landuse=farmland", LandClass.FARMLAND),
            Map.entry("landuse=farm", LandClass.FARMLAND),
            Map.entry("landuse=orchard", LandClass.FARMLAND),
            Map.entry("landuse=vineyard", LandClass.FARMLAND),
            Map.entry("landuse=plant_nursery", LandClass.FARMLAND),
            Map.entry("landuse=forest", LandClass.WOOD),
            Map.entry("landuse=meadow", LandClass.GRASS),
            Map.entry("landuse=grass", LandClass.GRASS),
            Map.entry("landuse=greenfield", LandClass.GRASS),
            Map.entry("landuse=village_green", LandClass.GRASS),
            Map.entry("landuse=recreation_ground", LandClass.GRASS),
            Map.entry("landuse=cemetery", LandClass.GRASS),
            Map.entry("landuse=allotments", LandClass.GRASS),
            Map.entry("landuse=reservoir", LandClass.WATER),
            Map.entry("landuse=basin", LandClass.WATER),
            Map.entry("landuse=salt_pond", LandClass.WATER),
            Map.entry("natural=wood", LandClass.WOOD),
            Map.entry("natural=scrub", LandClass.SCRUB),
            Map.entry("natural=heath", LandClass.SCRUB),
            Map.entry("natural=moor", LandClass.SCRUB),
            Map.entry("natural=fell", LandClass.SCRUB),
            Map.entry("natural=tundra", LandClass.SCRUB),
            Map.entry("natural=grassland", LandClass.GRASS),
            Map.entry("natural=water", LandClass.WATER),
            Map.entry("natural=wetland", LandClass.WETLAND),
            Map.entry("natural=mud", LandClass.WETLAND),
            Map.entry("natural=bare_rock", LandClass.ROCK),
            Map.entry("natural=rock", LandClass.ROCK),
            Map.entry("natural=scree", LandClass.ROCK),
            Map.entry("natural=shingle", LandClass.UNPAVED),
            Map.entry("natural=sand", LandClass.SAND),
            Map.entry("natural=beach", LandClass.SAND),
            Map.entry("natural=dune", LandClass.SAND),
            Map.entry("leisure=park", LandClass.GRASS),
            Map.entry("leisure=garden", LandClass.GRASS),
            Map.entry("leisure=golf_course", LandClass.GRASS),
            Map.entry("leisure=common", LandClass.GRASS),
            Map.entry("leisure=playground", LandClass.GRASS),
            Map.entry("leisure=pitch", LandClass.GRASS),
            Map.entry("leisure=swimming_pool", LandClass.WATER),
            Map.entry("amenity=swimming_pool", LandClass.WATER),
            Map.entry("amenity=grave_yard", LandClass.GRASS),
            Map.entry("amenity=parking", LandClass.PAVED),
            Map.entry("waterway=riverbank", LandClass.WATER),
            Map.entry("waterway=dock", LandClass.WATER),
            Map.entry("place=square", LandClass.PAVED),
            Map.entry("railway=platform", LandClass.PAVED),
            Map.entry("aeroway=apron", LandClass.PAVED),
            Map.entry("aeroway=helipad", LandClass.PAVED),
            Map.entry("aeroway=runway", LandClass.PAVED),
            Map.entry("aeroway=taxiway", LandClass.PAVED),
            Map.entry("man_made=pier", LandClass.PAVED),
            Map.entry("man_made=quay", LandClass.PAVED),
            Map.entry("man_made=breakwater", LandClass.ROCK),
            Map.entry("man_made=groyne", LandClass.ROCK));

    /** Lines, by key and value, and how wide they are, m; assumed by what is common in Europe. */
    private static final Map<String, LandUse> LINES = Map.ofEntries(
            road("motorway", 11.0),
            road("trunk", 10.0),
            road("primary", 8.0),
            road("secondary", 7.0),
            road("tertiary", 6.5),
            road("motorway_link", 6.0),
            road("trunk_link", 6.0),
            road("primary_link", 5.5),
            road("secondary_link", 5.5),
            road("tertiary_link", 5.5),
            road("unclassified", 5.5),
            road("residential", 6.0),
            road("living_street", 5.0),
            road("pedestrian", 5.0),
            road("road", 5.5),
            road("service", 4.0),
            road("raceway", 10.0),
            path("cycleway", LandClass.PAVED, 2.5),
            path("footway", LandClass.PAVED, 2.0),
            path("steps", LandClass.PAVED, 2.0),
            path("track", LandClass.UNPAVED, 3.0),
            path("path", LandClass.UNPAVED, 1.5),
            path("bridleway", LandClass.UNPAVED, 2.0),
            line("railway=rail", LandClass.RAILWAY, LandUse.Layer.RAILWAY, 5.0),
            line("railway=light_rail", LandClass.RAILWAY, LandUse.Layer.RAILWAY, 5.0),
            line("railway=subway", LandClass.RAILWAY, LandUse.Layer.RAILWAY, 5.0),
            line("railway=narrow_gauge", LandClass.RAILWAY, LandUse.Layer.RAILWAY, 4.0),
            line("railway=preserved", LandClass.RAILWAY, LandUse.Layer.RAILWAY, 5.0),
            line("railway=platform", LandClass.PAVED, LandUse.Layer.PAVED, 3.0),
            line("waterway=river", LandClass.WATER, LandUse.Layer.WATERWAY, 10.0),
            line("waterway=canal", LandClass.WATER, LandUse.Layer.WATERWAY, 10.0),
            line("waterway=stream", LandClass.WATER, LandUse.Layer.WATERWAY, 2.0),
            line("waterway=ditch", LandClass.WATER, LandUse.Layer.WATERWAY, 1.0),
            line("waterway=drain", LandClass.WATER, LandUse.Layer.WATERWAY, 1.0),
            line("aeroway=runway", LandClass.PAVED, LandUse.Layer.PAVED, 45.0),
            line("aeroway=taxiway", LandClass.PAVED, LandUse.Layer.PAVED, 15.0),
            line("man_made=pier", LandClass.PAVED, LandUse.Layer.PAVED, 3.0),
            line("man_made=quay", LandClass.PAVED, LandUse.Layer.PAVED, 3.0),
            line("man_made=breakwater", LandClass.ROCK, LandUse.Layer.PAVED, 6.0),
            line("man_made=groyne", LandClass.ROCK, LandUse.Layer.PAVED, 3.0));

    /** Classes by what the surface is tagged as; it wins over the class of what the shape is used for. */
    private static final Map<String, LandClass> SURFACES = Map.ofEntries(
            Map.entry("paved", LandClass.PAVED),
            Map.entry("asphalt", LandClass.PAVED),
            Map.entry("chipseal", LandClass.PAVED),
            Map.entry("concrete", LandClass.PAVED),
            Map.entry("concrete:plates", LandClass.PAVED),
            Map.entry("concrete:lanes", LandClass.PAVED),
            Map.entry("paving_stones", LandClass.PAVED),
            Map.entry("sett", LandClass.PAVED),
            Map.entry("cobblestone", LandClass.PAVED),
            Map.entry("unhewn_cobblestone", LandClass.PAVED),
            Map.entry("bricks", LandClass.PAVED),
            Map.entry("tartan", LandClass.PAVED),
            Map.entry("acrylic", LandClass.PAVED),
            Map.entry("unpaved", LandClass.UNPAVED),
            Map.entry("compacted", LandClass.UNPAVED),
            Map.entry("gravel", LandClass.UNPAVED),
            Map.entry("fine_gravel", LandClass.UNPAVED),
            Map.entry("pebblestone", LandClass.UNPAVED),
            Map.entry("ground", LandClass.EARTH),
            Map.entry("dirt", LandClass.EARTH),
            Map.entry("earth", LandClass.EARTH),
            Map.entry("soil", LandClass.EARTH),
            Map.entry("clay", LandClass.EARTH),
            Map.entry("mud", LandClass.EARTH),
            Map.entry("grass", LandClass.GRASS),
            Map.entry("grass_paver", LandClass.GRASS),
            Map.entry("sand", LandClass.SAND),
            Map.entry("rock", LandClass.ROCK));

    /** Keys in the order in which they decide. */
    private static final List<String> KEYS =
            List.of("waterway", "railway", "aeroway", "man_made", "natural", "leisure", "amenity", "place", "landuse");

    private LandTags() {}

    private static Map.Entry<String, LandUse> road(String kind, double width) {
        return line("highway=" + kind, LandClass.ROAD, LandUse.Layer.ROAD, width);
    }

    private static Map.Entry<String, LandUse> path(String kind, LandClass land, double width) {
        return line("highway=" + kind, land, LandUse.Layer.PATH, width);
    }

    private static Map.Entry<String, LandUse> line(String tag, LandClass land, LandUse.Layer layer, double width) {
        return Map.entry(tag, new LandUse(land, layer, width));
    }

    /** Whether something crosses over the ground or runs below it, so that it does not cover it. */
    static boolean isOffTheGround(Map<String, String> tags) {
        return isYes(tags, "bridge")
                || isYes(tags, "tunnel")
                || isYes(tags, "indoor")
                || "bridge".equals(tags.get("man_made"))
                || "underground".equals(tags.get("location"))
                || UNDERGROUND.contains(tags.getOrDefault("parking", ""));
    }

    private static boolean isYes(Map<String, String> tags, String key) {
        return !tags.getOrDefault(key, "no").equals("no");
    }

    static boolean isCoastline(Map<String, String> tags) {
        return "coastline".equals(tags.get("natural"));
    }

    /** The land cover of a closed shape as an area; empty if it is not an area, such as a roundabout. */
    static Optional<LandUse> area(Map<String, String> tags) {
        boolean isRoadArea = tags.containsKey("highway") && "yes".equals(tags.get("area"));
        if (isRoadArea || isYes(tags, "area:highway")) {
            return Optional.of(LandUse.area(surface(tags).orElse(LandClass.PAVED), LandUse.Layer.PAVED));
        }
        if (tags.containsKey("highway") || "no".equals(tags.get("area"))) {
            return Optional.empty();
        }
        for (String key : KEYS) {
            LandClass land = AREAS.get(key + "=" + tags.get(key));
            if (land != null) {
                return Optional.of(area(land, tags));
            }
        }
        return Optional.empty();
    }

    private static LandUse area(LandClass byUse, Map<String, String> tags) {
        if (byUse == LandClass.WATER) {
            return LandUse.area(byUse, LandUse.Layer.WATER);
        }
        boolean isCourt = "pitch".equals(tags.get("leisure")) && COURTS.contains(tags.getOrDefault("sport", ""));
        LandClass land = surface(tags).orElse(isCourt ? LandClass.PAVED : byUse);
        boolean isOverWater = tags.containsKey("man_made");
        boolean isPaved = land == LandClass.PAVED || isOverWater;
        return LandUse.area(land, isPaved ? LandUse.Layer.PAVED : LandUse.Layer.AREA);
    }

    /** The land cover of a shape as a line; empty if it is not a line. */
    static Optional<LandUse> line(Map<String, String> tags) {
        if ("yes".equals(tags.get("area"))) {
            return Optional.empty();
        }
        for (String key : List.of("highway", "railway", "waterway", "aeroway", "man_made")) {
            LandUse use = LINES.get(key + "=" + tags.get(key));
            if (use != null) {
                boolean hasSurface = key.equals("highway");
                LandClass land = hasSurface ? surfaceOfRoad(use.land(), tags) : use.land();
                return Optional.of(new LandUse(land, use.layer(), width(tags).orElse(use.width())));
            }
        }
        return Optional.empty();
    }

    private static LandClass surfaceOfRoad(LandClass byUse, Map<String, String> tags) {
        LandClass surface = surface(tags).orElse(byUse);
        return surface == LandClass.PAVED && byUse == LandClass.ROAD ? byUse : surface;
    }

    private static Optional<LandClass> surface(Map<String, String> tags) {
        String surface = tags.getOrDefault("surface", "").strip().toLowerCase(Locale.ROOT);
        return Optional.ofNullable(SURFACES.get(surface));
    }

    /** The width by its tag or by the number of lanes, m; empty if neither states a sensible one. */
    private static Optional<Double> width(Map<String, String> tags) {
        Optional<Double> stated = Optional.ofNullable(tags.get("width")).flatMap(MapLength::parse);
        Optional<Double> byLanes =
                Optional.ofNullable(tags.get("lanes")).flatMap(MapLength::parse).map(lanes -> LANE * lanes);
        return stated.filter(LandTags::isSensible).or(() -> byLanes.filter(LandTags::isSensible));
    }

    private static boolean isSensible(double width) {
        return width > 0.0 && width <= WIDEST;
    }
}
