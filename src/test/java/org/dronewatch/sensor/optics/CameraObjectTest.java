package org.dronewatch.sensor.optics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.camera.*;
import org.jogamp.vecmath.Matrix4d;
import org.jogamp.vecmath.Point2d;
import org.jogamp.vecmath.Point3d;
import org.jogamp.vecmath.Vector3d;
import org.joml.Vector4d;
import org.junit.jupiter.api.Test;

class CameraObjectTest {
    private static final CameraSettings NORTH =
            CameraSettings.at(new Position(1, 2, 3)).withLookAt(new Position(1, 100, 3));

    @Test
    void theTopLeftPixelLooksUpAndLeft() {
        Vector3d direction = new CameraObject(NORTH).ray(0, 0).direction();

        assertThat(direction.x).isNegative();
        assertThat(direction.z).isPositive();
        assertThat(direction.length()).isCloseTo(1.0, within(1e-15));
    }

    /** The outermost pixels' centres lie half a pixel inside the edges of the field of view. */
    @Test
    void theFieldOfViewSpansTheWholeSide() {
        CameraObject vertical = new CameraObject(NORTH.withResolution(200, 100).withVerticalFov(1.2));
        assertThat(vertical.focalLength()).isCloseTo(50 / Math.tan(0.6), within(1e-12));
        CameraObject horizontal =
                new CameraObject(NORTH.withResolution(200, 100).withHorizontalFov(1.2));
        assertThat(horizontal.focalLength()).isCloseTo(100 / Math.tan(0.6), within(1e-12));
        Vector3d leftmost = horizontal.ray(0, 50).direction();
        assertThat(-leftmost.x / leftmost.y).isCloseTo(Math.tan(0.6) * 99.5 / 100, within(1e-12));
    }

    @Test
    void aPixelsRayAndThePlaceOfItsPointsAgree() {
        Random random = new Random(11);
        for (int i = 0; i < 1000; i++) {
            Position way = new Position(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
            CameraObject camera =
                    new CameraObject(NORTH.withLookAt(NORTH.position().plus(way)));
            int column = random.nextInt(camera.width());
            int row = random.nextInt(camera.height());
            Point3d point = camera.ray(column, row).pointAt(0.1 + 500 * random.nextDouble());
            Point2d pixel = camera.pixelOf(point).orElseThrow();
            assertThat(pixel.x).isCloseTo(column + 0.5, within(1e-6));
            assertThat(pixel.y).isCloseTo(row + 0.5, within(1e-6));
        }
    }

    /** The product of the three matrices, step by step. */
    @Test
    void theMatrixToClipSpaceTakesAModelsPointToItsPixel() {
        CameraObject camera = new CameraObject(NORTH);
        Matrix4d model = new Matrix4d();
        model.rotZ(0.7);
        model.setTranslation(new Vector3d(3, 40, 5));
        Point3d point = new Point3d(0.3, -0.2, 0.1);
        Vector4d clip = camera.modelViewProjection(model).transform(new Vector4d(point.x, point.y, point.z, 1));

        model.transform(point);
        Point2d pixel = camera.pixelOf(point).orElseThrow();
        assertThat(0.5 * (1 + clip.x / clip.w) * camera.width()).isCloseTo(pixel.x, within(1e-9));
        assertThat(0.5 * (1 - clip.y / clip.w) * camera.height()).isCloseTo(pixel.y, within(1e-9));
    }

    @Test
    void whatIsBehindHasNoPlaceInThePicture() {
        CameraObject camera = new CameraObject(NORTH);

        assertThat(camera.pixelOf(new Point3d(1, 1.9, 3))).isEmpty();
        assertThat(camera.pixelOf(new Point3d(1, 2, 3))).isEmpty();
        assertThat(camera.pixelOf(new Point3d(1, 2.1, 3))).isPresent();
    }

    @Test
    void aCameraThatLooksDownHasNorthAtTheTop() {
        CameraObject down = new CameraObject(NORTH.withLookAt(new Position(1, 2, 0)));

        Vector3d top = down.ray(960, 0).direction();
        assertThat(top.y).isPositive();
        assertThat(top.x).isCloseTo(0.0, within(1e-3));
        assertThat(down.ray(0, 540).direction().x).isNegative();
    }

    @Test
    void settingsHaveLimits() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> NORTH.withResolution(0, 1080))
                .withMessageContaining("width 0");
        assertThatIllegalArgumentException().isThrownBy(() -> NORTH.withResolution(1920, 20_000));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> NORTH.withVerticalFov(0.0))
                .withMessageContaining("fov 0 deg must be 0.01 to 179 deg");
        assertThatIllegalArgumentException().isThrownBy(() -> NORTH.withVerticalFov(Math.PI));
        assertThatIllegalArgumentException().isThrownBy(() -> NORTH.withVerticalFov(Double.NaN));
        assertThatIllegalArgumentException().isThrownBy(() -> NORTH.withRate(0.0));
        assertThatIllegalArgumentException().isThrownBy(() -> NORTH.withLookAt(NORTH.position()));
        assertThatIllegalArgumentException().isThrownBy(() -> new PixelThreshold(0.0));
    }
}
