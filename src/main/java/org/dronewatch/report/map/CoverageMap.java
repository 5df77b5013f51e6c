package org.dronewatch.report.map;

import java.awt.Color;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.function.Function;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.survey.Gap;
import org.dronewatch.analysis.survey.GapMap;
import org.dronewatch.geo.GeoPoint;
import org.dronewatch.geo.Geodesy;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.sensor.Cause;

/**
 * A map of the gaps in a coverage for map viewers: an area for each gap, in a folder for each height. Longitude and
 * latitude (WGS 84) are in degrees; the bytes depend only on the coverage.
 */
public final class CoverageMap {
    private final FieldCoverage coverage;
    private final String scene;
    private final Geodesy geodesy;
    private final Function<Cause, CauseStyle> styles;

    /**
     * How a cause is shown.
     *
     * @param name name of the cause, in words
     * @param colour the colour of the areas with this cause
     */
    public record CauseStyle(String name, Color colour) {}

    /**
     * A map.
     *
     * @param scene name of the scene
     * @param styles the style of each cause
     */
    public CoverageMap(FieldCoverage coverage, String scene, Origin origin, Function<Cause, CauseStyle> styles) {
        this.coverage = coverage;
        this.scene = scene;
        this.geodesy = new Geodesy(origin);
        this.styles = styles;
    }

    /** Writes the map as GeoJSON (RFC 7946). */
    public void writeGeoJson(Path file) throws IOException {
        new GeoJson(new Gaps()).write(file);
    }

    /** Writes the map as KML 2.2; areas are drawn at their heights above the ground. */
    public void writeKml(Path file) throws IOException {
        new Kml(new Gaps()).write(file);
    }

    /** Gathered anew for each file, since all heights of a large grid would take much memory. */
    private final class Gaps implements DrawnFeatures {
        @Override
        public String title() {
            return scene + ": gaps";
        }

        @Override
        public String description() {
            return "Where no sensor detects the drone, at several heights above the ground, with the main reason. Gaps that"
                    + " touch the edge of the assessed area may continue beyond it.";
        }

        @Override
        public List<StyledFeature> features() {
            List<StyledFeature> features = new ArrayList<>();
            for (int height = 0; height < coverage.field().grid().heights().size(); height++) {
                GapMap map = GapMap.of(coverage, height);
                for (int gap = 0; gap < map.gaps().size(); gap++) {
                    features.add(feature(map, gap));
                }
            }
            return features;
        }

        @Override
        public List<String> folders() {
            return coverage.field().grid().heights().stream()
                    .map(CoverageMap::folder)
                    .toList();
        }

        @Override
        public boolean isInSpace() {
            return false;
        }
    }

    private static String folder(double height) {
        return Role.GAP.folder() + " at " + metres(height);
    }

    private static String metres(double height) {
        return (height == Math.rint(height) ? String.format(Locale.ROOT, "%.0f", height) : Double.toString(height))
                + " m";
    }

    private StyledFeature feature(GapMap map, int number) {
        Gap gap = map.gaps().get(number);
        double height = coverage.field().grid().heights().get(map.height());
        CauseStyle style = styles.apply(gap.cause());
        GeoPoint innermost = geodesy.at(new Position(gap.x(), gap.y(), 0.0));
        Properties properties = new Properties()
                .put("height_above_ground_m", height)
                .put("area_m2", gap.area())
                .put("cause", gap.cause().name().toLowerCase(Locale.ROOT).replace('_', '-'))
                .put("touches_rim", gap.touchesRim())
                .put("innermost_longitude_deg", innermost.longitude())
                .put("innermost_latitude_deg", innermost.latitude());
        return new StyledFeature(
                Role.GAP,
                folder(height),
                String.format(Locale.ROOT, "%s: %s, %s", metres(height), Numbers.area(gap.area()), style.name()),
                new Shape.Area(rings(map, number), OptionalDouble.of(height)),
                style.colour(),
                properties.values());
    }

    private List<List<GeoPoint>> rings(GapMap map, int gap) {
        FieldGrid grid = coverage.field().grid();
        double west = grid.x(0) - 0.5 * grid.cell();
        double north = grid.y(0) + 0.5 * grid.cell();
        return CellRings.of((column, row) -> map.contains(gap, column, row), grid.columns()).stream()
                .map(ring -> ring.stream()
                        .map(corner -> geodesy.at(
                                new Position(west + corner[0] * grid.cell(), north - corner[1] * grid.cell(), 0.0)))
                        .toList())
                .toList();
    }
}
