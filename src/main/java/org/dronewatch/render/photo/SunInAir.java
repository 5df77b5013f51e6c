package org.dronewatch.render.photo;

/** The fraction of sunlight that reaches a point in {@link ClearAir}, tabulated once. Immutable. */
final class SunInAir {
    private static final int HEIGHTS = 48;
    private static final int ELEVATIONS = 160;
    private static final int STEPS = 32;
    private static final int COLUMNS = 3;

    /** Columns of air, haze and ozone by height and elevation of the sun above the horizon as seen from there. */
    private static final float[] TABLE = table();

    private SunInAir() {}

    private static float[] table() {
        float[] table = new float[HEIGHTS * ELEVATIONS * COLUMNS];
        AirPath path = new AirPath();
        int at = 0;
        for (int i = 0; i < HEIGHTS; i++) {
            double root = i / (HEIGHTS - 1.0);
            double height = ClearAir.TOP * root * root;
            double horizon = ClearAir.horizon(height);
            for (int k = 0; k < ELEVATIONS; k++) {
                double share = k / (ELEVATIONS - 1.0);
                // A hair above the horizon, so that rounding puts no ground in the way.
                path.start(height, Math.min(1.0, horizon + (1.0 - horizon) * share * share + 1e-12), STEPS);
                while (path.next()) {
                    table[at] += (float) (path.length() * path.air());
                    table[at + 1] += (float) (path.length() * path.haze());
                    table[at + 2] += (float) (path.length() * path.ozone());
                }
                at += COLUMNS;
            }
        }
        return table;
    }

    /**
     * Writes the fraction for each channel; 0 where the earth is in between.
     *
     * @param height height of the point, km, 0 to {@link ClearAir#TOP}
     * @param up sine of the sun's elevation
     */
    static void write(double height, double up, double[] rgb) {
        double horizon = ClearAir.horizon(height);
        if (up < horizon) {
            rgb[0] = 0.0;
            rgb[1] = 0.0;
            rgb[2] = 0.0;
            return;
        }
        double row = Math.sqrt(Math.min(1.0, height / ClearAir.TOP)) * (HEIGHTS - 1);
        double column = Math.sqrt((up - horizon) / (1.0 - horizon)) * (ELEVATIONS - 1);
        int i = Math.min(HEIGHTS - 2, (int) row);
        int k = Math.min(ELEVATIONS - 2, (int) column);
        double v = row - i;
        double u = column - k;
        int at = (i * ELEVATIONS + k) * COLUMNS;
        double air = mixed(at, u, v);
        double haze = mixed(at + 1, u, v);
        double ozone = mixed(at + 2, u, v);
        for (int channel = 0; channel < Daylight.CHANNELS; channel++) {
            rgb[channel] = Math.exp(-ClearAir.depth(channel, air, haze, ozone));
        }
    }

    private static double mixed(int at, double u, double v) {
        int next = at + ELEVATIONS * COLUMNS;
        double lower = TABLE[at] + u * (TABLE[at + COLUMNS] - TABLE[at]);
        return lower + v * (TABLE[next] + u * (TABLE[next + COLUMNS] - TABLE[next]) - lower);
    }
}
