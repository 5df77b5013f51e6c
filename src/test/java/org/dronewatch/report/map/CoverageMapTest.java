package org.dronewatch.report.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Color;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.analysis.survey.Gap;
import org.dronewatch.analysis.survey.GapMap;
import org.dronewatch.geo.GeoPoint;
import org.dronewatch.geo.Geodesy;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.locationtech.jts.algorithm.Orientation;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.io.geojson.GeoJsonReader;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** The gaps of a coverage as areas on the map. */
class CoverageMapTest {
    private static final FieldGrid GRID = new FieldGrid(10, -20, 340, 20, List.of(2.0, 60.5));
    private static final Origin ORIGIN = new Origin(Math.toRadians(43.7), Math.toRadians(7.4), Optional.empty());

    @TempDir
    private static Path directory;

    private static FieldCoverage coverage;
    private static JsonNode map;

    @BeforeAll
    static void write() throws IOException {
        coverage = new FieldCoverage(
                FieldSite.in(directory, FieldSite.ROUND).field(GRID, 2), FieldCoverage.Choice.BEST, 0.5);
        CoverageMap gaps = new CoverageMap(
                coverage, "A <\"site\"> & more", ORIGIN, cause -> new CoverageMap.CauseStyle("by " + cause, Color.RED));
        gaps.writeGeoJson(directory.resolve("coverage.geojson"));
        gaps.writeKml(directory.resolve("coverage.kml"));
        map = JsonMapper.builder()
                .build()
                .readTree(directory.resolve("coverage.geojson").toFile());
    }

    private static List<JsonNode> features(double height) {
        List<JsonNode> features = new ArrayList<>();
        for (JsonNode feature : map.get("features")) {
            if (feature.get("properties").get("height_above_ground_m").asDouble() == height) {
                features.add(feature);
            }
        }
        return features;
    }

    /** The middle of each cell is in an area of its height exactly if it belongs to a gap. */
    @Test
    void theAreasAreTheCellsOfTheGaps() throws Exception {
        Geodesy geodesy = new Geodesy(ORIGIN);
        for (int height = 0; height < 2; height++) {
            GapMap gaps = GapMap.of(coverage, height);
            List<JsonNode> features = features(GRID.heights().get(height));
            assertThat(features).hasSameSizeAs(gaps.gaps());
            for (int gap = 0; gap < features.size(); gap++) {
                Geometry area = new GeoJsonReader()
                        .read(features.get(gap).get("geometry").toString());
                assertThat(area.isValid()).isTrue();
                assertThat(Orientation.isCCW(((Polygon) area).getExteriorRing().getCoordinateSequence()))
                        .as("right-hand rule")
                        .isTrue();
                for (int cell = 0; cell < GRID.cells(); cell++) {
                    int column = cell % GRID.columns();
                    int row = cell / GRID.columns();
                    GeoPoint middle = geodesy.at(new Position(GRID.x(column), GRID.y(row), 0.0));
                    assertThat(area.contains(new GeometryFactory()
                                    .createPoint(new Coordinate(middle.longitude(), middle.latitude()))))
                            .isEqualTo(gaps.contains(gap, column, row));
                }
            }
        }
    }

    @Test
    void theirPropertiesAreThoseOfTheGaps() {
        Gap largest = GapMap.of(coverage, 1).gaps().get(0);
        JsonNode properties = features(60.5).get(0).get("properties");
        assertThat(properties.get("area_m2").asDouble()).isEqualTo(largest.area());
        assertThat(properties.get("cause").asString())
                .isEqualTo(largest.cause()
                        .name()
                        .toLowerCase(java.util.Locale.ROOT)
                        .replace('_', '-'));
        assertThat(properties.get("touches_rim").asBoolean()).isEqualTo(largest.touchesRim());
        assertThat(properties.get("folder").asString()).isEqualTo("Gaps at 60.5 m");
        assertThat(properties.get("name").asString()).startsWith("60.5 m: ").endsWith("ha, by " + largest.cause());
        GeoPoint inner = new Geodesy(ORIGIN).at(new Position(largest.x(), largest.y(), 0.0));
        assertThat(properties.get("innermost_latitude_deg").asDouble()).isCloseTo(inner.latitude(), within(1e-6));
        assertThat(properties.get("innermost_longitude_deg").asDouble()).isCloseTo(inner.longitude(), within(1e-6));
    }

    @Test
    void bothFilesFollowTheirSchemas() throws Exception {
        assertThat(SiteMapTest.schema()
                        .validate(
                                Files.readString(directory.resolve("coverage.geojson")),
                                com.networknt.schema.InputFormat.JSON))
                .isEmpty();
        new KmlSchema().validate(directory.resolve("coverage.kml"));
        assertThat(Files.readString(directory.resolve("coverage.kml")))
                .contains("<name>Gaps at 2 m</name>", "<altitudeMode>relativeToGround</altitudeMode>", ",60.5")
                .doesNotContain("<name>Flights</name>");
    }
}
