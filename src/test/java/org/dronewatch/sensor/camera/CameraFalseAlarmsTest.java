package org.dronewatch.sensor.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.PositionerSettings;
import org.dronewatch.positioner.Sighting;
import org.dronewatch.sensor.alarm.AzimuthSpan;
import org.junit.jupiter.api.Test;

/** Where in its image a camera has false alarms, by plane geometry: it looks north, 40 degrees wide and 30 high. */
class CameraFalseAlarmsTest {
    private static final int WIDE = 640;
    private static final int HIGH = 480;
    private static final double HALF = Math.toRadians(20);
    private static final CameraSettings LEVEL = CameraSettings.at(new Position(30, -20, 5))
            .withLookAt(new Position(30, 980, 5))
            .withResolution(WIDE, HIGH)
            .withHorizontalFov(2 * HALF);

    /** The angle of half a pixel in the middle, which is the largest of the image, rad. */
    private static final double HALF_PIXEL = Math.tan(HALF) / WIDE;

    @Test
    void theyAreSpreadOverTheWholeImage() {
        assertThat(LEVEL.dimensions()).isEqualTo(2);
        for (double u : new double[] {0, 0.25, 0.5, 0.9, 1}) {
            for (double v : new double[] {0, 0.3, 0.5, 1}) {
                double right = (2 * u - 1) * Math.tan(HALF);
                double up = (1 - 2 * v) * Math.tan(HALF) * HIGH / WIDE;
                Sighting sighting = LEVEL.falseSighting(u, v, 0.5).orElseThrow();
                assertThat(sighting.from()).isEqualTo(LEVEL.position());
                assertThat(Math.IEEEremainder(sighting.direction().azimuth(), 2 * Math.PI))
                        .as("azimuth at (%s, %s)", u, v)
                        .isCloseTo(Math.atan(right), within(2.1 * HALF_PIXEL));
                assertThat(sighting.direction().elevation())
                        .as("elevation at (%s, %s)", u, v)
                        .isCloseTo(Math.atan(up / Math.hypot(1, right)), within(2.1 * HALF_PIXEL));
                assertThat(sighting.range()).isEmpty();
            }
        }
    }

    /** Its solid angle is smaller off the axis. */
    @Test
    void eachLooksLikeADroneOfOnePixel() {
        double middle = LEVEL.falseSighting(0.5, 0.5, 0).orElseThrow().size().orElseThrow();
        double corner = LEVEL.falseSighting(0, 0, 0).orElseThrow().size().orElseThrow();
        double cosine = 1 / Math.sqrt(1 + Math.pow(Math.tan(HALF), 2) * (1 + Math.pow((double) HIGH / WIDE, 2)));

        assertThat(middle).isCloseTo(2 * HALF_PIXEL, within(1e-3 * HALF_PIXEL));
        assertThat(corner / middle).isCloseTo(Math.pow(cosine, 1.5), within(3e-3));
    }

    @Test
    void theirBearingsExtendFromOneEdgeOfALevelImageToTheOther() {
        AzimuthSpan span = LEVEL.falseBearings().orElseThrow();
        assertThat(Math.IEEEremainder(span.centre(), 2 * Math.PI)).isCloseTo(0, within(HALF_PIXEL));
        assertThat(span.width()).isCloseTo(2 * HALF, within(4 * HALF_PIXEL));

        AzimuthSpan east = LEVEL.withLookAt(new Position(1030, -20, 5))
                .withRoll(Math.toRadians(10))
                .falseBearings()
                .orElseThrow();
        assertThat(east.centre()).isCloseTo(Math.PI / 2, within(0.01));
    }

    @Test
    void theirBearingsAreUnknownWhereTheImageMayShowAnyDirection() {
        assertThat(LEVEL.withPositioner(PositionerSettings.DEFAULT).falseBearings())
                .isEmpty();
        assertThat(LEVEL.withLookAt(new Position(30, 980, 2005)).falseBearings())
                .as("63 degrees up")
                .isEmpty();
        assertThat(LEVEL.withRoll(Math.toRadians(60)).falseBearings()).isEmpty();
    }
}
