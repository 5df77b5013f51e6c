package org.dronewatch.sensor.acoustic.edge;

/**
 * The directions in a plane in which the surfaces of an obstacle leave a point of its outline, as the narrowest cone
 * that contains them. If it is narrower than a half-plane, the point is a corner that a path can bend round; at the end
 * of a sheet, the cone has no width.
 */
final class Cone {
    private static final double STRAIGHT = 1e-9;

    /** The unit vectors along the borders: the first is clockwise of the second. */
    private double firstU;

    private double firstV;
    private double lastU;
    private double lastV;
    private boolean empty = true;
    private boolean tooWide;

    void clear() {
        empty = true;
        tooWide = false;
    }

    /** Widens the cone to a direction of length 1. */
    void add(double u, double v) {
        if (empty) {
            firstU = u;
            firstV = v;
            lastU = u;
            lastV = v;
            empty = false;
            return;
        }
        double ofFirst = firstU * v - firstV * u;
        double ofLast = lastU * v - lastV * u;
        double alongFirst = firstU * u + firstV * v;
        double alongLast = lastU * u + lastV * v;
        boolean beyondFirst = ofFirst < 0.0 || ofFirst == 0.0 && alongFirst < 0.0;
        boolean beyondLast = ofLast > 0.0 || ofLast == 0.0 && alongLast < 0.0;
        if (!beyondFirst && !beyondLast) {
            return;
        }
        if (beyondLast && ofFirst > STRAIGHT) {
            lastU = u;
            lastV = v;
        } else if (beyondFirst && ofLast < -STRAIGHT) {
            firstU = u;
            firstV = v;
        } else if (Math.abs(ofFirst) > STRAIGHT || alongFirst < 0.0 || Math.abs(ofLast) > STRAIGHT || alongLast < 0.0) {
            tooWide = true;
        }
    }

    /** Whether a path can bend around the point: the cone is narrower than a half-plane, and is not empty. */
    boolean isCorner() {
        return !empty && !tooWide && Math.hypot(firstU + lastU, firstV + lastV) > STRAIGHT;
    }

    /** Whether all directions are the same: a piece ends here, and no other one begins. */
    boolean isOfOnePiece() {
        return firstU == lastU && firstV == lastV;
    }

    /**
     * Whether a direction of any length lies within a corner's cone, rather than on its border or outside.
     *
     * @param margin angle from the border up to which directions count as on it, rad, small
     */
    boolean contains(double u, double v, double margin) {
        double least = margin * Math.hypot(u, v);
        return firstU * v - firstV * u > least && u * lastV - v * lastU > least;
    }

    /**
     * The angle by which the outline bends at a corner: 0 for a straight outline, pi for the edge of a sheet.
     */
    double bend() {
        double width = Math.atan2(Math.max(0.0, firstU * lastV - firstV * lastU), firstU * lastU + firstV * lastV);
        return Math.PI - width;
    }

    /** The u component of the unit vector through the middle of the cone, which must be that of a corner. */
    double middleU() {
        return (firstU + lastU) / Math.hypot(firstU + lastU, firstV + lastV);
    }

    double middleV() {
        return (firstV + lastV) / Math.hypot(firstU + lastU, firstV + lastV);
    }

    double firstU() {
        return firstU;
    }

    double firstV() {
        return firstV;
    }

    double lastU() {
        return lastU;
    }

    double lastV() {
        return lastV;
    }
}
