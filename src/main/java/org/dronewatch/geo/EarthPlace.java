package org.dronewatch.geo;

import java.util.Optional;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * A place given by latitude and longitude (WGS 84); scene files can state it instead of a position:
 * {@code {latitude: 43.7314 deg, longitude: 7.4202 deg, above: 10 m}}. Without {@code above} and {@code height}, it
 * lies on the highest surface there.
 *
 * @param latitude latitude, north of the equator, rad
 * @param longitude longitude, east of Greenwich, rad
 * @param above height above the highest surface there (ground, roof or tree), 0 to 100,000, m
 * @param height height above sea level, measured from the same level as the height of the origin, -100,000 to
 *     100,000, m
 */
public record EarthPlace(
        @In(value = Quantity.ANGLE, from = -Math.PI / 2, to = Math.PI / 2) double latitude,
        @In(value = Quantity.ANGLE, from = -Math.PI, to = Math.PI) double longitude,
        @In(value = Quantity.LENGTH, from = 0, to = In.FARTHEST) Optional<Double> above,
        @In(value = Quantity.LENGTH, from = -In.FARTHEST, to = In.FARTHEST) Optional<Double> height) {
    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range, or there are two heights
     */
    public EarthPlace {
        Limits.check(EarthPlace.class, latitude, longitude, above, height);
        if (above.isPresent() && height.isPresent()) {
            throw new IllegalArgumentException("above and height are mutually exclusive: omit one of them");
        }
    }

    /**
     * A place on the highest surface.
     *
     * @param latitude latitude, north of the equator, rad
     * @param longitude longitude, east of Greenwich, rad
     */
    @Defaults({"latitude", "longitude"})
    public static EarthPlace at(double latitude, double longitude) {
        return new EarthPlace(latitude, longitude, Optional.empty(), Optional.empty());
    }
}
