package org.dronewatch.route.exposure;

import org.dronewatch.geometry.Position;

/** Gaussian quadrature along a straight piece of a path: three points, exact for polynomials up to the fifth degree. */
public final class GaussRule {
    /** The number of points. */
    public static final int POINTS = 3;

    private static final double OFF_CENTRE = 0.5 * Math.sqrt(0.6);

    private GaussRule() {}

    /**
     * Where a point lies on the piece.
     *
     * @param point number of the point, from 0
     * @return its position as a fraction of the piece, 0 to 1
     */
    public static double at(int point) {
        return 0.5 + (point - 1) * OFF_CENTRE;
    }

    /** The weight of a point; the weights of all points add up to 1. */
    public static double weight(int point) {
        return point == 1 ? 4.0 / 9.0 : 5.0 / 18.0;
    }

    /** The mean rate on a straight leg; see {@link ExposureField#mean}. */
    static double mean(ExposureField field, Position from, Position to, LegMotion motion, int mode, double longest) {
        int pieces = Math.max(1, (int) Math.ceil(from.distance(to) / longest));
        double dx = to.x() - from.x();
        double dy = to.y() - from.y();
        double dz = to.z() - from.z();
        double sum = 0.0;
        for (int piece = 0; piece < pieces; piece++) {
            for (int point = 0; point < POINTS; point++) {
                double share = (piece + at(point)) / pieces;
                sum += weight(point)
                        * field.rate(from.x() + share * dx, from.y() + share * dy, from.z() + share * dz, motion, mode);
            }
        }
        return sum / pieces;
    }
}
