package org.dronewatch.report;

/** Directions in words. */
public final class CompassPoint {
    private static final String[] NAMES = {
        "north", "north-east", "east", "south-east", "south", "south-west", "west", "north-west"
    };

    private CompassPoint() {}

    /**
     * A bearing as a word, such as {@code north-west}.
     *
     * @param bearing clockwise from north, rad
     */
    public static String of(double bearing) {
        return NAMES[Math.floorMod(Math.round(bearing / (0.25 * Math.PI)), NAMES.length)];
    }
}
