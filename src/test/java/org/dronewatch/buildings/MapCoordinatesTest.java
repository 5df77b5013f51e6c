package org.dronewatch.buildings;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dronewatch.buildings.io.MapFiles;
import org.dronewatch.geo.CoordinateReferenceSystem;
import org.dronewatch.geo.GeoPoint;
import org.dronewatch.geo.MapPoint;
import org.dronewatch.geo.MapTransform;
import org.dronewatch.geo.Origin;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Maps in longitude and latitude, in national grids, and in what is neither or not stated. */
class MapCoordinatesTest {
    /** A place in the Netherlands, and its coordinates in the national grid, EPSG:28992, by PROJ 9.5.1. */
    private static final double LATITUDE = 51.999;

    private static final double LONGITUDE = 4.3733;
    private static final double EAST = 85373.2714;
    private static final double NORTH = 446110.2645;
    private static final Origin ORIGIN =
            Origin.at(Math.toRadians(LATITUDE), Math.toRadians(LONGITUDE)).withHeight(0.0);

    /** The form of 2008, as ogr2ogr and QGIS write it; OGC's name of longitude and latitude; the form before that. */
    private static final String NAMED = "\"crs\": {\"type\": \"name\", \"properties\": {\"name\": \"%s\"}}, ";

    private static final String RD = String.format(NAMED, "urn:ogc:def:crs:EPSG::28992");

    @TempDir
    private Path directory;

    /** A square with sides of 20 units, from a corner on. */
    private static String square(String crs, double x, double y, double side) {
        return String.format(
                Locale.ROOT,
                "{\"type\": \"FeatureCollection\", %1$s\"features\": [{\"type\": \"Feature\", \"properties\": {\"height\": 10},"
                        + " \"geometry\": {\"type\": \"Polygon\", \"coordinates\":"
                        + " [[[%2$.9f,%3$.9f],[%4$.9f,%3$.9f],[%4$.9f,%5$.9f],[%2$.9f,%5$.9f],[%2$.9f,%3$.9f]]]}}]}",
                crs,
                x,
                y,
                x + side,
                y + side);
    }

    private LoadedBuildings load(String text, Optional<String> crs) throws IOException {
        Files.writeString(directory.resolve("map"), text);
        BuildingSettings settings = BuildingSettings.of("map");
        return new BuildingLoader(directory)
                .load(crs.map(settings::withCrs).orElse(settings), ORIGIN, Optional.empty());
    }

    private static void assertAtOrigin(LoadedBuildings loaded) {
        double[] outer = loaded.outlines().get(0).outer();
        double nearest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < outer.length; i += 2) {
            nearest = Math.min(nearest, Math.hypot(outer[i], outer[i + 1]));
        }
        assertThat(loaded.count()).isEqualTo(1);
        // The tolerance of the grid, as in MapTransformTest.
        assertThat(nearest).isCloseTo(0.0, within(0.01));
        assertThat(loaded.area()).isCloseTo(400.0, within(0.2));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "\"crs\": {\"type\": \"name\", \"properties\": {\"name\": \"urn:ogc:def:crs:EPSG::28992\"}}, ",
                "\"crs\": {\"type\": \"name\", \"properties\": {\"name\": \"urn:ogc:def:crs:EPSG:6.9:28992\"}}, ",
                "\"crs\": {\"type\": \"name\", \"properties\": {\"name\": \"EPSG:28992\"}}, ",
                "\"crs\": {\"type\": \"EPSG\", \"properties\": {\"code\": 28992}}, ",
                "\"crs\": {\"type\": \"link\", \"properties\": {\"href\": \"http://www.opengis.net/def/crs/EPSG/0/28992\"}}, "
            })
    void aGridThatGeoJsonStatesIsUsed(String crs) throws IOException {
        LoadedBuildings loaded = load(square(crs, EAST, NORTH, 20), Optional.empty());
        assertAtOrigin(loaded);
        assertThat(loaded.warnings()).isEmpty();
    }

    /**
     * A house 5005.593 m north of an origin in Bohemia (PROJ 9.5.1, as in MapTransformTest), on a grid whose north is
     * eight degrees off: subtracting coordinates would put it 682 m farther east.
     */
    @Test
    void aGridsNorthIsNotTrueNorth() throws IOException {
        Origin origin = Origin.at(Math.toRadians(50.08), Math.toRadians(14.42)).withHeight(250.0);
        MapPoint corner = new MapTransform(CoordinateReferenceSystem.of("EPSG:5514"), origin)
                .onMap(new GeoPoint(14.42, 50.125, 250.0));
        String crs = String.format(NAMED, "urn:ogc:def:crs:EPSG::5514");
        Files.writeString(directory.resolve("map"), square(crs, corner.x(), corner.y(), 20));
        LoadedBuildings loaded = new BuildingLoader(directory)
                .load(BuildingSettings.of("map").withRadius(6000), origin, Optional.empty());

        double[] outer = loaded.outlines().get(0).outer();
        assertThat(outer[0]).isCloseTo(0.0, within(1e-3));
        assertThat(outer[1]).isCloseTo(5005.593, within(2e-3));
        // True north is to the east of the grid's north, so that the grid's east is to the north of true east.
        assertThat(Math.atan2(outer[3] - outer[1], outer[2] - outer[0]))
                .isCloseTo(Math.asin(682.381 / 5005.593), within(1e-3));
    }

    @Test
    void coordinatesThatAreNoDegreesAskForTheirSystem() throws IOException {
        String text = square("", EAST, NORTH, 20);
        for (Optional<String> crs : List.of(Optional.<String>empty(), Optional.of("EPSG:4258"))) {
            assertThatThrownBy(() -> load(text, crs))
                    .isInstanceOf(InputException.class)
                    .hasMessageMatching(
                            "map: feature/0: corner 0 of an outline is \\[\\d+\\.\\d+,\\d+\\.\\d+\\] but must be longitude"
                                    + " and latitude, -180 to 180 and -90 to 90 degrees: for coordinates of a grid, set crs, as in"
                                    + " crs: EPSG:25832");
        }
        assertAtOrigin(load(text, Optional.of("EPSG:28992")));
        assertThat(new MapFiles(directory).needsCrs("map")).isTrue();
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "urn:ogc:def:crs:OGC:1.3:CRS84", "urn:ogc:def:crs:EPSG::4326", "OGC:CRS84"})
    void longitudeAndLatitudeNeedNoStatement(String name) throws IOException {
        String crs = name.isEmpty() ? "" : String.format(NAMED, name);
        LoadedBuildings loaded = load(square(crs, LONGITUDE, LATITUDE, 2e-4), Optional.empty());
        assertThat(loaded.outlines().get(0).outer()[0]).isCloseTo(0.0, within(1e-3));
        assertThat(new MapFiles(directory).needsCrs("map")).isFalse();
    }

    /** Longitudes may run on beyond the date line, up to a whole turn. */
    @Test
    void oneTurnMoreIsTheSameLongitude() throws IOException {
        assertThat(load(square("", LONGITUDE - 360.0, LATITUDE, 2e-4), Optional.empty())
                        .count())
                .isEqualTo(1);
    }

    @Test
    void theSceneKnowsBetterThanTheFileAndALineSaysSo() throws IOException {
        String wrong = String.format(NAMED, "urn:ogc:def:crs:EPSG::32631");
        assertThat(load(square(RD, EAST, NORTH, 20), Optional.of("EPSG:28992")).warnings())
                .isEmpty();
        LoadedBuildings loaded = load(square(wrong, EAST, NORTH, 20), Optional.of("EPSG:28992"));
        assertAtOrigin(loaded);
        assertThat(loaded.warnings())
                .containsExactly(
                        "map: states urn:ogc:def:crs:EPSG::32631, but is read as EPSG:28992 (world.buildings.crs)");
    }

    /** The remedy in the message works. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "urn:ogc:def:crs:ESRI::102100 | map: crs is 'urn:ogc:def:crs:ESRI::102100' but must end in an EPSG code; set"
                        + " world.buildings.crs instead",
                "EPSG:1111 | map: crs: coordinate reference system 'EPSG:1111' is not known: give the EPSG code of the"
                        + " system that the file uses",
            })
    void aSystemThatIsNotKnownMayBeReplaced(String name, String message) throws IOException {
        String text = square(String.format(NAMED, name), EAST, NORTH, 20);
        assertThatThrownBy(() -> load(text, Optional.empty()))
                .isInstanceOf(InputException.class)
                .hasMessage(message);
        assertThat(new MapFiles(directory).needsCrs("map")).isTrue();
        assertAtOrigin(load(text, Optional.of("EPSG:28992")));
    }

    /** Where a grid has no coordinates, the file is named. */
    @Test
    void aPointOffTheGridIsNamedWithItsFile() {
        String crs = String.format(NAMED, "urn:ogc:def:crs:EPSG::32631");
        assertThatThrownBy(() -> load(square(crs, 9e7, 0, 20), Optional.empty()))
                .isInstanceOf(InputException.class)
                .hasMessage("map: point (90000000.000000, 0.000000) lies where EPSG:32631 has no coordinates");
    }

    @Test
    void openStreetMapIsNeverInAGrid() throws IOException {
        DrawnMap drawn = new DrawnMap(ORIGIN);
        drawn.area(new double[] {0, 0, 20, 0, 20, 20, 0, 20}, "building=yes height=10");
        assertThatThrownBy(() -> load(drawn.osm(), Optional.of("EPSG:28992")))
                .isInstanceOf(InputException.class)
                .hasMessage("map: has longitude and latitude, like all OpenStreetMap data, but crs is EPSG:28992: leave"
                        + " out crs");
        assertAtOrigin(load(drawn.osm(), Optional.of("EPSG:4326")));
        assertThat(new MapFiles(directory).needsCrs("map")).isFalse();
    }

    /** Where the map is instead, by the corners that were written; which mistake that suggests. */
    @Test
    void whereTheMapIsInsteadIsSaid() {
        String nothing =
                "map: has no building within 2000 m of the origin, at latitude 51.99900 and longitude 4.37330: ";
        assertThatThrownBy(() -> load(square("", 15.0, 50.0, 0.001), Optional.empty()))
                .hasMessage(nothing + "it covers latitude 50.00000 to 50.00100 and longitude 15.00000 to 15.00100");
        assertThatThrownBy(() -> load(square("", LATITUDE, LONGITUDE, 2e-4), Optional.empty()))
                .hasMessage(nothing
                        + "it covers latitude 4.37330 to 4.37350 and longitude 51.99900 to 51.99920; latitude and"
                        + " longitude of the origin, or those in the file, seem to be swapped");
        assertThatThrownBy(() -> load(square(RD, NORTH, EAST, 20), Optional.empty()))
                .hasMessageContaining("in EPSG:28992")
                .hasMessageEndingWith("; x and y in the file seem to be swapped");
        assertThatThrownBy(() -> load(square(RD, LONGITUDE, LATITUDE, 2e-4), Optional.empty()))
                .hasMessageEndingWith(
                        "; these coordinates seem to be longitude and latitude, for which crs is EPSG:4326");
        assertThatThrownBy(() -> load(square(RD, 200.0, 300.0, 20), Optional.empty()))
                .hasMessageContaining("it covers 200.0 to 220.0 east and 300.0 to 320.0 north in EPSG:28992")
                .hasMessageEndingWith("; coordinates this small suggest that the file is not georeferenced");
        assertThatThrownBy(() -> load("{\"type\":\"FeatureCollection\",\"features\":[]}", Optional.empty()))
                .hasMessage(nothing + "it has no coordinates");
    }

    /** In OpenStreetMap the order is fixed: only the origin can be swapped. */
    @Test
    void aSwappedOriginIsNoticed() throws IOException {
        DrawnMap drawn =
                new DrawnMap(Origin.at(ORIGIN.longitude(), ORIGIN.latitude()).withHeight(0.0));
        drawn.area(new double[] {0, 0, 20, 0, 20, 20, 0, 20}, "building=yes height=10");
        assertThatThrownBy(() -> load(drawn.osm(), Optional.empty()))
                .hasMessageEndingWith("; latitude and longitude of the origin seem to be swapped");
    }

    /** What was read but not built is not 'no building'. */
    @Test
    void whatWasLeftOutIsSaid() {
        assertThatThrownBy(() -> load(
                        square("", LONGITUDE, LATITUDE, 2e-4).replace("\"height\": 10", "\"height\": 0"),
                        Optional.empty()))
                .hasMessageStartingWith(
                        "map: has no building within 2000 m of the origin, at latitude 51.99900 and longitude"
                                + " 4.37330 (left out: 1 building of no height): it covers latitude");
    }
}
