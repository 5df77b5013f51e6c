package org.dronewatch.sensor.radio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

/**
 * How a wall is divided into triangles makes no difference to the diffraction loss over it, even where a corner of one
 * triangle lies on an edge of another, as around windows.
 */
class DividedWallTest {
    private static final long SEED = 20261201;
    private static final double WAVELENGTH = 0.125;

    @Test
    void theLossOverAWallDoesNotDependOnItsTriangles() {
        SplittableRandom random = new SplittableRandom(SEED);
        for (int i = 0; i < 100; i++) {
            Position from =
                    new Position(random.nextDouble(-15, 15), -random.nextDouble(1, 40), random.nextDouble(0.5, 5));
            Position to = new Position(random.nextDouble(-15, 15), random.nextDouble(1, 40), random.nextDouble(0.5, 5));
            List<TriangleMesh> pieces = new ArrayList<>();
            divide(random, pieces, 4, -60, 60, -1, 6);
            double whole = loss(rectangle(-60, 60, -1, 6), from, to);
            assertThat(whole).isBetween(5.0, 60.0);
            assertThat(loss(World.merge(pieces), from, to))
                    .as("pair %d of seed %d: %s to %s", i, SEED, from, to)
                    .isCloseTo(whole, within(1e-3));
        }
    }

    /** The loss over the top of what stands between two places, dB. */
    private static double loss(TriangleMesh wall, Position from, Position to) {
        Section section = new Section(World.of(wall));
        Position ahead = to.minus(from).unit();
        Position up = new Position(0, 0, 1);
        Position across = up.minus(ahead.times(up.dot(ahead))).unit();
        section.cut(from, to, ahead, across, 1e4);
        return new DiffractedPath(section, true, WAVELENGTH, true).loss();
    }

    private static void divide(
            SplittableRandom random, List<TriangleMesh> pieces, int times, double x0, double x1, double z0, double z1) {
        if (times == 0) {
            pieces.add(rectangle(x0, x1, z0, z1));
        } else if (x1 - x0 > 10 * (z1 - z0)) {
            double cut = (float) random.nextDouble(0.8 * x0 + 0.2 * x1, 0.2 * x0 + 0.8 * x1);
            divide(random, pieces, times - 1, x0, cut, z0, z1);
            divide(random, pieces, times - 1, cut, x1, z0, z1);
        } else {
            double cut = (float) random.nextDouble(0.8 * z0 + 0.2 * z1, 0.2 * z0 + 0.8 * z1);
            divide(random, pieces, times - 1, x0, x1, z0, cut);
            divide(random, pieces, times - 1, x0, x1, cut, z1);
        }
    }

    /** A rectangle in the plane y = 0. */
    private static TriangleMesh rectangle(double x0, double x1, double z0, double z1) {
        float[] corners = {
            (float) x0, 0, (float) z0, (float) x1, 0, (float) z0, (float) x1, 0, (float) z1, (float) x0, 0, (float) z1
        };
        return TriangleMesh.of(corners, new int[] {0, 1, 2, 0, 2, 3});
    }
}
