package org.dronewatch.models;

import java.util.ArrayList;
import java.util.List;

/** Propeller blades. */
final class Propeller {
    /** The radius, metres, at which the chords below were drawn; larger blades are wider in proportion. */
    private static final double DRAWN_RADIUS = 0.093;

    private Propeller() {}

    /**
     * A thin twisted blade, widest at a third of its length: pitch falls from root to tip.
     *
     * @param hub middle of an upright axis
     * @param radius radius of the tip, metres
     * @param standing where the blade points, radians from the model's right towards its tail
     * @param turn 1 or -1: the direction in which it turns
     */
    static Solid blade(Material material, Point hub, double radius, double standing, double turn) {
        double scale = radius / DRAWN_RADIUS;
        double[] station = {0.06, 0.14, 0.30, 0.50, 0.70, 0.88, 0.97, 1.00};
        double[] chord = {0.010, 0.016, 0.023, 0.020, 0.016, 0.012, 0.008, 0.003};
        double[] pitchDegrees = {26, 24, 20, 15, 12, 9, 8, 8};
        Point along = new Point(StrictMath.cos(standing), 0, StrictMath.sin(standing));
        Point aside = new Point(-StrictMath.sin(standing), 0, StrictMath.cos(standing));
        List<List<Point>> outlines = new ArrayList<>();
        for (int i = 0; i < station.length; i++) {
            double pitch = StrictMath.toRadians(pitchDegrees[i]) * turn;
            Point wide = aside.times(StrictMath.cos(pitch)).plus(new Point(0, StrictMath.sin(pitch), 0));
            Point thick = along.cross(wide);
            Point centre = hub.plus(along.times(station[i] * radius));
            List<Point> outline = new ArrayList<>();
            for (int k = 0; k < 10; k++) {
                double angle = 2 * StrictMath.PI * k / 10;
                outline.add(centre.plus(wide.times(0.5 * (chord[i] * scale) * StrictMath.cos(angle)))
                        .plus(thick.times((0.0011 * scale) * StrictMath.sin(angle))));
            }
            outlines.add(outline);
        }
        return Solids.loft(material, outlines);
    }
}
