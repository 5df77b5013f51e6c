package org.dronewatch.report.map;

import java.awt.Color;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.dronewatch.geo.Geodesy;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;

/**
 * A map of routes for map viewers: lines coloured by exposure, in a folder for each route. Longitude and latitude (WGS
 * 84) are in degrees; the bytes depend only on the routes.
 */
public final class RouteMap {
    private final String scene;
    private final Origin origin;
    private final Geodesy geodesy;
    private final List<Piece> pieces;

    /**
     * A piece of a route.
     *
     * @param route name of the route and of its folder
     * @param exposure the exposure on the piece, in words
     * @param mode the mode in which the piece is flown
     * @param points two or more, m
     * @param colour colour of the line
     * @param begin when the drone is at the first point, s since the start of the route
     * @param end when the drone is at the last point, s since the start of the route
     * @param detection probability that the drone has been detected by the end of the piece, 0 to 1
     */
    public record Piece(
            String route,
            String exposure,
            String mode,
            List<Position> points,
            Color colour,
            double begin,
            double end,
            double detection) {
        /** Copies the list. */
        public Piece {
            points = List.copyOf(points);
        }
    }

    /**
     * A map.
     *
     * @param scene name of the scene
     * @param pieces pieces of all routes, in the order in which they are flown
     */
    public RouteMap(String scene, Origin origin, List<Piece> pieces) {
        this.scene = scene;
        this.origin = origin;
        this.geodesy = new Geodesy(origin);
        this.pieces = List.copyOf(pieces);
    }

    /** Writes the map as GeoJSON (RFC 7946). */
    public void writeGeoJson(Path file) throws IOException {
        new GeoJson(new Lines()).write(file);
    }

    /** Writes the map as KML 2.2. */
    public void writeKml(Path file) throws IOException {
        new Kml(new Lines()).write(file);
    }

    private StyledFeature feature(Piece piece) {
        Properties properties = new Properties()
                .put("chance_per_second", piece.exposure())
                .put("mode", piece.mode())
                .put("begin_s", piece.begin())
                .put("end_s", piece.end())
                .put("detected_by_then", piece.detection());
        return new StyledFeature(
                Role.FLIGHT,
                piece.route(),
                piece.route() + ": " + piece.exposure(),
                new Shape.Line(piece.points().stream().map(geodesy::at).toList()),
                piece.colour(),
                properties.values());
    }

    private final class Lines implements DrawnFeatures {
        @Override
        public String title() {
            return scene + ": weakest routes";
        }

        @Override
        public String description() {
            return "For each direction, the route on which the sensors are least likely to detect the drone in time;"
                    + " the darker a line, the higher the chance of a detection within a second.";
        }

        @Override
        public List<StyledFeature> features() {
            return pieces.stream().map(RouteMap.this::feature).toList();
        }

        @Override
        public List<String> folders() {
            return pieces.stream().map(Piece::route).distinct().toList();
        }

        @Override
        public boolean isInSpace() {
            return origin.height().isPresent();
        }
    }
}
