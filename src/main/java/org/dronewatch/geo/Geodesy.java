package org.dronewatch.geo;

import org.dronewatch.geometry.Position;

/**
 * Converts positions in the world frame (x east, y north, z up, m) to latitude and longitude on the WGS 84 ellipsoid,
 * and back. At the scene's origin the frame is tangent to a surface that lies above the ellipsoid by the origin's
 * height; an origin without a known height is assumed to lie on the ellipsoid. If its true height is 1000 m, this
 * assumption displaces a point 1 km away by 0.16 m on the map.
 *
 * <p>East, north and up are converted to earth-centred coordinates without any approximation, and these to latitude and
 * longitude (IOGP Publication 373-7-2, Geomatics Guidance Note 7, part 2, methods 9837 and 9602). The formula for the
 * latitude is Bowring's (Transformation from spatial to geographical coordinates, Survey Review 23, 1976), iterated
 * until it is exact to rounding. Semi-major axis and flattening are those of WGS 84 (NIMA TR8350.2). Immutable.
 */
public final class Geodesy {
    private static final double SEMI_MAJOR = 6_378_137.0;
    private static final double FLATTENING = 1.0 / 298.257223563;
    private static final double SEMI_MINOR = SEMI_MAJOR * (1.0 - FLATTENING);

    /** First eccentricity squared. */
    private static final double E2 = FLATTENING * (2.0 - FLATTENING);

    /** Second eccentricity squared. */
    private static final double EP2 = E2 / (1.0 - E2);

    /** One gives millimetres for positions up to some kilometres high, each further one thousands of times better. */
    private static final int ITERATIONS = 4;

    private final double longitude;
    private final double sinLatitude;
    private final double cosLatitude;
    private final double originOut;
    private final double originUp;
    private final double height;

    /** The geodesy of a world frame with this origin. */
    public Geodesy(Origin origin) {
        height = origin.height().orElse(0.0);
        longitude = origin.longitude();
        sinLatitude = Math.sin(origin.latitude());
        cosLatitude = Math.cos(origin.latitude());
        double normal = SEMI_MAJOR / Math.sqrt(1.0 - E2 * sinLatitude * sinLatitude);
        originOut = (normal + height) * cosLatitude;
        originUp = (normal * (1.0 - E2) + height) * sinLatitude;
    }

    /**
     * The position of a point on earth in the world frame (IOGP 373-7-2, methods 9602 and 9837, forward).
     *
     * @param latitude north of the equator, rad
     * @param theLongitude longitude east of Greenwich, rad
     * @param above height above the ellipsoid, m; the origin is taken to lie above the ellipsoid by its own height, or
     *     by 0 if that is not known
     */
    public Position inWorld(double latitude, double theLongitude, double above) {
        double sin = Math.sin(latitude);
        double cos = Math.cos(latitude);
        double normal = SEMI_MAJOR / Math.sqrt(1.0 - E2 * sin * sin);
        double fromAxis = (normal + above) * cos;
        double turned = theLongitude - longitude;
        double out = fromAxis * Math.cos(turned) - originOut;
        double up = (normal * (1.0 - E2) + above) * sin - originUp;
        return new Position(
                fromAxis * Math.sin(turned),
                cosLatitude * up - sinLatitude * out,
                cosLatitude * out + sinLatitude * up);
    }

    /**
     * The map point of a position in the world frame; its height is z plus the height of the origin.
     *
     * <p>Longitudes continue from that of the origin: beyond the date line they exceed 180 or fall below -180 degrees,
     * so that lines and areas are not split. Points near the poles are correct, but areas around a pole are not areas
     * on a map of longitude and latitude.
     *
     * @param position position, m
     */
    public GeoPoint at(Position position) {
        GeoPoint place = onEarth(position);
        return new GeoPoint(place.longitude(), place.latitude(), position.z() + height);
    }

    /**
     * The point on earth of a position in the world frame, with its height above the ellipsoid; the origin is taken to
     * lie above the ellipsoid by its own height, or by 0 if that is not known. The inverse of {@link #inWorld} to a
     * micrometre within 100 km; longitudes continue from that of the origin. The formula for the height is Bowring's
     * (The accuracy of geodetic latitude and height equations, Survey Review 28, 1985).
     *
     * @param position position, m
     */
    public GeoPoint onEarth(Position position) {
        // Coordinates that turn with the earth: out along the origin's meridian, east of it, and along the axis.
        double out = originOut - sinLatitude * position.y() + cosLatitude * position.z();
        double east = position.x();
        double up = originUp + cosLatitude * position.y() + sinLatitude * position.z();
        double fromAxis = Math.hypot(out, east);
        double reduced = Math.atan2(SEMI_MAJOR * up, SEMI_MINOR * fromAxis);
        double latitude = 0.0;
        for (int i = 0; i < ITERATIONS; i++) {
            double sin = Math.sin(reduced);
            double cos = Math.cos(reduced);
            latitude =
                    Math.atan2(up + EP2 * SEMI_MINOR * sin * sin * sin, fromAxis - E2 * SEMI_MAJOR * cos * cos * cos);
            reduced = Math.atan2(SEMI_MINOR * Math.sin(latitude), SEMI_MAJOR * Math.cos(latitude));
        }
        double sin = Math.sin(latitude);
        double above = fromAxis * Math.cos(latitude) + up * sin - SEMI_MAJOR * Math.sqrt(1.0 - E2 * sin * sin);
        return new GeoPoint(Math.toDegrees(longitude + Math.atan2(east, out)), Math.toDegrees(latitude), above);
    }
}
