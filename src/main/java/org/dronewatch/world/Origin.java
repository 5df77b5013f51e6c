package org.dronewatch.world;

import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * Where on earth the world's origin lies (WGS 84): what ties results to a map.
 *
 * @param latitude north of the equator, rad
 * @param longitude east of Greenwich, rad
 */
public record Origin(
        @In(value = Quantity.ANGLE, from = -Math.PI / 2, to = Math.PI / 2) double latitude,
        @In(value = Quantity.ANGLE, from = -Math.PI, to = Math.PI) double longitude) {
    /** Checks the limits. */
    public Origin {
        Limits.check(Origin.class, latitude, longitude);
    }
}
