package org.dronewatch.sensor.acoustic.propagation;

/**
 * A plane {@code z = level + slopeU u + slopeV v} that reflects sound between two points above it, in the frame of
 * {@link GroundProfile}: one point is above u = 0, the other above u = distance, both above v = 0. If arcs are drawn as
 * straight lines, the heights are those of these lines. For use by one thread.
 */
final class MirrorPlane {
    private double firstZ;
    private double secondZ;
    private double distance;
    private double level;
    private double slopeU;
    private double slopeV;
    private double heightOfFirst;
    private double heightOfSecond;
    private double reflectionU;
    private double reflectionV;

    /**
     * Sets both points.
     *
     * @param z height of the first point, m
     * @param otherZ height of the second point, m
     * @param levelDistance horizontal distance between them, m
     */
    void between(double z, double otherZ, double levelDistance) {
        firstZ = z;
        secondZ = otherZ;
        distance = levelDistance;
    }

    /**
     * Lays the plane through a point below the line so that it is the point of reflection.
     *
     * @param u coordinate u of the point, m
     * @param z height of the point, m
     * @return whether there is such a plane, with both points above it
     */
    boolean reflectAt(double u, double z) {
        double before = Math.hypot(u, firstZ - z);
        double after = Math.hypot(distance - u, secondZ - z);
        double bisectorU = (distance - u) / after - u / before;
        double bisectorZ = (firstZ - z) / before + (secondZ - z) / after;
        if (!(bisectorZ > 0.0)) {
            return false;
        }
        reflectionU = u;
        reflectionV = 0.0;
        slopeU = -bisectorU / bisectorZ;
        slopeV = 0.0;
        level = z - slopeU * u;
        return setHeights();
    }

    /**
     * Lays the plane through a point below the line, and finds its point of reflection.
     *
     * @param u coordinate u of the point, m
     * @param z height of the point, m
     * @return distance along u from the point to that at which the plane reflects; if one of the two points is below
     *     the plane, because it is behind the hill, the result leads towards it; NaN if both are
     */
    double lay(double u, double z, double alongU, double alongV) {
        slopeU = alongU;
        slopeV = alongV;
        level = z - slopeU * u;
        if (!setHeights()) {
            boolean isFirstBelow = !(heightOfFirst > 0.0);
            boolean isSecondBelow = !(heightOfSecond > 0.0);
            return isFirstBelow && isSecondBelow ? Double.NaN : isFirstBelow ? -u : distance - u;
        }
        // The feet of both points' perpendiculars, and the point between them.
        double scale = 1.0 / Math.sqrt(1.0 + slopeU * slopeU + slopeV * slopeV);
        double footU = slopeU * scale * heightOfFirst;
        double footV = slopeV * scale * heightOfFirst;
        double otherU = distance + slopeU * scale * heightOfSecond;
        double otherV = slopeV * scale * heightOfSecond;
        double fraction = heightOfFirst / (heightOfFirst + heightOfSecond);
        reflectionU = footU + fraction * (otherU - footU);
        reflectionV = footV + fraction * (otherV - footV);
        return reflectionU - u;
    }

    /** Computes the heights above the plane, and returns whether both points are above it. */
    private boolean setHeights() {
        heightOfFirst = above(0.0, firstZ);
        heightOfSecond = above(distance, secondZ);
        return isBelowBoth();
    }

    /** Whether both points are above the plane laid last. */
    boolean isBelowBoth() {
        return heightOfFirst > 0.0 && heightOfSecond > 0.0;
    }

    /** Signed distance from the plane of a point above v = 0, m. */
    private double above(double u, double z) {
        return (z - z(u, 0.0)) / Math.sqrt(1.0 + slopeU * slopeU + slopeV * slopeV);
    }

    /** The height of the plane, m. */
    double z(double u, double v) {
        return level + slopeU * u + slopeV * v;
    }

    /** The coordinate u, along the line, of the point of reflection, m. */
    double reflectionU() {
        return reflectionU;
    }

    /** The coordinate v, to the left of the line, of the point of reflection, m. */
    double reflectionV() {
        return reflectionV;
    }

    /** Distance of the first point from the plane, m. */
    double heightOfFirst() {
        return heightOfFirst;
    }

    /** Distance of the second point from the plane, m. */
    double heightOfSecond() {
        return heightOfSecond;
    }

    /** Length of the path from the first point to the point of reflection, m. */
    double lengthBefore() {
        return Math.hypot(Math.hypot(reflectionU, reflectionV), firstZ - z(reflectionU, reflectionV));
    }

    /** Length of the path from the point of reflection to the second point, m. */
    double lengthAfter() {
        return Math.hypot(Math.hypot(reflectionU - distance, reflectionV), secondZ - z(reflectionU, reflectionV));
    }

    /** Sine of the elevation at which sound leaves the first point towards the reflection; negative downward. */
    double rise() {
        return (z(reflectionU, reflectionV) - firstZ) / lengthBefore();
    }
}
