package org.dronewatch.geo;

import java.util.Optional;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * Geographic position of the scene's origin (WGS 84), so that results can be shown on a map.
 *
 * @param latitude latitude, north of the equator, rad
 * @param longitude longitude, east of Greenwich, rad
 * @param height height above sea level, -500 to 9000 m; omit it if it is not known: KML maps then follow the ground
 */
public record Origin(
        @In(value = Quantity.ANGLE, from = -Math.PI / 2, to = Math.PI / 2) double latitude,
        @In(value = Quantity.ANGLE, from = -Math.PI, to = Math.PI) double longitude,
        @In(value = Quantity.LENGTH, from = -500, to = 9000) Optional<Double> height) {
    /** Checks the limits. */
    public Origin {
        Limits.check(Origin.class, latitude, longitude, height);
    }

    /**
     * An origin whose height is not known.
     *
     * @param latitude latitude, north of the equator, rad
     * @param longitude longitude, east of Greenwich, rad
     */
    @Defaults({"latitude", "longitude"})
    public static Origin at(double latitude, double longitude) {
        return new Origin(latitude, longitude, Optional.empty());
    }

    /** This origin at a known height above sea level, m. */
    public Origin withHeight(double metres) {
        return SettingsForm.with(this, "height", Optional.of(metres));
    }
}
