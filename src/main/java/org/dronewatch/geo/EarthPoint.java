package org.dronewatch.geo;

import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * A point in plan view, given by latitude and longitude (WGS 84); scene files can state it instead of a pair of east
 * and north coordinates.
 *
 * @param latitude latitude, north of the equator, rad
 * @param longitude longitude, east of Greenwich, rad
 */
public record EarthPoint(
        @In(value = Quantity.ANGLE, from = -Math.PI / 2, to = Math.PI / 2) double latitude,
        @In(value = Quantity.ANGLE, from = -Math.PI, to = Math.PI) double longitude) {
    /** Checks the limits. */
    public EarthPoint {
        Limits.check(EarthPoint.class, latitude, longitude);
    }
}
