package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.UnaryOperator;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sensor.acoustic.edge.EdgePath;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

/**
 * How a wall is divided into triangles makes no difference to the sound diffracted around it: none passes between
 * triangles, even where a corner of one lies on an edge of another, as around windows.
 */
class DividedWallTest {
    private static final long SEED = 20261201;
    private static final SurfaceMaterial OPAQUE = SurfaceMaterial.uniform("opaque", 1, 0);
    private static final double WALL = 8;

    @Test
    void thePathAroundAWallDoesNotDependOnItsTriangles() {
        SplittableRandom random = new SplittableRandom(SEED);
        for (int i = 0; i < 60; i++) {
            UnaryOperator<Position> by = i % 4 == 0 ? position -> position : Sites.attitude(random);
            EdgePath whole = path(Sites.wall(1, WALL, -1, 5, -20, 20), by);
            EdgePath divided = path(divided(random, -1, 5, -20, 20), by);
            Position drone = by.apply(behind(random, -1));
            Position microphone = by.apply(behind(random, 1));
            String what = "pair %d of seed %d".formatted(i, SEED);
            assertThat(whole.find(drone, microphone)).as(what).isTrue();
            assertThat(divided.find(drone, microphone)).as(what).isTrue();
            assertThat(divided.pathDifference())
                    .as("path difference, m: %s", what)
                    .isCloseTo(whole.pathDifference(), within(1e-3));
        }
    }

    /** Opposite walls of a house are divided differently; it stands on the ground. */
    @Test
    void noPathLeadsOutOfAClosedHouseWhoseWallsAreDivided() {
        SplittableRandom random = new SplittableRandom(SEED);
        for (int i = 0; i < 12; i++) {
            UnaryOperator<Position> by = i % 4 == 0 ? position -> position : Sites.attitude(random);
            TriangleMesh house = World.merge(List.of(
                    Sites.square(60, 0),
                    Sites.wall(0, 0, 8, 14, -1, 3),
                    Sites.wall(0, 7, 8, 14, -1, 3),
                    Sites.wall(2, 3, 0, 7, 8, 14),
                    divided(random, -1, 3, 0, 7),
                    Sites.wall(1, 14, -1, 3, 0, 7)));
            EdgePath path = path(house, by);
            Position inside = by.apply(new Position(3, 10, 1.5));
            Position outside = by.apply(new Position(-12 + 24 * random.nextDouble(), -4, 1.5));
            assertThat(path.find(inside, outside))
                    .as("house %d of seed %d", i, SEED)
                    .isFalse();
            assertThat(path.find(outside, inside))
                    .as("house %d of seed %d", i, SEED)
                    .isFalse();
        }
    }

    /** Models have such gaps where their parts were placed by rounded coordinates. */
    @Test
    void noPathLeadsThroughAGapOfAHundredthOfAMillimetre() {
        SplittableRandom random = new SplittableRandom(SEED);
        UnaryOperator<Position> same = position -> position;
        EdgePath whole = path(Sites.wall(1, WALL, -1, 5, -20, 20), same);
        for (double gap : new double[] {1e-7, 1e-6, 1e-5}) {
            EdgePath halves = path(
                    World.merge(List.of(Sites.wall(1, WALL, -1, 5, -20, 0), Sites.wall(1, WALL, -1, 5, gap, 20))),
                    same);
            for (int i = 0; i < 20; i++) {
                Position drone = behind(random, -1);
                Position microphone = behind(random, 1);
                assertThat(whole.find(drone, microphone)).isTrue();
                assertThat(halves.find(drone, microphone)).isTrue();
                assertThat(halves.pathDifference())
                        .as("path difference, m: gap of %s m, pair %d of seed %d", gap, i, SEED)
                        .isCloseTo(whole.pathDifference(), within(1e-3));
            }
        }
    }

    private static EdgePath path(TriangleMesh mesh, UnaryOperator<Position> by) {
        return new EdgePath(Sites.world(Sites.turned(mesh, by), OPAQUE));
    }

    /** Low, and so near the middle of the wall that it hides the other side. */
    private static Position behind(SplittableRandom random, int side) {
        return new Position(
                random.nextDouble(-8, 8), WALL + side * random.nextDouble(0.5, 10), random.nextDouble(0.0, 2.0));
    }

    /** The wall at y = {@link #WALL}, cut in two at random several times, each part at another place. */
    private static TriangleMesh divided(SplittableRandom random, double u0, double u1, double v0, double v1) {
        List<TriangleMesh> pieces = new ArrayList<>();
        divide(random, pieces, 4, u0, u1, v0, v1);
        return World.merge(pieces);
    }

    private static void divide(
            SplittableRandom random, List<TriangleMesh> pieces, int times, double u0, double u1, double v0, double v1) {
        if (times == 0) {
            pieces.add(Sites.wall(1, WALL, u0, u1, v0, v1));
        } else if (v1 - v0 > u1 - u0) {
            double cut = (float) (v0 + (v1 - v0) * random.nextDouble(0.2, 0.8));
            divide(random, pieces, times - 1, u0, u1, v0, cut);
            divide(random, pieces, times - 1, u0, u1, cut, v1);
        } else {
            double cut = (float) (u0 + (u1 - u0) * random.nextDouble(0.2, 0.8));
            divide(random, pieces, times - 1, u0, cut, v0, v1);
            divide(random, pieces, times - 1, cut, u1, v0, v1);
        }
    }
}
