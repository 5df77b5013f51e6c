package org.dronewatch.models;

import java.util.ArrayList;
import java.util.List;

/**
 * A wing section of the NACA four-digit family (Jacobs, Ward and Pinkerton, NACA Report 460, 1933), with the last
 * coefficient that closes the trailing edge. The thickness is laid off at right angles to the chord instead of the mean
 * line: at 2 % camber the difference is below a thousandth of the chord.
 *
 * @param camber greatest height of the mean line, as a fraction of the chord, at 0.4 of the chord
 * @param thickness greatest thickness, as a fraction of the chord
 */
record Airfoil(double camber, double thickness) {
    /** NACA 0009, as usual for tails. */
    static final Airfoil TAIL = new Airfoil(0.0, 0.09);

    private static final double CREST = 0.4;
    private static final int HALF = 14;
    private static final Point UP = new Point(0, 1, 0);
    private static final Point RIGHT = new Point(1, 0, 0);

    /**
     * The position of a section.
     *
     * @param nose leading edge
     * @param chord length from the leading to the trailing edge, metres, straight backward
     */
    record Station(Point nose, double chord) {
        /** This station mirrored at the model's plane of symmetry. */
        Station mirrored() {
            return new Station(new Point(-nose.x(), nose.y(), nose.z()), chord);
        }
    }

    /** A wing or stabiliser through stations from left to right. */
    Solid wing(Material material, List<Station> stations) {
        return loft(material, UP, stations);
    }

    /** An upright fin through stations from its foot to its top; its upper side faces to the right. */
    Solid fin(Material material, List<Station> stations) {
        return loft(material, RIGHT, stations);
    }

    private Solid loft(Material material, Point up, List<Station> stations) {
        return Solids.loft(
                material, stations.stream().map(station -> outline(station, up)).toList());
    }

    /** From the trailing edge over the upper side to the leading edge, and back along the lower side. */
    private List<Point> outline(Station station, Point up) {
        List<Point> outline = new ArrayList<>();
        for (int i = 0; i < 2 * HALF; i++) {
            double x = 0.5 * (1.0 + StrictMath.cos(StrictMath.PI * i / HALF));
            double side = i <= HALF ? 1.0 : -1.0;
            double height = mean(x) + side * half(x);
            outline.add(
                    station.nose().plus(new Point(0, 0, x * station.chord())).plus(up.times(height * station.chord())));
        }
        return outline;
    }

    private double half(double x) {
        double polynomial = -0.1260 * x - 0.3516 * x * x + 0.2843 * x * x * x - 0.1036 * x * x * x * x;
        return 5.0 * thickness * (0.2969 * Math.sqrt(x) + polynomial);
    }

    private double mean(double x) {
        return x < CREST
                ? camber / (CREST * CREST) * (2.0 * CREST * x - x * x)
                : camber / ((1.0 - CREST) * (1.0 - CREST)) * (1.0 - 2.0 * CREST + 2.0 * CREST * x - x * x);
    }
}
