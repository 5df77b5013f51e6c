package org.dronewatch.buildings;

/**
 * A rectangle about an outline, parallel to one of the sides of the outline.
 *
 * @param x of its centre, m
 * @param y of its centre, m
 * @param alongX x of the unit vector along its first side
 * @param alongY y of the same
 * @param halfLength half of its first side, m
 * @param halfWidth half of its second side, m
 */
record Rectangle(double x, double y, double alongX, double alongY, double halfLength, double halfWidth) {
    /** The smallest one, whose first side is the longer one. */
    static Rectangle about(double[] ring) {
        Rectangle smallest = null;
        int last = ring.length - 2;
        for (int i = 0; i < ring.length; i += 2) {
            double dx = ring[i] - ring[last];
            double dy = ring[i + 1] - ring[last + 1];
            double length = Math.hypot(dx, dy);
            if (length > 0.0) {
                Rectangle candidate = about(ring, dx / length, dy / length);
                if (smallest == null || candidate.area() < smallest.area() * (1.0 - 1e-9)) {
                    smallest = candidate;
                }
            }
            last = i;
        }
        Rectangle found = smallest == null ? about(ring, 1.0, 0.0) : smallest;
        return found.halfLength >= found.halfWidth ? found : found.turned();
    }

    /** The one whose first side has this direction, a unit vector. */
    static Rectangle about(double[] ring, double alongX, double alongY) {
        double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (int i = 0; i < ring.length; i += 2) {
            double u = ring[i] * alongX + ring[i + 1] * alongY;
            double v = -ring[i] * alongY + ring[i + 1] * alongX;
            low[0] = Math.min(low[0], u);
            high[0] = Math.max(high[0], u);
            low[1] = Math.min(low[1], v);
            high[1] = Math.max(high[1], v);
        }
        double u = 0.5 * (low[0] + high[0]);
        double v = 0.5 * (low[1] + high[1]);
        return new Rectangle(
                u * alongX - v * alongY,
                u * alongY + v * alongX,
                alongX,
                alongY,
                0.5 * (high[0] - low[0]),
                0.5 * (high[1] - low[1]));
    }

    private double area() {
        return halfLength * halfWidth;
    }

    /** The same rectangle with its sides exchanged. */
    Rectangle turned() {
        return new Rectangle(x, y, -alongY, alongX, halfWidth, halfLength);
    }

    /** Its corners, counter-clockwise. */
    double[] ring() {
        double ux = halfLength * alongX;
        double uy = halfLength * alongY;
        double vx = -halfWidth * alongY;
        double vy = halfWidth * alongX;
        return new double[] {
            x - ux - vx, y - uy - vy, x + ux - vx, y + uy - vy, x + ux + vx, y + uy + vy, x - ux + vx, y - uy + vy
        };
    }
}
