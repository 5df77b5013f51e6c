package org.dronewatch.sensor.optics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.function.IntPredicate;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.raster.TileTracer;
import org.dronewatch.sensor.camera.Shapes;
import org.junit.jupiter.api.Test;

/** A drone that is large in the image, its right half hidden: what has to be drawn or traced until it is decided. */
class LargeDroneTest {
    private static final int SIDE = 800;
    private static final Position AT = new Position(0, 80, 0);

    /** A ball, of more triangles than the pixels in doubt along its rim would pay for. */
    private static final Drone BALL = Shapes.drone("ball", Shapes.sphere(0.5, 4), AT);

    private static final CameraObject CAMERA = new CameraObject(new Position(0, 0, 0), AT, SIDE, SIDE, 45_000.0);
    private static final double HEADING = 0.0;

    private int farthest;

    private final Background wall = (column, row) -> {
        farthest = Math.max(farthest, Math.abs(row - SIDE / 2));
        return column < SIDE / 2 ? Float.POSITIVE_INFINITY : 40.0f;
    };

    private DynamicView view() {
        return new DynamicView(CAMERA, TileTracer::new);
    }

    private int drawn() {
        DynamicView view = view();
        view.draw(wall, BALL, pixels -> false);
        return view.pixels(0);
    }

    @Test
    void theMiddleIsDrawnFirst() {
        assertThat(drawn()).isGreaterThan(100_000);
        assertThat(farthest).isGreaterThan(250);
        farthest = 0;
        DynamicView view = view();
        view.draw(wall, BALL, pixels -> pixels >= 5_000);
        assertThat(view.pixels(0)).isGreaterThanOrEqualTo(5_000);
        assertThat(farthest).isLessThan(2 * TileTracer.HEIGHT);
    }

    private static PixelBounds counted(Background site, IntPredicate enough) {
        PixelBounds bounds = new PixelBounds(CAMERA);
        assertThat(bounds.set(site, BALL.silhouettes(), AT)).isTrue();
        bounds.examineAll();
        bounds.count(HEADING, enough);
        return bounds;
    }

    @Test
    void afterFewRaysItIsDetectedOrMissed() {
        int exact = drawn();
        PixelBounds all = counted(wall, pixels -> false);
        assertThat(exact).isStrictlyBetween(all.least(), all.most());
        // Too many to trace all.
        assertThat(all.most() - all.least()).isGreaterThan(2_000);
        int seen = all.least() + 100;
        int unseen = all.most() - 100;
        assertThat(exact).isStrictlyBetween(seen, unseen);
        for (int needed : new int[] {seen, unseen}) {
            IntPredicate enough = pixels -> pixels >= needed;
            PixelBounds bounds = counted(wall, enough);
            assertThat(bounds.refine(view(), BALL, enough, () -> true)).isTrue();
            assertThat(enough.test(bounds.least()) || !enough.test(bounds.most()))
                    .isTrue();
            assertThat(exact).isBetween(bounds.least(), bounds.most());
            assertThat(bounds.leastInTheOpen()).isGreaterThan(needed);
        }
    }
}
