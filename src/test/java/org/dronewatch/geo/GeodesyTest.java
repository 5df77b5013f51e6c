package org.dronewatch.geo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.dronewatch.geometry.Position;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class GeodesyTest {
    /** A millimetre in degrees of latitude. */
    private static final double MILLIMETRE = 9e-9;

    private static Geodesy at(double latitude, double longitude) {
        return new Geodesy(Origin.at(Math.toRadians(latitude), Math.toRadians(longitude)));
    }

    private static double degrees(double degrees, double minutes, double seconds) {
        return degrees + minutes / 60.0 + seconds / 3600.0;
    }

    @Test
    void theOriginIsWhereItIs() {
        GeoPoint place = at(50.08, 14.42).at(new Position(0, 0, 7.5));
        assertThat(place.latitude()).isEqualTo(50.08, within(1e-12));
        assertThat(place.longitude()).isEqualTo(14.42, within(1e-12));
        assertThat(place.height()).isEqualTo(7.5);
    }

    /** Metres of a degree of latitude and of longitude, as tables have them (WGS 84). */
    @ParameterizedTest
    @CsvSource({"0, 110574, 111320", "15, 110649, 107550", "30, 110852, 96486", "45, 111132, 78847", "60, 111412, 55800"
    })
    void degreesAreAsLongAsInTables(double latitude, double north, double east) {
        Geodesy geodesy = at(latitude, 14.0);
        double further = geodesy.at(new Position(0, 100, 0)).latitude()
                - geodesy.at(new Position(0, -100, 0)).latitude();
        double aside = geodesy.at(new Position(100, 0, 0)).longitude()
                - geodesy.at(new Position(-100, 0, 0)).longitude();

        assertThat(200.0 / further).isEqualTo(north, within(1.0));
        assertThat(200.0 / aside).isEqualTo(east, within(1.0));
    }

    /**
     * The example of a topocentric frame in IOGP's Guidance Note 373-7-2, methods 9602 and 9837. Its origin lies 200 m
     * high, ours 0 m: the same place is 200 m higher above it.
     */
    @Test
    void itAgreesWithTheExampleOfTheGeodesists() {
        GeoPoint place = at(55.0, 5.0).at(new Position(-189_013.869, -128_642.040, -4_220.171 + 200.0));

        assertThat(place.latitude()).isEqualTo(degrees(53, 48, 33.820), within(2 * MILLIMETRE));
        assertThat(place.longitude()).isEqualTo(degrees(2, 7, 46.380), within(3 * MILLIMETRE));
    }

    /** The same example the other way, with the origin at its height. */
    @Test
    void placesOnEarthAreFoundInTheWorld() {
        Geodesy geodesy =
                new Geodesy(Origin.at(Math.toRadians(55.0), Math.toRadians(5.0)).withHeight(200.0));
        Position place =
                geodesy.inWorld(Math.toRadians(degrees(53, 48, 33.820)), Math.toRadians(degrees(2, 7, 46.380)), 73.0);

        assertThat(place.x()).isEqualTo(-189_013.869, within(1e-3));
        assertThat(place.y()).isEqualTo(-128_642.040, within(1e-3));
        assertThat(place.z()).isEqualTo(-4_220.171, within(1e-3));
    }

    @Test
    void anOriginAtSeaLevelIsKnownToLieThere() {
        Origin sea = Origin.at(0.7, 0.2).withHeight(0.0);
        assertThat(sea.height()).contains(0.0);
        assertThat(sea).isNotEqualTo(Origin.at(0.7, 0.2));
        assertThat(new Geodesy(sea).at(new Position(0, 0, 5)).height()).isEqualTo(5.0);
    }

    @ParameterizedTest
    @CsvSource({"50.08, 14.42, 430", "0, 180, 0", "-89.5, 10, 2800", "90, 0, 0", "31.5, 35.5, -430"})
    void fromTheMapBackToTheWorld(double latitude, double longitude, double height) {
        Geodesy geodesy = new Geodesy(
                Origin.at(Math.toRadians(latitude), Math.toRadians(longitude)).withHeight(height));
        for (Position local : List.of(
                new Position(0, 0, 0),
                new Position(-900, 40, 120),
                new Position(30, 8000, -50),
                new Position(5, 5, 0))) {
            GeoPoint place = geodesy.at(local);
            // At the foot of the place, whatever its height: the vertical there leans by its distance over the earth's
            // radius.
            Position foot = geodesy.inWorld(
                    Math.toRadians(place.latitude()), Math.toRadians(place.longitude()), place.height());
            double distance = Math.hypot(local.x(), local.y());
            assertThat(Math.hypot(foot.x() - local.x(), foot.y() - local.y()))
                    .isLessThan(1e-6 + distance * distance * distance / (2.0 * 6.33e6 * 6.33e6));
            assertThat(local.z() - foot.z()).isBetween(-1e-6, 1e-6 + distance * distance / (2.0 * 6.33e6));
        }
    }

    /** There by the defining formula of earth-centred coordinates, and back. */
    @ParameterizedTest
    @CsvSource({
        "50.08, 14.42, 50.09, 14.44, 120",
        "0, 0, -0.02, 0.03, 3000",
        "-33.9, 151.2, -34.4, 150.1, 10",
        "78.2, 15.6, 78.4, 17.0, 500",
        "89.9, 10, 89.95, -60, 50",
        "-54.8, -68.3, -54.7, -68.0, -30",
    })
    void thereAndBack(double latitude, double longitude, double otherLatitude, double otherLongitude, double height) {
        double[] origin = ecef(latitude, longitude, 0.0);
        double[] place = ecef(otherLatitude, otherLongitude, height);
        double x = place[0] - origin[0];
        double y = place[1] - origin[1];
        double z = place[2] - origin[2];
        double sinLat = Math.sin(Math.toRadians(latitude));
        double cosLat = Math.cos(Math.toRadians(latitude));
        double sinLon = Math.sin(Math.toRadians(longitude));
        double cosLon = Math.cos(Math.toRadians(longitude));
        Position local = new Position(
                -sinLon * x + cosLon * y,
                -sinLat * cosLon * x - sinLat * sinLon * y + cosLat * z,
                cosLat * cosLon * x + cosLat * sinLon * y + sinLat * z);

        GeoPoint found = at(latitude, longitude).at(local);
        assertThat(found.latitude()).isEqualTo(otherLatitude, within(1e-11));
        assertThat(found.longitude())
                .isEqualTo(otherLongitude, within(1e-11 / Math.cos(Math.toRadians(otherLatitude))));
    }

    private static double[] ecef(double latitude, double longitude, double height) {
        double phi = Math.toRadians(latitude);
        double lambda = Math.toRadians(longitude);
        double a = 6_378_137.0;
        double b = 6_356_752.314245;
        double normal = a * a / Math.hypot(a * Math.cos(phi), b * Math.sin(phi));
        return new double[] {
            (normal + height) * Math.cos(phi) * Math.cos(lambda),
            (normal + height) * Math.cos(phi) * Math.sin(lambda),
            (b * b / (a * a) * normal + height) * Math.sin(phi),
        };
    }

    @Test
    void polesArePlacesLikeOthers() {
        // 111694 m: a degree of latitude at a pole.
        GeoPoint beyond = at(90, 10).at(new Position(0, 1116.94, 0));
        assertThat(beyond.latitude()).isEqualTo(89.99, within(1e-6));
        assertThat(Math.abs(beyond.longitude() - 10)).isEqualTo(180.0, within(1e-6));
        GeoPoint aside = at(-90, 10).at(new Position(1116.94, 0, 0));
        assertThat(aside.latitude()).isEqualTo(-89.99, within(1e-6));
        assertThat(aside.longitude()).isEqualTo(100.0, within(1e-6));
        assertThat(at(90, 10).at(new Position(0, 0, 50)).latitude()).isEqualTo(90.0, within(1e-9));
    }

    @Test
    void longitudesGoOnBeyondTheDateLine() {
        Geodesy geodesy = at(-17.0, 179.999);
        assertThat(geodesy.at(new Position(1000, 0, 0)).longitude()).isBetween(180.008, 180.009);
        assertThat(geodesy.at(new Position(-1000, 0, 0)).longitude()).isBetween(179.989, 179.990);
        assertThat(at(-17.0, -180.0).at(new Position(-1000, 0, 0)).longitude()).isBetween(-180.010, -180.009);
    }
}
