package org.dronewatch.world;

/**
 * Illuminance under a clear sky. By day: direct normal illuminance {@code 127.5 klx exp(-0.21 m)} and diffuse
 * horizontal illuminance {@code (0.8 + 15.5 sqrt(sin h)) klx} (IESNA Lighting Handbook, 9th ed., ch. 8), where h is the
 * elevation of the sun and m the air mass of Kasten and Young (Applied Optics 28, 1989, 4735). After sunset: 3.4, 0.008
 * and 0.00065 lx with the sun at 6, 12 and 18 degrees below the horizon, the ends of civil, nautical and astronomical
 * twilight (Seidelmann, ed., Explanatory Supplement to the Astronomical Almanac, 1992, sect. 9.33), interpolated
 * logarithmically between them.
 */
public final class ClearSky {
    private static final double OUTSIDE = 127_500.0;
    private static final double EXTINCTION = 0.21;
    private static final double AT_SUNSET = 800.0;
    private static final double FROM_ABOVE = 15_500.0;
    private static final double TWILIGHT = Math.toRadians(6.0);

    /** Illuminance at sunset and at the ends of the three twilights, lx. */
    private static final double[] EVENING = {AT_SUNSET, 3.4, 0.008, 0.00065};

    private ClearSky() {}

    /**
     * Illuminance of level ground from sun and sky together, lx.
     *
     * @param elevation elevation of the sun above the horizon, rad; negative below it
     */
    public static double illuminance(double elevation) {
        if (elevation > 0.0) {
            return direct(elevation) * Math.sin(elevation) + diffuse(elevation);
        }
        double place = Math.min(EVENING.length - 1.0, -elevation / TWILIGHT);
        int stage = Math.min(EVENING.length - 2, (int) place);
        return EVENING[stage] * Math.pow(EVENING[stage + 1] / EVENING[stage], place - stage);
    }

    /**
     * Illuminance of a surface that faces the sun, from the sun alone, lx.
     *
     * @param elevation elevation of the sun above the horizon, above 0, rad
     */
    public static double direct(double elevation) {
        return OUTSIDE * Math.exp(-EXTINCTION * airMass(elevation));
    }

    /**
     * Illuminance of level ground from the sky alone, lx.
     *
     * @param elevation elevation of the sun above the horizon, above 0, rad
     */
    public static double diffuse(double elevation) {
        return AT_SUNSET + FROM_ABOVE * Math.sqrt(Math.sin(elevation));
    }

    /**
     * The relative air mass along the path of light that arrives from an elevation: 1 at the zenith.
     *
     * @param elevation elevation above the horizon, rad; below the horizon, the air mass of the horizon is used
     */
    public static double airMass(double elevation) {
        double above = Math.max(0.0, elevation);
        return 1.0 / (Math.sin(above) + 0.50572 * Math.pow(Math.toDegrees(above) + 6.07995, -1.6364));
    }
}
