package org.dronewatch.buildings;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.geometry.Ints;

/** The outlines of a solid of a city model: the rim, in plan view, of all surfaces that face downwards. */
final class CityOutlines {
    /** A smaller area is not an outline, m2. */
    private static final double SMALLEST = 0.1;

    private CityOutlines() {}

    /**
     * The outlines of one solid, one for each separate piece of its floor.
     *
     * @param id identifier of the solid in the model
     * @param corners the numbers of the three vertices of each triangle of the closed solid
     * @param vertices x, y, z of each in turn, m
     */
    static List<BuildingOutline> of(String id, int[] corners, double[] vertices) {
        List<double[]> outers = new ArrayList<>();
        List<double[]> courts = new ArrayList<>();
        for (int[] numbers : CitySolid.rings(rim(corners, vertices))) {
            double[] ring = CitySolid.flat(numbers, vertices);
            double area = Rings.signedArea(ring);
            if (Math.abs(area) >= SMALLEST) {
                (area > 0.0 ? outers : courts).add(ring);
            }
        }
        double height = height(corners, vertices);
        List<BuildingOutline> outlines = new ArrayList<>();
        for (double[] outer : outers) {
            List<double[]> within = courts.stream()
                    .filter(court -> Rings.contains(outer, court[0], court[1]))
                    .toList();
            outlines.add(new BuildingOutline(id, Optional.empty(), false, outer, within, 0.0, height, false));
        }
        return outlines;
    }

    /**
     * The sides, as seen from above, at which a triangle that faces downwards has no neighbour that does; each once.
     */
    private static Map<Integer, Integer> rim(int[] corners, double[] vertices) {
        Ints floor = new Ints();
        for (int i = 0; i < corners.length; i += 3) {
            if (Rings.signedArea(CitySolid.flat(Arrays.copyOfRange(corners, i, i + 3), vertices)) < 0.0) {
                floor.add(corners[i]);
                floor.add(corners[i + 1]);
                floor.add(corners[i + 2]);
            }
        }
        Map<Integer, Integer> rim = new HashMap<>();
        // A floor seen from above runs clockwise, so its sides are turned round.
        CitySolid.open(floor.toArray()).keySet().forEach(side -> rim.put(side.intValue(), (int) (side >> 32)));
        return rim;
    }

    private static double height(int[] corners, double[] vertices) {
        double lowest = Double.POSITIVE_INFINITY;
        double highest = Double.NEGATIVE_INFINITY;
        for (int vertex : corners) {
            lowest = Math.min(lowest, vertices[3 * vertex + 2]);
            highest = Math.max(highest, vertices[3 * vertex + 2]);
        }
        return highest - lowest;
    }
}
