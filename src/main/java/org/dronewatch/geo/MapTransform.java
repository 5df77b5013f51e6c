package org.dronewatch.geo;

import java.util.Locale;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.InputException;
import org.locationtech.proj4j.CoordinateTransform;
import org.locationtech.proj4j.CoordinateTransformFactory;
import org.locationtech.proj4j.Proj4jException;
import org.locationtech.proj4j.ProjCoordinate;

/**
 * Transforms points from a map to the world frame and back, in double precision: from the map's coordinates to
 * longitude and latitude, to earth-centred coordinates, and to east, north and up from the scene's origin. It thus
 * allows for the angle between grid north and true north, for the scale of the grid, and for the curvature of the
 * earth, by which ground 5 km away is 2 m lower; subtracting map coordinates would ignore all three.
 *
 * <p>Heights are above sea level, and unchanged by a change of datum. For use by one thread.
 */
public final class MapTransform {
    /** Limit of the heights that are transformed, m. */
    private static final double HIGHEST = 1e9;

    /** How well both directions must agree: far below a micrometre, in metres, feet or degrees. */
    private static final double METRES = 1e-8;

    private static final double DEGREES = 1e-13;

    private static final int MOST_STEPS = 8;

    private static final double FULL_TURN = 360.0;

    private final CoordinateReferenceSystem crs;
    private final Geodesy geodesy;
    private final CoordinateTransform toEarth;
    private final CoordinateTransform toMap;
    private final ProjCoordinate from = new ProjCoordinate();
    private final ProjCoordinate to = new ProjCoordinate();

    /**
     * A transform between a map and the world frame of a scene.
     *
     * @param crs coordinate reference system of the map
     * @param origin origin of the scene
     */
    public MapTransform(CoordinateReferenceSystem crs, Origin origin) {
        CoordinateTransformFactory factory = new CoordinateTransformFactory();
        this.crs = crs;
        this.geodesy = new Geodesy(origin);
        this.toEarth = factory.createTransform(
                crs.system(), CoordinateReferenceSystem.wgs84().system());
        this.toMap = factory.createTransform(CoordinateReferenceSystem.wgs84().system(), crs.system());
    }

    /** The system of the map's coordinates. */
    public CoordinateReferenceSystem crs() {
        return crs;
    }

    /**
     * The longitude and latitude (WGS 84) of a point of the map.
     *
     * @param x eastward coordinate, in the unit of the system
     * @param y northward coordinate, in the unit of the system
     * @param height height, m; unchanged
     * @throws InputException when the point is outside the domain of the system
     */
    public GeoPoint onEarth(double x, double y, double height) {
        toEarth(x, y);
        return new GeoPoint(to.x, to.y, height);
    }

    /**
     * The position in the world frame of a point of the map, m.
     *
     * @param x eastward coordinate, in the unit of the system
     * @param y northward coordinate, in the unit of the system
     * @param height height above the datum of the origin's height, -1e9 to 1e9 m; if that height is not known, the
     *     origin counts as lying at a height of 0
     * @throws InputException when the point is outside the domain of the system, or the height out of its range
     */
    public Position inWorld(double x, double y, double height) {
        if (!(Math.abs(height) <= HIGHEST)) {
            throw new InputException("point (" + x + ", " + y + ") has a height of " + height + " m but must be within "
                    + HIGHEST + " m");
        }
        toEarth(x, y);
        return geodesy.inWorld(Math.toRadians(to.y), Math.toRadians(to.x), height);
    }

    /**
     * The map coordinates of a position in the world frame.
     *
     * @param position the position, m
     * @throws InputException when the point is outside the domain of the system
     */
    public MapPoint onMap(Position position) {
        return onMap(geodesy.onEarth(position));
    }

    /**
     * The map coordinates of a longitude and latitude (WGS 84); the height is unchanged.
     *
     * @throws InputException when the point is outside the domain of the system
     */
    public MapPoint onMap(GeoPoint place) {
        transform(toMap, place.longitude(), place.latitude());
        return new MapPoint(to.x, to.y, place.height());
    }

    /**
     * Longitude and latitude of a point of the map. PROJ4J's inverse formulas are series, some of which end early, at
     * 0.3 mm for the equal-area projection of Europe: the forward formula, which is exact, corrects them.
     */
    private void toEarth(double x, double y) {
        if (crs.isGeographic() && (Math.abs(x) > FULL_TURN || Math.abs(y) > FULL_TURN / 4.0)) {
            throw new InputException(beyond(x, y));
        }
        double tolerance = crs.isGeographic() ? DEGREES : METRES;
        double triedX = x;
        double triedY = y;
        double former = Double.POSITIVE_INFINITY;
        for (int step = 0; step < MOST_STEPS; step++) {
            transform(toEarth, triedX, triedY);
            double longitude = to.x;
            double latitude = to.y;
            transform(toMap, longitude, latitude);
            double offX = x - (crs.isGeographic() ? nearest(to.x, x) : to.x);
            double offY = y - to.y;
            double off = Math.hypot(offX, offY);
            to.x = longitude;
            to.y = latitude;
            if (off <= tolerance || off >= former && former <= 100.0 * tolerance) {
                return;
            }
            former = off;
            triedX += offX;
            triedY += offY;
        }
        throw new InputException(beyond(x, y));
    }

    /** PROJ4J would take what lies beyond the date line for the date line. */
    private static double withinHalfATurn(double longitude) {
        return Math.abs(longitude) <= FULL_TURN / 2.0 ? longitude : nearest(longitude, 0.0);
    }

    /** A longitude as many whole turns away as makes it nearest to another one. */
    private static double nearest(double longitude, double other) {
        return longitude + FULL_TURN * Math.rint((other - longitude) / FULL_TURN);
    }

    private void transform(CoordinateTransform transform, double x, double y) {
        from.x = transform == toMap || crs.isGeographic() ? withinHalfATurn(x) : x;
        from.y = y;
        from.z = Double.NaN;
        try {
            transform.transform(from, to);
        } catch (Proj4jException | IllegalStateException e) {
            throw new InputException(beyond(x, y), e);
        }
        if (!Double.isFinite(to.x) || !Double.isFinite(to.y)) {
            throw new InputException(beyond(x, y));
        }
    }

    private String beyond(double x, double y) {
        return String.format(Locale.ROOT, "point (%.6f, %.6f) lies where %s has no coordinates", x, y, crs);
    }
}
