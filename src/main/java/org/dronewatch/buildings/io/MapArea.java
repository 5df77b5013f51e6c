package org.dronewatch.buildings.io;

import org.dronewatch.geo.GeoPoint;
import org.dronewatch.geo.Geodesy;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;

/**
 * The part of a map around a site; features outside it need not be kept in memory.
 *
 * @param west least longitude, degrees
 * @param east greatest longitude, degrees; beyond 180 where the area contains the date line
 * @param south least latitude, degrees
 * @param north greatest latitude, degrees
 */
public record MapArea(double west, double east, double south, double north) {
    private static final double FULL_TURN = 360.0;

    /**
     * The square around an origin.
     *
     * @param half half the length of a side, m
     */
    public static MapArea about(Origin origin, double half) {
        Geodesy geodesy = new Geodesy(origin);
        double west = Double.POSITIVE_INFINITY;
        double east = Double.NEGATIVE_INFINITY;
        double south = Double.POSITIVE_INFINITY;
        double north = Double.NEGATIVE_INFINITY;
        for (int i = -1; i <= 1; i++) {
            for (int j = -1; j <= 1; j++) {
                GeoPoint corner = geodesy.onEarth(new Position(i * half, j * half, 0.0));
                west = Math.min(west, corner.longitude());
                east = Math.max(east, corner.longitude());
                south = Math.min(south, corner.latitude());
                north = Math.max(north, corner.latitude());
            }
        }
        return new MapArea(west, east, south, north);
    }

    /** Whether this area contains the point with this longitude and latitude, degrees. */
    public boolean contains(double longitude, double latitude) {
        double turned = longitude + FULL_TURN * Math.ceil((west - longitude) / FULL_TURN);
        return latitude >= south && latitude <= north && turned <= east;
    }
}
