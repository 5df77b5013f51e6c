package org.dronewatch.buildings;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.dronewatch.buildings.io.MapFeatures;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.Quantity;

/** Counts what becomes of the features of a map, and says it in lines. */
final class BuildingReport {
    private static final int EXAMPLES = 3;

    private final String file;
    private final BuildingSettings settings;
    private final Map<String, Integer> leftOut = new LinkedHashMap<>();
    private final Map<String, List<String>> doubts = new LinkedHashMap<>();
    private int buildings;
    private int parts;
    private int assumed;
    private int fromLevels;
    private double area;

    BuildingReport(String file, BuildingSettings settings, Map<String, Integer> leftOut) {
        this.file = file;
        this.settings = settings;
        this.leftOut.putAll(leftOut);
    }

    void leave(String what) {
        leftOut.merge(what, 1, Integer::sum);
    }

    /** Something odd about a feature. */
    void doubt(String what, String id) {
        doubts.computeIfAbsent(what, any -> new ArrayList<>()).add(id);
    }

    /** Something that was built. */
    void add(Building building, Dimensions dimensions, double squareMetres) {
        if (building.isPart()) {
            parts++;
        } else {
            buildings++;
        }
        assumed += dimensions.isAssumed() ? 1 : 0;
        fromLevels += !dimensions.isAssumed() && !isHeightStated(building) ? 1 : 0;
        area += squareMetres;
    }

    private static boolean isHeightStated(Building building) {
        return building.tags().containsKey("height") || building.tags().containsKey("building:height");
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
        lines.add(String.format(
                Locale.ROOT,
                "buildings: %,d triangles; heights: %,d stated, %,d from levels of %s, %,d assumed to be %s",
                triangles,
                count() - assumed - fromLevels,
                fromLevels,
                Quantity.LENGTH.inWords(settings.levelHeight()),
                assumed,
                Quantity.LENGTH.inWords(settings.height())));
        if (!leftOut.isEmpty()) {
            lines.add("buildings: left out: "
                    + leftOut.entrySet().stream()
                            .map(entry -> counted(entry.getValue(), entry.getKey()))
                            .collect(Collectors.joining(", ")));
        }
        if (map.format().startsWith("OpenStreetMap")) {
            lines.add("map data from OpenStreetMap, (c) OpenStreetMap contributors, Open Database License:"
                    + " openstreetmap.org/copyright");
        }
        return lines;
    }

    private static String counted(int count, String noun) {
        String several = noun.replaceFirst("^(\\w+)", "$1s");
        return String.format(Locale.ROOT, "%,d %s", count, count == 1 ? noun : several);
    }

    List<String> warnings() {
        List<String> warnings = new ArrayList<>();
        if (2 * assumed > count()) {
            warnings.add(String.format(
                    Locale.ROOT,
                    "%s: %,d of %,d buildings have no height in the map: %s is assumed (world.buildings.height)",
                    file,
                    assumed,
                    count(),
                    Quantity.LENGTH.inWords(settings.height())));
        }
        doubts.forEach((what, ids) -> warnings.add(file + ": " + PlainText.value(what) + ": "
                + ids.stream().limit(EXAMPLES).collect(Collectors.joining(", "))
                + (ids.size() > EXAMPLES ? " and " + (ids.size() - EXAMPLES) + " more" : "")));
        return warnings;
    }
}
