package org.dronewatch.sensor.acoustic.propagation;

/**
 * An arc of sound between two points, approximated by straight pieces. The ends of the pieces are not at simple
 * fractions of the arc, so that they are unlikely to lie in a wall, which both adjoining pieces would then miss. For
 * use by one thread.
 */
public final class ArcLine {
    private static final double GOLDEN = 0.3819660112501051;

    private double fromX;
    private double fromY;
    private double fromZ;
    private double alongX;
    private double alongY;
    private double alongZ;
    private double length;
    private double curvature;
    private double lowered;

    /** The number of ends of pieces that lie between the two points. */
    private int corners;

    /**
     * Sets the arc from one point to another.
     *
     * @param bending curvature of the arc, 1/m: {@link PathCurvature#along} in the direction in which the sound
     *     travels, from the first point to the second or the reverse
     * @param isBelow whether the pieces of an arc that bends up run just below it, so that they meet a surface that the
     *     arc only grazes
     */
    public void lay(double x, double y, double z, double toX, double toY, double toZ, double bending, boolean isBelow) {
        fromX = x;
        fromY = y;
        fromZ = z;
        alongX = toX - x;
        alongY = toY - y;
        alongZ = toZ - z;
        length = Math.sqrt(alongX * alongX + alongY * alongY + alongZ * alongZ);
        curvature = bending;
        int parts = PathCurvature.pieces(bending, length);
        corners = parts == 1 ? 0 : parts;
        double part = length / parts;
        lowered = isBelow ? Math.max(0.0, PathCurvature.sag(bending, part, 0.5 * part)) : 0.0;
    }

    /** The length of the straight line between the two points, m. */
    public double length() {
        return length;
    }

    /** The number of pieces; 1 if the arc is straight enough. */
    public int pieces() {
        return corners + 1;
    }

    /** The x coordinate of the end of a piece, m; the end of piece -1 is the first point. */
    public double x(int piece) {
        return fromX + share(piece) * alongX;
    }

    /** The y coordinate of the end of a piece, m. */
    public double y(int piece) {
        return fromY + share(piece) * alongY;
    }

    /** The z coordinate of the end of a piece, m. */
    public double z(int piece) {
        double share = share(piece);
        double sag =
                piece < 0 || piece == corners ? 0.0 : PathCurvature.sag(curvature, length, share * length) + lowered;
        return fromZ + share * alongZ - sag;
    }

    private double share(int piece) {
        return piece < 0 ? 0.0 : piece == corners ? 1.0 : (piece + 1 - GOLDEN) / corners;
    }
}
