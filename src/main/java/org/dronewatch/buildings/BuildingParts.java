package org.dronewatch.buildings;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Finds the building that each part belongs to: the smallest outline that contains the part's middle. */
final class BuildingParts {
    /** Side of the squares into which outlines are sorted, m. */
    private static final double CELL = 100.0;

    /** Parts that cover less than this of an outline do not replace it. */
    private static final double WHOLE = 0.9;

    /** Points along each side of a grid on which coverage is measured. */
    private static final int SAMPLES = 48;

    private final Map<Long, List<Building>> outlines = new HashMap<>();
    private final Map<Building, List<Building>> parts = new LinkedHashMap<>();
    private final Map<Building, Building> owners = new HashMap<>();

    BuildingParts(List<Building> all) {
        boolean hasParts = all.stream().anyMatch(Building::isPart);
        if (!hasParts) {
            return;
        }
        all.stream().filter(one -> !one.isPart()).forEach(this::sort);
        all.stream().filter(Building::isPart).forEach(part -> outlineOf(part).ifPresent(owner -> {
            owners.put(part, owner);
            parts.computeIfAbsent(owner, any -> new ArrayList<>()).add(part);
        }));
    }

    private static long cell(double x, double y) {
        return (long) Math.floor(x / CELL) << 32 ^ (long) Math.floor(y / CELL) & 0xFFFFFFFFL;
    }

    private void sort(Building outline) {
        double[] box = box(outline.footprint().outer());
        for (double x = Math.floor(box[0] / CELL) * CELL; x <= box[1]; x += CELL) {
            for (double y = Math.floor(box[2] / CELL) * CELL; y <= box[3]; y += CELL) {
                outlines.computeIfAbsent(cell(x + 0.5 * CELL, y + 0.5 * CELL), any -> new ArrayList<>())
                        .add(outline);
            }
        }
    }

    /** Least and greatest x, least and greatest y. */
    private static double[] box(double[] ring) {
        double[] box = {ring[0], ring[0], ring[1], ring[1]};
        for (int i = 2; i < ring.length; i += 2) {
            box[0] = Math.min(box[0], ring[i]);
            box[1] = Math.max(box[1], ring[i]);
            box[2] = Math.min(box[2], ring[i + 1]);
            box[3] = Math.max(box[3], ring[i + 1]);
        }
        return box;
    }

    private Optional<Building> outlineOf(Building part) {
        double[] middle = part.footprint().inside();
        return outlines.getOrDefault(cell(middle[0], middle[1]), List.of()).stream()
                .filter(outline -> outline.footprint().contains(middle[0], middle[1]))
                .min((a, b) ->
                        Double.compare(a.footprint().area(), b.footprint().area()));
    }

    /** The building that a part belongs to, or the building itself; heights are measured from the ground under it. */
    Building ownerOf(Building building) {
        return owners.getOrDefault(building, building);
    }

    /** Whether parts represent the whole of an outline, so that it is not built itself. */
    boolean replace(Building outline) {
        return covered(outline) >= WHOLE;
    }

    /** Whether parts represent some of an outline, but not the whole. */
    boolean replaceSomeOf(Building outline) {
        return parts.containsKey(outline) && !replace(outline);
    }

    private double covered(Building outline) {
        List<Building> own = parts.getOrDefault(outline, List.of());
        if (own.isEmpty()) {
            return 0.0;
        }
        double[] box = box(outline.footprint().outer());
        int inside = 0;
        int covered = 0;
        for (int i = 0; i < SAMPLES; i++) {
            for (int j = 0; j < SAMPLES; j++) {
                double x = box[0] + (i + 0.5) / SAMPLES * (box[1] - box[0]);
                double y = box[2] + (j + 0.5) / SAMPLES * (box[3] - box[2]);
                if (outline.footprint().contains(x, y)) {
                    inside++;
                    covered += own.stream().anyMatch(part -> part.footprint().contains(x, y)) ? 1 : 0;
                }
            }
        }
        return inside == 0 ? 1.0 : (double) covered / inside;
    }
}
