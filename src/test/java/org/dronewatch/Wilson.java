package org.dronewatch;

/** Wilson's interval of a share (Wilson 1927). */
public final class Wilson {
    private Wilson() {}

    /** Its lower and upper end. */
    public static double[] interval(int hits, int of, double z) {
        double share = (double) hits / of;
        double middle = share + z * z / (2.0 * of);
        double half = z * Math.sqrt(share * (1.0 - share) / of + z * z / (4.0 * of * of));
        double scale = 1.0 + z * z / of;
        return new double[] {(middle - half) / scale, (middle + half) / scale};
    }
}
