package org.dronewatch.terrain;

/** The heights of a plane, given by a point on it and by how much the plane rises along x and y. */
record Plane(double x, double y, double z, double byX, double byY) {
    /**
     * The plane through three points.
     *
     * @param corners x, y and z of each
     */
    static Plane through(double[] corners) {
        double ax = corners[3] - corners[0];
        double ay = corners[4] - corners[1];
        double az = corners[5] - corners[2];
        double bx = corners[6] - corners[0];
        double by = corners[7] - corners[1];
        double bz = corners[8] - corners[2];
        double cross = ax * by - ay * bx;
        return new Plane(corners[0], corners[1], corners[2], (az * by - bz * ay) / cross, (ax * bz - bx * az) / cross);
    }

    double at(double atX, double atY) {
        return z + (atX - x) * byX + (atY - y) * byY;
    }
}
