package org.dronewatch.buildings;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.dronewatch.buildings.io.MapFeatures;
import org.dronewatch.setting.Counted;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.Quantity;

/** Counts what becomes of the features of a map, and describes it in lines. */
final class BuildingReport {
    private static final int EXAMPLES = 3;

    /** Farther above or below the ground than most foundations, m. */
    private static final double FLOATING = 3.0;

    /** Roofs that are lower than the ground by less than this count as level with it, m. */
    private static final double ROUNDED = 0.05;

    private static final String OPEN_STREET_MAP =
            "map data from OpenStreetMap, (c) OpenStreetMap contributors, Open Database License:"
                    + " openstreetmap.org/copyright";

    private final String file;
    private final BuildingSettings settings;
    private final Map<String, Integer> leftOut = new LinkedHashMap<>();
    private final Map<String, List<String>> doubts = new LinkedHashMap<>();
    private final List<Double> floors = new ArrayList<>();
    private final List<BuildingOutline> outlines = new ArrayList<>();
    private int added;
    private int buildings;
    private int parts;
    private int assumed;
    private int fromLevels;
    private int unusable;
    private int buried;
    private double deepest;
    private String deepestBuried = "";
    private double area;
    private int woods;
    private double woodArea;

    BuildingReport(String file, BuildingSettings settings, Map<String, Integer> leftOut) {
        this.file = file;
        this.settings = settings;
        this.leftOut.putAll(leftOut);
    }

    void leave(String what) {
        leftOut.merge(what, 1, Integer::sum);
    }

    /** Records something suspicious about a feature. */
    void doubt(String what, String id) {
        doubts.computeIfAbsent(what, any -> new ArrayList<>()).add(id);
    }

    /**
     * Records the ground under a building or part that was built.
     *
     * @param top height of its roof above the lowest ground, m
     * @param climb rise of the ground under it, from the lowest to the highest, m
     */
    void compare(String id, double top, double climb) {
        if (climb - top > ROUNDED) {
            buried++;
            if (climb - top > deepest) {
                deepest = climb - top;
                deepestBuried = String.format(
                        Locale.ROOT,
                        "%s is %.1f m high on ground that rises by %.1f m",
                        id,
                        tenths(top),
                        tenths(climb));
            }
        }
    }

    /** Records a building or part that was built. */
    void add(Building building, Dimensions dimensions, double squareMetres) {
        if (building.isPart()) {
            parts++;
        } else {
            buildings++;
        }
        assumed += dimensions.isAssumed() ? 1 : 0;
        unusable += dimensions.isAssumed() && isAnyStated(building) ? 1 : 0;
        fromLevels += dimensions.basis() == Dimensions.Basis.LEVELS ? 1 : 0;
        area += squareMetres;
        outlines.add(BuildingOutline.of(building, dimensions));
    }

    /** Records a solid of a city model that was built. */
    void add(CitySolid solid, double squareMetres, List<BuildingOutline> itsOutlines) {
        outlines.addAll(itsOutlines);
        buildings++;
        added += solid.floor() > 0 ? 1 : 0;
        area += squareMetres;
    }

    /** Records a wood that was built. */
    void addWood(double squareMetres) {
        woods++;
        woodArea += squareMetres;
    }

    /** Records how far the lowest points of the solids of a city model lie above the ground, m. */
    void floors(List<Double> heights) {
        floors.addAll(heights);
        Collections.sort(floors);
    }

    private static boolean isAnyStated(Building building) {
        return building.tags().containsKey("height")
                || building.tags().containsKey("building:height")
                || building.tags().containsKey("building:levels")
                || building.tags().containsKey("levels");
    }

    int count() {
        return buildings + parts;
    }

    int assumed() {
        return assumed;
    }

    double area() {
        return area;
    }

    /** The outlines of all that was built, in the order in which it was built. */
    List<BuildingOutline> outlines() {
        return outlines;
    }

    /** The attribution that maps of this format require. */
    static Optional<String> attribution(MapFeatures map) {
        return map.format().startsWith("OpenStreetMap") ? Optional.of(OPEN_STREET_MAP) : Optional.empty();
    }

    List<String> lines(MapFeatures map, int triangles) {
        List<String> lines = new ArrayList<>();
        lines.add(String.format(
                Locale.ROOT,
                "read %s: %s, %s%s within %s of the origin, %,.0f m2",
                file,
                map.format(),
                counted(buildings, "building"),
                parts == 0 ? "" : " and " + counted(parts, "part"),
                Quantity.LENGTH.inWords(settings.radius()),
                area));
        lines.add(map.model().isPresent() ? cityModel(triangles) : heights(triangles));
        if (woods > 0) {
            lines.add(String.format(
                    Locale.ROOT,
                    "woods: %s, %,.0f m2, %s high",
                    counted(woods, "wood"),
                    woodArea,
                    Quantity.LENGTH.inWords(settings.woodHeight().orElseThrow())));
        }
        leftOut().ifPresent(what -> lines.add("buildings: left out: " + what));
        attribution(map).ifPresent(lines::add);
        return lines;
    }

    /** What could not be built, and how often. */
    Optional<String> leftOut() {
        return leftOut.isEmpty()
                ? Optional.empty()
                : Optional.of(leftOut.entrySet().stream()
                        .map(entry -> counted(entry.getValue(), entry.getKey()))
                        .collect(Collectors.joining(", ")));
    }

    private String cityModel(int triangles) {
        return String.format(
                        Locale.ROOT,
                        "buildings: %s; %s",
                        Counted.of(triangles, "triangle"),
                        added == 0
                                ? "all solids have floors"
                                : Counted.of(
                                        added,
                                        "solid had no floor, which was added",
                                        "solids had no floors, which were added"))
                + (floors.isEmpty()
                        ? ""
                        : String.format(
                                Locale.ROOT,
                                "; lowest points from %.1f to %.1f m above the ground, median %.1f m",
                                tenths(floors.get(0)),
                                tenths(floors.get(floors.size() - 1)),
                                tenths(floors.get(floors.size() / 2))));
    }

    /** Rounded as it is shown; never -0. */
    private static double tenths(double value) {
        return Math.rint(10.0 * value) / 10.0 + 0.0;
    }

    private String heights(int triangles) {
        return String.format(
                Locale.ROOT,
                "buildings: %,d triangles; heights: %,d stated, %,d from levels of %s, %,d assumed to be %s",
                triangles,
                count() - assumed - fromLevels,
                fromLevels,
                Quantity.LENGTH.inWords(settings.levelHeight()),
                assumed,
                Quantity.LENGTH.inWords(settings.height()));
    }

    private static String counted(int count, String noun) {
        // Names of types, which begin with a capital letter, stay as they are.
        String several = noun.replaceFirst("^([a-z]+)", "$1s");
        return Counted.of(count, noun, several);
    }

    List<String> warnings() {
        List<String> warnings = new ArrayList<>();
        if (2 * assumed > count()) {
            warnings.add(String.format(
                    Locale.ROOT,
                    "%s: %,d of %s no height in the map%s: %s is assumed (world.buildings.height)",
                    file,
                    assumed,
                    Counted.of(count(), "building has", assumed == 1 ? "buildings has" : "buildings have"),
                    unusable == 0 ? "" : String.format(Locale.ROOT, ", or one that cannot be used (%,d)", unusable),
                    Quantity.LENGTH.inWords(settings.height())));
        }
        if (buried > 0) {
            warnings.add(String.format(
                    Locale.ROOT,
                    "%s: buildings whose roofs lie below the highest ground under them: %,d of %,d; %s; heights are measured from"
                            + " the lowest ground",
                    file,
                    buried,
                    count(),
                    deepestBuried));
        }
        if (!floors.isEmpty() && Math.abs(floors.get(floors.size() / 2)) > FLOATING) {
            warnings.add(String.format(
                    Locale.ROOT,
                    "%s: its buildings lie %.1f m %s the ground (median): their heights may refer to a different vertical datum; if so,"
                            + " set world.buildings.verticalOffset",
                    file,
                    Math.abs(floors.get(floors.size() / 2)),
                    floors.get(floors.size() / 2) > 0.0 ? "above" : "below"));
        }
        doubts.forEach((what, ids) -> warnings.add(file + ": " + PlainText.value(what) + ": "
                + ids.stream().limit(EXAMPLES).collect(Collectors.joining(", "))
                + (ids.size() > EXAMPLES ? " and " + (ids.size() - EXAMPLES) + " more" : "")));
        return warnings;
    }
}
