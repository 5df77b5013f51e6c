package org.dronewatch.flight.file;

import org.dronewatch.geo.Geodesy;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;

/** Where the flights of test files are flown: near the equator, where 1e-5 degrees are 1.1 m in both directions. */
public final class EquatorSite {
    public static final Origin ORIGIN =
            Origin.at(Math.toRadians(1.0), Math.toRadians(2.0)).withHeight(100.0);

    private EquatorSite() {}

    /** A position in the world frame by latitude and longitude, deg, and height above sea level, m. */
    public static Position at(double latitude, double longitude, double heightAboveTheSea) {
        return new Geodesy(ORIGIN).inWorld(Math.toRadians(latitude), Math.toRadians(longitude), heightAboveTheSea);
    }
}
