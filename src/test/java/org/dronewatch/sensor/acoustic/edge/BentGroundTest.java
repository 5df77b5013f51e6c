package org.dronewatch.sensor.acoustic.edge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

/** Paths of sound that bends, with ends on the ground or just above it. */
class BentGroundTest {
    private static final long SEED = 20261201;
    private static final float HALF = 2000;
    private static final float WALL = 3;

    /**
     * Over a long wall on flat ground: if arcs that bend down are drawn as straight lines, the top of the wall is
     * lowered by their sag, and the path over it has two straight legs.
     */
    @Test
    void overAWallThePathIsThatOfTwoArcs() {
        EdgePath path = new EdgePath(wallOnGround());
        SplittableRandom random = new SplittableRandom(SEED);
        int hidden = 0;
        for (int i = 0; i < 400; i++) {
            Position a = new Position(-random.nextDouble(3, 150), random.nextDouble(-50, 50), height(random));
            Position b = new Position(random.nextDouble(3, 150), random.nextDouble(-50, 50), height(random));
            double length = a.distance(b);
            double curvature = -Math.min(1 / length, Math.pow(10, random.nextDouble(-4.5, -2.5)));
            if (line(a, b).z() > WALL + sag(a, b, curvature, line(a, b)) - 0.1) {
                continue;
            }
            hidden++;
            double detour = overWall(a, b, curvature) - length;

            assertThat(path.find(a, b, curvature)).isTrue();
            assertThat(path.pathDifference())
                    .as("pair %d of seed %d: %s and %s, curvature %g", i, SEED, a, b, curvature)
                    .isCloseTo(detour, within(1e-4 + 1e-3 * detour));
        }
        assertThat(hidden).isGreaterThan(200);
    }

    /** From a tenth of a millimetre to a tenth of a metre. */
    private static double height(SplittableRandom random) {
        return Math.pow(10, random.nextDouble(-4, -1));
    }

    /** Where the line passes the wall. */
    private static Position line(Position a, Position b) {
        return a.plus(b.minus(a).times(a.x() / (a.x() - b.x())));
    }

    /** Length of the shortest path over the top of the wall, over all places along it. */
    private static double overWall(Position a, Position b, double curvature) {
        double shortest = Double.POSITIVE_INFINITY;
        double middle = line(a, b).y();
        for (double y = middle - 10; y < middle + 10; y += 0.01) {
            Position top = new Position(0, y, WALL);
            Position raised = new Position(0, y, WALL + sag(a, b, curvature, top));
            shortest = Math.min(shortest, a.distance(raised) + raised.distance(b));
        }
        return shortest;
    }

    private static double sag(Position a, Position b, double curvature, Position at) {
        double along = at.minus(a).dot(b.minus(a)) / a.distance(b);
        return 0.5 * curvature * along * (a.distance(b) - along);
    }

    private static World wallOnGround() {
        float[] corners = {
            -HALF, -HALF, 0, HALF, -HALF, 0, HALF, HALF, 0, -HALF, HALF, 0, //
            0, -HALF, 0, 0, HALF, 0, 0, HALF, WALL, 0, -HALF, WALL
        };
        int[] triangles = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
        return World.of(TriangleMesh.of(corners, triangles));
    }
}
