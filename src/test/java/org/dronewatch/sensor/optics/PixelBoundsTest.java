package org.dronewatch.sensor.optics;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronewatch.drone.Drone;
import org.dronewatch.drone.silhouette.SilhouetteTable;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Walls;
import org.junit.jupiter.api.Test;

/**
 * How much work bounds take on a drone that fills much of a long lens's image: as many pixels are counted as suffice,
 * and hardly more, however many show the drone.
 */
class PixelBoundsTest {
    private static final Position AT = new Position(0, 80, 0);
    private static final Drone CUBE = Walls.cube(AT);

    /** Rows and columns of the pixels whose distances to the site were requested. */
    private int requested;

    private final Background nothing = (column, row) -> {
        requested++;
        return Float.POSITIVE_INFINITY;
    };

    /** A camera to which the drone is a number of pixels wide and high, approximately. */
    private static CameraObject camera(int pixels) {
        double focalLength = 0.5 * pixels / CUBE.silhouettes().radius() * AT.y();
        return new CameraObject(new Position(0, 0, 0), AT, 2 * pixels, 2 * pixels, focalLength);
    }

    private PixelBounds bounds(CameraObject camera) {
        SilhouetteTable silhouettes = CUBE.silhouettes();
        PixelBounds bounds = new PixelBounds(camera);
        requested = 0;
        assertThat(bounds.set(nothing, silhouettes, AT)).isTrue();
        assertThat(bounds.examineAll()).isTrue();
        return bounds;
    }

    @Test
    void noMorePixelsAreCountedThanSuffice() {
        PixelBounds bounds = bounds(camera(300));
        bounds.count(0.4, pixels -> false);
        int certain = bounds.least();
        assertThat(certain).isGreaterThan(20_000);
        for (int sufficient : new int[] {1, 100, 1100, 2100, 4200, 9000, certain / 2 + 1}) {
            bounds.count(0.4, pixels -> pixels >= sufficient);
            // Every sixteenth is the precision of what suffices, and pixels are counted by the hundred.
            assertThat(bounds.least()).isBetween(sufficient, sufficient + sufficient / 16 + 128);
        }
    }

    @Test
    void onlyTheRowsThatSufficeAreExamined() {
        PixelBounds bounds = bounds(camera(300));
        bounds.count(0.4, pixels -> pixels >= 2000);
        assertThat(bounds.least()).isGreaterThanOrEqualTo(2000);
        assertThat(requested).isLessThan(5000);
    }

    /** They are more than are ever examined: without the middle rows, the drone would have to be drawn. */
    @Test
    void ofMillionsOfPixelsTheMiddleRowsSuffice() {
        PixelBounds bounds = bounds(camera(1800));
        assertThat(bounds.mostInRectangle()).isGreaterThan(3_000_000);
        bounds.count(0.4, pixels -> pixels >= 10_000);
        assertThat(bounds.least()).isGreaterThanOrEqualTo(10_000);
        assertThat(requested).isLessThan(25_000);
        assertThat(bounds.most()).isEqualTo(bounds.mostInRectangle());
    }

    /** Bounds remain bounds where the middle rows do not suffice. */
    @Test
    void ofMillionsOfPixelsNotAllAreExamined() {
        PixelBounds bounds = bounds(camera(1800));
        bounds.count(0.4, pixels -> pixels >= 1_000_000);
        assertThat(requested).isLessThan(150_000);
        assertThat(bounds.least()).isBetween(10_000, requested);
        assertThat(bounds.most()).isEqualTo(bounds.mostInRectangle());
        assertThat(bounds.mostInTheOpen()).isEqualTo(bounds.mostInRectangle());
        assertThat(bounds.isInvisible()).isFalse();
        assertThat(bounds.examineAll()).isFalse();
    }
}
