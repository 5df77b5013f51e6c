package org.dronewatch.geo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvFileSource;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Against PROJ 9.5.1 (pyproj 3.7.2). */
class MapTransformTest {
    private static final Origin PRAGUE =
            Origin.at(Math.toRadians(50.08), Math.toRadians(14.42)).withHeight(250.0);

    private static MapTransform transform(String code, Origin origin) {
        return new MapTransform(CoordinateReferenceSystem.of(code), origin);
    }

    /** National grids, zones of both hemispheres, of other ellipsoids, conic, azimuthal and oblique ones. */
    @ParameterizedTest
    @CsvFileSource(resources = "/org/dronewatch/geo/grids.csv", numLinesToSkip = 1)
    void gridsAgreeWithProj(
            String code, double latitude, double longitude, double east, double north, double tolerance) {
        MapTransform grid = transform(code, PRAGUE);

        MapPoint there = grid.onMap(new GeoPoint(longitude, latitude, 12.5));
        assertThat(there.x()).isEqualTo(east, within(tolerance));
        assertThat(there.y()).isEqualTo(north, within(tolerance));
        assertThat(there.height()).isEqualTo(12.5);

        GeoPoint back = grid.onEarth(east, north, 12.5);
        double metre = 1.0 / 111_000.0;
        assertThat(back.latitude()).isEqualTo(latitude, within(tolerance * metre));
        assertThat(back.longitude())
                .isEqualTo(longitude, within(tolerance * metre / Math.cos(Math.toRadians(latitude))));
        assertThat(back.height()).isEqualTo(12.5);
    }

    @ParameterizedTest
    @CsvSource({
        "50.08,  14.42, 350,      0.0000,      0.0000, 100.0000",
        "50.09,  14.42, 250,      0.0000,   1112.3506,  -0.0971",
        "50.08,  14.43, 250,    715.7951,      0.0479,  -0.0401",
        "50.17,  14.42, 250,      0.0000,  10011.2211,  -7.8628",
        "50.08,  14.56, 250,  10021.1218,      9.3898,  -7.8566",
        "50.125, 14.49, 300,   5005.9120,   5007.9771,  46.0720",
        "49.99,  14.28, 200, -10039.7915, -10001.5793, -65.7338",
    })
    void theWorldFrameAgreesWithProj(
            double latitude, double longitude, double height, double east, double north, double up) {
        for (String code : new String[] {"EPSG:4326", "EPSG:32633", "EPSG:3035"}) {
            MapTransform map = transform(code, PRAGUE);
            MapPoint point = map.onMap(new GeoPoint(longitude, latitude, height));
            Position found = map.inWorld(point.x(), point.y(), point.height());
            assertThat(found.x()).isEqualTo(east, within(1e-4));
            assertThat(found.y()).isEqualTo(north, within(1e-4));
            assertThat(found.z()).isEqualTo(up, within(1e-4));
        }
    }

    /** The same through Krovak's grid, whose north is 8 degrees off: its own shift of datum goes and comes back. */
    @Test
    void aGridWhoseNorthIsEightDegreesOffEndsInTheSameFrame() {
        MapTransform krovak = transform("EPSG:5514", PRAGUE);
        MapPoint point = krovak.onMap(new GeoPoint(14.42, 50.125, 250.0));
        Position found = krovak.inWorld(point.x(), point.y(), 250.0);
        assertThat(found.x()).isEqualTo(0.0, within(1e-3));
        assertThat(found.y()).isEqualTo(5005.593, within(2e-3));
        // What subtracting the grid's origin would give.
        assertThat(point.x() + 743011.7235).isEqualTo(682.381, within(0.2));
    }

    /** Random points up to 100 km away; seed 26. The origin lies where the grid is used. */
    @ParameterizedTest
    @CsvSource({
        "EPSG:4326, 50.08, 14.42",
        "EPSG:32633, 50.08, 14.42",
        "EPSG:3035, 50.08, 14.42",
        "EPSG:25833, 50.08, 14.42",
        "EPSG:28992, 51.999, 4.3733",
        "EPSG:7415, 51.999, 4.3733",
        "EPSG:5514, 50.08, 14.42",
        "EPSG:2056, 47.3667, 8.55",
        "EPSG:2154, 43.7384, 7.4246",
        "EPSG:3794, 46.46, 14.54",
        "EPSG:31468, 49.9457, 11.5757",
        "EPSG:32717, -0.18, -78.47",
    })
    void thereAndBackWithinAMicrometre(String code, double latitude, double longitude) {
        MapTransform map = transform(code, Origin.at(Math.toRadians(latitude), Math.toRadians(longitude)));
        Random random = new Random(26);
        for (int i = 0; i < 1000; i++) {
            double distance = 100_000.0 * random.nextDouble();
            double bearing = 2.0 * Math.PI * random.nextDouble();
            Position start = new Position(
                    distance * Math.sin(bearing),
                    distance * Math.cos(bearing),
                    10_000.0 * random.nextDouble() - 1000.0);
            MapPoint point = map.onMap(start);
            Position back = map.inWorld(point.x(), point.y(), point.height());
            assertThat(Math.sqrt(Math.pow(back.x() - start.x(), 2)
                            + Math.pow(back.y() - start.y(), 2)
                            + Math.pow(back.z() - start.z(), 2)))
                    .isLessThan(1e-6);
        }
    }

    /** Positions beyond the date line, where longitudes go on from that of the origin. */
    @ParameterizedTest
    @ValueSource(strings = {"EPSG:4326", "EPSG:32701", "EPSG:32760", "EPSG:3832"})
    void theDateLineIsALineLikeOthers(String code) {
        for (double longitude : new double[] {179.9999, -179.9999}) {
            Origin origin =
                    Origin.at(Math.toRadians(-16.8), Math.toRadians(longitude)).withHeight(0.0);
            MapTransform map = transform(code, origin);
            for (double x = -5000.0; x <= 5000.0; x += 500.0) {
                MapPoint point = map.onMap(new Position(x, 300.0, 20.0));
                Position back = map.inWorld(point.x(), point.y(), point.height());
                assertThat(back.x()).isEqualTo(x, within(1e-6));
                assertThat(back.y()).isEqualTo(300.0, within(1e-6));
            }
        }
    }

    @Test
    void longitudeComesFirstWhateverTheRegisterSays() {
        Position east = transform("EPSG:4326", PRAGUE).inWorld(14.43, 50.08, 250.0);
        assertThat(east.x()).isEqualTo(715.795, within(1e-3));
        assertThat(CoordinateReferenceSystem.of("EPSG:4326").isGeographic()).isTrue();
        assertThat(CoordinateReferenceSystem.of("epsg:25832").isGeographic()).isFalse();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "EPSG:28992",
                "epsg:28992",
                " EPSG:28992 ",
                "urn:ogc:def:crs:EPSG::28992",
                "https://www.opengis.net/def/crs/EPSG/0/28992",
                "http://www.opengis.net/def/crs/EPSG/9.9/28992",
            })
    void codesAreWrittenInSeveralWays(String code) {
        assertThat(CoordinateReferenceSystem.of(code).name()).isEqualTo("EPSG:28992");
        assertThat(CoordinateReferenceSystem.of(code)).isEqualTo(CoordinateReferenceSystem.of("EPSG:28992"));
    }

    @ParameterizedTest
    @CsvSource({
        "UTM 33N, must be an EPSG code",
        "EPSG:, must be an EPSG code",
        "EPSG:99999, is not known",
        "'EPSG:4326; rm', must be an EPSG code",
        "EPSG:4978, has earth-centred coordinates",
        "EPSG:5773, is not known",
    })
    void otherTextsAreRefusedInOneLine(String code, String reason) {
        assertThatThrownBy(() -> CoordinateReferenceSystem.of(code))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(reason)
                .hasMessageContaining("coordinate reference system")
                .hasMessageNotContaining("\n");
    }

    @ParameterizedTest
    @CsvSource({"EPSG:32633, 1e30, 5e6", "EPSG:32633, 5e5, 1e30", "EPSG:4326, 14, 1000", "EPSG:5514, 1e12, 1e12"})
    void pointsOffTheMapAreRefused(String code, double x, double y) {
        MapTransform map = transform(code, PRAGUE);
        assertThatThrownBy(() -> map.inWorld(x, y, 0.0))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(code);
    }
}
