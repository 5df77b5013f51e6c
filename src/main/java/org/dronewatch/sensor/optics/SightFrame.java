package org.dronewatch.sensor.optics;

/**
 * The points at which the rays of a camera's pixels pass a drone, in the plane through the drone's origin perpendicular
 * to the line of sight: their coordinates to the side, which is level, and upwards. For use by one thread.
 */
final class SightFrame {
    private final double[][] grid;
    private final double[] side = new double[3];
    private final double[] top = new double[3];
    private final double[] ahead = new double[3];
    private double range;
    private double azimuth;
    private double elevation;

    // The direction of the first pixel of a row in the frame, and its changes per column.
    private double x;
    private double y;
    private double z;
    private double stepX;
    private double stepY;
    private double stepZ;

    private double stretch;
    private double across;
    private double above;

    SightFrame(CameraObject camera) {
        this.grid = camera.grid();
    }

    /** Sets the vector from the camera to the drone, and its length, m. */
    void set(double dx, double dy, double dz, double length) {
        double level = Math.sqrt(dx * dx + dy * dy);
        double sin = level > 0.0 ? dx / level : 0.0;
        double cos = level > 0.0 ? dy / level : 1.0;
        double sinUp = dz / length;
        range = length;
        azimuth = Math.atan2(sin, cos);
        elevation = Math.atan2(dz, level);
        set(side, cos, -sin, 0.0);
        set(top, -sin * sinUp, -cos * sinUp, level / length);
        set(ahead, dx / length, dy / length, sinUp);
        stepX = dot(side, grid[1]);
        stepY = dot(top, grid[1]);
        stepZ = dot(ahead, grid[1]);
    }

    private static void set(double[] vector, double first, double second, double third) {
        vector[0] = first;
        vector[1] = second;
        vector[2] = third;
    }

    /** Azimuth of the line of sight, clockwise from north, rad. */
    double azimuth() {
        return azimuth;
    }

    /** Elevation of the line of sight, rad. */
    double elevation() {
        return elevation;
    }

    /** Begins a row at a column. */
    void beginRow(int column, int row) {
        x = dot(side, grid[0]) + column * stepX + row * dot(side, grid[2]);
        y = dot(top, grid[0]) + column * stepY + row * dot(top, grid[2]);
        z = dot(ahead, grid[0]) + column * stepZ + row * dot(ahead, grid[2]);
    }

    /** Sets the pixel, given by the number of columns from the beginning of the row. */
    void setColumn(int number) {
        stretch = range / (z + number * stepZ);
        across = stretch * (x + number * stepX);
        above = stretch * (y + number * stepY);
    }

    /** Whether the pixel's ray leads to the plane. */
    boolean isAhead() {
        return stretch > 0.0;
    }

    /** The distance to the side at which the ray passes the drone's origin, m. */
    double across() {
        return across;
    }

    /** The distance above the drone's origin at which the ray passes it, m. */
    double above() {
        return above;
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
