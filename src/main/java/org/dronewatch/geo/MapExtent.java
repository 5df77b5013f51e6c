package org.dronewatch.geo;

import java.util.Locale;
import java.util.Optional;
import org.dronewatch.setting.InputException;

/**
 * The smallest rectangle on a map that contains all points of a file, for messages about a file that does not reach a
 * site. It is empty if there are no points. Immutable.
 *
 * @param west least x, in the unit of the map
 * @param east greatest x
 * @param south least y
 * @param north greatest y
 */
public record MapExtent(double west, double east, double south, double north) {
    /** Points along a side that are transformed, since a side is curved in longitude and latitude. */
    private static final int STEPS = 4;

    /** More than any longitude or latitude, as long as neither runs on beyond the date line. */
    private static final double DEGREES = 180.0;

    /** Less than the coordinates of any place in most grids, whose false origin lies far outside of their area. */
    private static final double SMALL = 10_000.0;

    /** Metres in a degree of latitude, roughly. */
    private static final double DEGREE = 111_000.0;

    /** Collects points, one by one. For use by one thread. */
    public static final class Collector {
        private double west = Double.POSITIVE_INFINITY;
        private double east = Double.NEGATIVE_INFINITY;
        private double south = Double.POSITIVE_INFINITY;
        private double north = Double.NEGATIVE_INFINITY;

        /** Adds a point. */
        public void add(double x, double y) {
            west = Math.min(west, x);
            east = Math.max(east, x);
            south = Math.min(south, y);
            north = Math.max(north, y);
        }

        /** The extent of the points added so far. */
        public MapExtent extent() {
            return new MapExtent(west, east, south, north);
        }
    }

    /** Whether there are no points. */
    public boolean isEmpty() {
        return !(west <= east && south <= north);
    }

    private boolean contains(double x, double y, double margin) {
        return x >= west - margin && x <= east + margin && y >= south - margin && y <= north + margin;
    }

    /**
     * Where the points are, as the end of a sentence: in latitude and longitude and, for a grid, in its coordinates as
     * well.
     *
     * @param map transform of the map from which the points come
     */
    public String inWords(MapTransform map) {
        if (isEmpty()) {
            return "it has no coordinates";
        }
        if (map.crs().isGeographic()) {
            return "it covers " + earth(this);
        }
        String grid = String.format(
                Locale.ROOT,
                "it covers %.1f to %.1f east and %.1f to %.1f north in %s",
                west,
                east,
                south,
                north,
                map.crs());
        return onEarth(map).map(earth -> grid + ", " + earth(earth)).orElse(grid);
    }

    private static String earth(MapExtent degrees) {
        return String.format(
                Locale.ROOT,
                "latitude %.5f to %.5f and longitude %.5f to %.5f",
                degrees.south + 0.0,
                degrees.north + 0.0,
                degrees.west + 0.0,
                degrees.east + 0.0);
    }

    /** The extent in degrees; empty if the grid has no coordinates there. */
    private Optional<MapExtent> onEarth(MapTransform map) {
        Collector earth = new Collector();
        try {
            for (int i = 0; i <= STEPS; i++) {
                for (int j = 0; j <= STEPS; j++) {
                    GeoPoint point =
                            map.onEarth(west + (east - west) * i / STEPS, south + (north - south) * j / STEPS, 0.0);
                    earth.add(point.longitude(), point.latitude());
                }
            }
        } catch (InputException e) {
            return Optional.empty();
        }
        return Optional.of(earth.extent());
    }

    /**
     * Why a site may lie outside this extent: its coordinates or those of the file are swapped, belong to another
     * system, or have no reference to the earth. Begins with a semicolon; empty if nothing suggests a mistake.
     *
     * @param map transform of the map from which the points come
     * @param origin origin of the site
     * @param near distance from the site that counts as close, m
     * @param whose words that state whose latitude and longitude may be swapped, such as {@code of the origin}
     */
    public String suspicion(MapTransform map, Origin origin, double near, String whose) {
        if (isEmpty()) {
            return "";
        }
        boolean isGrid = !map.crs().isGeographic();
        if (isGrid && Math.max(-west, east) <= DEGREES && Math.max(-south, north) <= DEGREES / 2.0) {
            return "; these coordinates seem to be longitude and latitude, for which crs is EPSG:4326";
        }
        if (isGrid && Math.max(-west, east) < SMALL && Math.max(-south, north) < SMALL) {
            return "; coordinates this small suggest that the file is not georeferenced";
        }
        double margin = isGrid ? near / map.crs().unitLength() : near / DEGREE;
        return onMap(map, origin)
                .filter(here -> !contains(here.x(), here.y(), margin) && contains(here.y(), here.x(), margin))
                .map(here -> isGrid
                        ? "; x and y in the file seem to be swapped"
                        : "; latitude and longitude " + whose + " seem to be swapped")
                .orElse("");
    }

    private static Optional<MapPoint> onMap(MapTransform map, Origin origin) {
        try {
            return Optional.of(map.onMap(
                    new GeoPoint(Math.toDegrees(origin.longitude()), Math.toDegrees(origin.latitude()), 0.0)));
        } catch (InputException e) {
            return Optional.empty();
        }
    }
}
