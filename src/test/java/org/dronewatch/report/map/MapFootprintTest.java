package org.dronewatch.report.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.OptionalDouble;
import org.assertj.core.data.Offset;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Outline;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.optics.Projection;
import org.junit.jupiter.api.Test;

class MapFootprintTest {
    private static final Position AT = new Position(10, 20, 5);

    private static List<List<Position>> rings(Outline outline) {
        return MapFootprint.of(AT, outline, OptionalDouble.empty());
    }

    private static List<List<Position>> camera(double azimuth, double elevation, OptionalDouble detected) {
        CameraSettings settings = CameraSettings.at(AT)
                .withResolution(400, 300)
                .withHorizontalFov(Math.toRadians(60))
                .withAim(new Aim.Direction(Math.toRadians(azimuth), Math.toRadians(elevation)));
        return MapFootprint.of(AT, settings.outline(), detected);
    }

    /** Twice the area of a ring, above 0 for a counterclockwise one. */
    private static double area(List<Position> ring) {
        double sum = 0.0;
        for (int i = 1; i < ring.size(); i++) {
            Position a = ring.get(i - 1).minus(AT);
            Position b = ring.get(i).minus(AT);
            sum += a.x() * b.y() - b.x() * a.y();
        }
        return 0.5 * sum;
    }

    private static Offset<Double> percent(double value) {
        return within(0.01 * value);
    }

    /** On its side a camera is as wide as it was high; a shifted lens moves the wedge, not its tip. */
    @Test
    void aRolledCameraIsAsWideAsItWasHighAndAShiftedOneLooksAside() {
        CameraSettings level = CameraSettings.at(AT)
                .withResolution(400, 300)
                .withHorizontalFov(Math.toRadians(60))
                .withAim(new Aim.Direction(0.0, 0.0));
        double high = 2 * Math.atan(0.75 * Math.tan(Math.toRadians(30)));
        List<List<Position>> rolled = rings(level.withRoll(Math.PI / 2).outline());
        assertThat(area(rolled.get(0))).isEqualTo(0.5 * high * 1e4, percent(0.5 * high * 1e4));

        List<Position> ring = rings(
                        level.withProjection(Projection.shifted(0.75, 0)).outline())
                .get(0);
        double edge = Math.tan(Math.toRadians(30));
        double least = ring.stream()
                .filter(point -> point.distance(AT) > 1)
                .mapToDouble(point -> Math.atan2(point.x() - AT.x(), point.y() - AT.y()))
                .min()
                .orElseThrow();
        assertThat(least).isEqualTo(Math.atan(0.5 * edge), within(1e-9));
        double width = Math.atan(2.5 * edge) - Math.atan(0.5 * edge);
        assertThat(area(ring)).isEqualTo(0.5 * width * 1e4, percent(0.5 * width * 1e4));
    }

    @Test
    void aRadarAllRoundIsARingOf72Points() {
        List<List<Position>> rings = rings(new Outline.Sector(1.0, 0.2, 2.0 * Math.PI, 0.5, 50, 1000));

        assertThat(rings).hasSize(2);
        for (List<Position> ring : rings) {
            assertThat(ring).hasSize(73);
            assertThat(ring.get(72)).isEqualTo(ring.get(0));
            assertThat(ring.subList(0, 72)).doesNotHaveDuplicates();
        }
        assertThat(area(rings.get(0))).isEqualTo(Math.PI * 1e6, percent(Math.PI * 1e6));
        assertThat(area(rings.get(1))).isEqualTo(-Math.PI * 2500, percent(Math.PI * 2500));
        assertThat(rings(new Outline.Sector(0, 0, 2.0 * Math.PI, 0.5, 0, 1000))).hasSize(1);
    }

    @Test
    void aSectorLiesAboutItsBearing() {
        double width = Math.toRadians(90);
        List<List<Position>> rings = rings(new Outline.Sector(Math.PI / 2, 0, width, 0.5, 100, 1000));

        assertThat(rings).hasSize(1);
        List<Position> ring = rings.get(0);
        assertThat(ring.get(ring.size() - 1)).isEqualTo(ring.get(0));
        double expected = 0.5 * width * (1e6 - 1e4);
        assertThat(area(ring)).isEqualTo(expected, percent(expected));
        // To the east.
        assertThat(ring).allMatch(place -> place.x() - AT.x() > Math.abs(place.y() - AT.y()) - 1e-6);
        assertThat(rings(new Outline.Sector(0, 0, width, 0.5, 0, 1000)).get(0)).contains(AT);
    }

    @Test
    void aRadarWithoutALimitIsDrawnAsFarAsAMapIsUseful() {
        List<Position> edge =
                rings(new Outline.Sector(0, 0, 2.0 * Math.PI, 0.5, 0, 1e12)).get(0);
        assertThat(edge.get(0).distance(AT)).isEqualTo(MapFootprint.MOST, within(1e-6));
    }

    @Test
    void aMicrophoneIsADisc() {
        List<List<Position>> rings = rings(new Outline.Ball(0.5));
        assertThat(rings).hasSize(1);
        assertThat(area(rings.get(0))).isEqualTo(Math.PI * 0.25, percent(Math.PI * 0.25));
    }

    @Test
    void aCameraIsAWedgeAsFarAsItDetects() {
        List<Position> level = camera(0, 0, OptionalDouble.of(200)).get(0);
        double expected = 0.5 * Math.toRadians(60) * 200 * 200;
        assertThat(area(level)).isEqualTo(expected, percent(expected));
        assertThat(level).allMatch(place -> place.y() >= AT.y());

        List<Position> unseen = camera(90, 0, OptionalDouble.empty()).get(0);
        assertThat(unseen.get(0).distance(AT)).isEqualTo(100.0, within(1e-9));
        assertThat(unseen).allMatch(place -> place.x() >= AT.x());
    }

    /** The steeper it looks, the more bearings it sees; straight down all of them. */
    @Test
    void aCameraThatLooksDownSeesMoreBearings() {
        OptionalDouble range = OptionalDouble.of(10);
        double disc = Math.PI * 100;
        double level = area(camera(30, 0, range).get(0));
        double steep = area(camera(30, -40, range).get(0));
        assertThat(steep).isGreaterThan(1.5 * level).isLessThan(0.5 * disc);
        for (double elevation : new double[] {-90, -80, 75, 90}) {
            assertThat(area(camera(30, elevation, range).get(0))).isEqualTo(disc, percent(disc));
        }
    }
}
