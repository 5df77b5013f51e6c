package org.dronewatch.models;

import java.util.List;

/** What grows on a patch of ground, judged by its slope, its height and some patchiness. */
final class GroundCover {

    static final Material GRASS = new Material("grass", 0.38, 0.47, 0.22);
    static final Material MEADOW = new Material("dry_meadow", 0.55, 0.53, 0.30);
    static final Material FOREST_FLOOR = new Material("forest_floor", 0.25, 0.30, 0.16);
    static final Material ROCK = new Material("rock", 0.50, 0.47, 0.43);
    static final List<Material> MATERIALS = List.of(GRASS, MEADOW, FOREST_FLOOR, ROCK);

    private static final double ROCK_DEGREES = 31;
    private static final double MEADOW_METRES = 88;
    private static final double FOREST_METRES = 66;
    private static final ValueNoise PATCHES = new ValueNoise(0x5eed05);

    private GroundCover() {}

    static Solid.Facet facet(Point a, Point b, Point c) {
        List<Point> corners = List.of(a, b, c);
        return new Solid.Facet(material(corners), corners);
    }

    static double slopeDegrees(List<Point> corners) {
        Point a = corners.get(0);
        Point up = corners.get(1).minus(a).cross(corners.get(2).minus(a)).unit();
        return StrictMath.toDegrees(StrictMath.acos(Math.min(up.y(), 1)));
    }

    private static Material material(List<Point> corners) {
        Point centre = Solid.centre(corners);
        double slope = slopeDegrees(corners);
        double patch = PATCHES.octaves(centre.x() / 90, centre.z() / 90, 3);
        if (slope > ROCK_DEGREES + 3 * patch) {
            return ROCK;
        }
        if (centre.y() > MEADOW_METRES + 30 * patch) {
            return MEADOW;
        }
        boolean wooded = Math.abs(centre.y() - FOREST_METRES) < 60 * patch;
        return wooded ? FOREST_FLOOR : GRASS;
    }
}
