package org.dronewatch.geo;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.List;

/**
 * A point on a map (WGS 84).
 *
 * @param longitude east of Greenwich, degrees
 * @param latitude north of the equator, degrees
 * @param height height above the sea or, from {@link Geodesy#onEarth}, above the ellipsoid, m; above the level of the
 *     scene's origin if the origin's height is not known
 */
public record GeoPoint(double longitude, double latitude, double height) {
    /** A millimetre on the ground. */
    private static final int DECIMALS_OF_DEGREES = 8;

    private static final int DECIMALS_OF_METRES = 3;

    /** Longitude and latitude in degrees, rounded for files, in the order of GeoJSON and KML. */
    public List<BigDecimal> onPlan() {
        return List.of(rounded(longitude, DECIMALS_OF_DEGREES), rounded(latitude, DECIMALS_OF_DEGREES));
    }

    /** Longitude and latitude in degrees and the height in metres, rounded for files. */
    public List<BigDecimal> inSpace() {
        return List.of(
                rounded(longitude, DECIMALS_OF_DEGREES),
                rounded(latitude, DECIMALS_OF_DEGREES),
                rounded(height, DECIMALS_OF_METRES));
    }

    /** A finite number, rounded to at most this number of decimals, without trailing zeros. */
    public static BigDecimal rounded(double value, int decimals) {
        BigDecimal shortest = BigDecimal.valueOf(value)
                .setScale(decimals, RoundingMode.HALF_EVEN)
                .stripTrailingZeros();
        return shortest.scale() < 0 ? shortest.setScale(0) : shortest;
    }
}
