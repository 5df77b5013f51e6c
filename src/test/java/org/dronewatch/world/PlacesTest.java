package org.dronewatch.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.dronewatch.geo.EarthPlace;
import org.dronewatch.geo.EarthPoint;
import org.dronewatch.geo.GeoPoint;
import org.dronewatch.geo.Geodesy;
import org.dronewatch.geo.LocalPlace;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PlacesTest {
    private static final Origin PRAGUE = Origin.at(Math.toRadians(50.08), Math.toRadians(14.42));

    private static Places places(Origin origin, Ground ground) {
        return new Places(WorldSettings.EMPTY.withOrigin(origin), () -> ground);
    }

    private static EarthPlace place(double latitude, double longitude, Double above, Double height) {
        return new EarthPlace(
                Math.toRadians(latitude),
                Math.toRadians(longitude),
                Optional.ofNullable(above),
                Optional.ofNullable(height));
    }

    /** By PROJ 9.5.1, from the origin 50.08, 14.42, 250 m. */
    @ParameterizedTest
    @CsvSource({"50.17, 14.42, 250, 0, 10011.2211, -7.8628", "50.125, 14.49, 300, 5005.9120, 5007.9771, 46.0720"})
    void heightsAboveTheSeaGoThroughEarthCentredCoordinates(
            double latitude, double longitude, double height, double x, double y, double z) {
        Position position = places(PRAGUE.withHeight(250), Ground.NONE).at(place(latitude, longitude, null, height));
        assertThat(position.distance(new Position(x, y, z))).isLessThan(1e-4);
    }

    /** On a plane as steep as a mountainside, as far away as the frame's vertical is one degree off. */
    @Test
    void heightsAboveASlopeCountOnThePlacesOwnVertical() {
        double east = 0.7;
        double north = -0.4;
        Places places = places(PRAGUE.withHeight(250), (x, y) -> OptionalDouble.of(12.0 + east * x + north * y));
        Geodesy geodesy = new Geodesy(PRAGUE.withHeight(250));
        SplittableRandom random = new SplittableRandom(26);
        for (int i = 0; i < 200; i++) {
            double latitude = 50.08 + random.nextDouble(-0.5, 0.5);
            double longitude = 14.42 + random.nextDouble(-0.7, 0.7);
            double above = random.nextDouble(0.0, 150.0);
            Position found = places.at(place(latitude, longitude, above, null));
            GeoPoint earth = geodesy.onEarth(found);
            assertThat(earth.latitude()).isEqualTo(latitude, within(1e-10));
            assertThat(earth.longitude()).isEqualTo(longitude, within(1e-10));
            // Where the vertical meets the plane, without iteration: both are linear.
            Position foot = geodesy.inWorld(Math.toRadians(latitude), Math.toRadians(longitude), 0.0);
            Position vertical = geodesy.inWorld(Math.toRadians(latitude), Math.toRadians(longitude), 10_000.0)
                    .minus(foot)
                    .times(1e-4);
            double off = foot.z() - 12.0 - east * foot.x() - north * foot.y();
            double height = -off / (vertical.z() - east * vertical.x() - north * vertical.y());
            assertThat(found.distance(foot.plus(vertical.times(height + above))))
                    .as("place %s with seed 26", i)
                    .isLessThan(1e-5);
        }
    }

    @Test
    void placesByEastAndNorthStandOnTheSurfaceToo() {
        Ground ground = (x, y) -> x < 0 ? OptionalDouble.empty() : OptionalDouble.of(0.5 * x);
        Places places = new Places(WorldSettings.EMPTY, () -> ground);
        assertThat(places.at(new LocalPlace(40, -7, 3))).isEqualTo(new Position(40, -7, 23));
        assertThatThrownBy(() -> places.at(new LocalPlace(-1, 2, 3)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("no surface at east -1.0 m, north 2.0 m");
    }

    @Test
    void pointsInPlanNeedNoGround() {
        GroundPoint point = places(PRAGUE.withHeight(250), Ground.NONE)
                .at(new EarthPoint(Math.toRadians(50.17), Math.toRadians(14.42)));
        assertThat(point.x()).isEqualTo(0.0, within(1e-6));
        assertThat(point.y()).isEqualTo(10011.2211, within(1e-4));
    }

    /** A hole is not ground at height 0. */
    @Test
    void aHoleIsNamed() {
        assertThatThrownBy(() -> places(PRAGUE, Ground.NONE).at(place(50.09, 14.43, 10.0, null)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(
                        "no surface at latitude 50.090000 deg, longitude 14.430000 deg (x 715.6 m, y 1112.4")
                .hasMessageContaining("give 'height' instead");
    }

    @Test
    void whatHasNoMeaningIsRefused() {
        Places nowhere = new Places(WorldSettings.EMPTY, () -> Ground.NONE);
        assertThatThrownBy(() -> nowhere.at(place(50.09, 14.43, 10.0, null)))
                .hasMessageContaining("needs a world.origin");
        assertThatThrownBy(() -> places(PRAGUE, Ground.NONE).at(place(50.09, 14.43, null, 300.0)))
                .hasMessageContaining("height 300.0 m above sea level has no meaning without world.origin.height");
        // 0 is a height.
        assertThat(places(PRAGUE.withHeight(0), Ground.NONE)
                        .at(place(50.08, 14.42, null, 300.0))
                        .z())
                .isEqualTo(300.0, within(1e-6));
        assertThatThrownBy(() -> places(PRAGUE.withHeight(0), Ground.NONE).at(place(51.08, 14.42, null, 300.0)))
                .hasMessageContaining(
                        "lies 111.2 km from world.origin, but must lie within 100 km of it along each axis");
        assertThatThrownBy(() -> place(50.0, 14.0, 1.0, 2.0)).hasMessageContaining("omit one of them");
    }

    /** A vertical wall has two heights: one of them is found. */
    @Test
    void aWallHasOneOfItsHeights() {
        Geodesy geodesy = new Geodesy(PRAGUE);
        Position foot = geodesy.inWorld(Math.toRadians(50.6), Math.toRadians(14.42), 0.0);
        Places places = places(PRAGUE, (x, y) -> OptionalDouble.of(y < foot.y() + 1e-3 ? 0.0 : 50.0));
        double z = places.at(place(50.6, 14.42, null, null)).z();
        assertThat(Math.min(Math.abs(z), Math.abs(z - 50.0))).isLessThan(1e-2);
    }
}
