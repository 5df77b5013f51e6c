package org.dronewatch.sensor.radar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.sensor.Walls;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What a radar sees of the surface in a range cell, against closed forms and against all rays. */
class VisibleGroundTest {
    private static final float HALF = 20_000F;

    /** A plane that rises to the north, of a height at the origin. */
    private static TriangleMesh plane(double height, double slope) {
        float low = (float) (height - HALF * slope);
        float high = (float) (height + HALF * slope);
        return TriangleMesh.of(
                new float[] {-HALF, -HALF, low, HALF, -HALF, low, HALF, HALF, high, -HALF, HALF, high},
                new int[] {0, 1, 2, 0, 2, 3});
    }

    private static double width(VisibleGround ground) {
        return ground.high() - ground.low();
    }

    /** On level ground a cell lies between the depressions {@code asin(h / R)} of its ends. */
    @ParameterizedTest
    @CsvSource({
        "10, 1000, 15",
        "10, 10000, 15",
        "0.5, 300, 1.5",
        "100, 150, 5",
        "2, 30, 15",
        "10, 15000, 150",
        "1000, 1001, 1.5"
    })
    void onLevelGroundItIsTheDepressionOfBothEnds(double height, double range, double depth) {
        VisibleGround ground = new VisibleGround(World.of(plane(-height, 0)), new Position(0, 0, 0));
        double near = range - 0.5 * depth;
        double far = range + 0.5 * depth;
        double expected = Math.asin(Math.min(1.0, height / near)) - Math.asin(height / far);
        for (double azimuth : new double[] {0, 0.7, 3, -2}) {
            assertThat(ground.look(azimuth, near, far)).isTrue();
            assertThat(width(ground)).isCloseTo(expected, within(5e-3 * expected));
            assertThat(ground.high()).isCloseTo(-Math.asin(height / far), within(5e-3 * expected));
        }
    }

    /** On a slope s the elevation at a range r is {@code atan s - asin(h / (r sqrt(1 + s^2)))}. */
    @ParameterizedTest
    @CsvSource({"10, 0.2, 1000", "10, 1, 500", "30, -0.02, 800", "10, -0.009, 1000", "5, 2, 100"})
    void onASlopeItFollowsTheSlope(double height, double slope, double range) {
        VisibleGround ground = new VisibleGround(World.of(plane(-height, slope)), new Position(0, 0, 0));
        double root = Math.sqrt(1 + slope * slope);
        double near = Math.atan(slope) - Math.asin(height / ((range - 7.5) * root));
        double far = Math.atan(slope) - Math.asin(height / ((range + 7.5) * root));
        assertThat(ground.look(0, range - 7.5, range + 7.5)).isTrue();
        assertThat(width(ground)).isCloseTo(far - near, within(0.01 * (far - near)));
        assertThat(ground.low()).isCloseTo(near, within(0.01 * (far - near)));
    }

    /** A wall at 500 m whose top is h' below the radar hides the ground up to 500 h / h'; half a cell may remain. */
    @Test
    void whatANearerWallHidesIsLeftOut() {
        World world = World.of(World.merge(List.of(plane(-10, 0), Walls.wall(500, -10, -5))));
        VisibleGround ground = new VisibleGround(world, new Position(0, 0, 0));
        assertThat(ground.look(0, 800, 815)).as("in its shadow").isFalse();
        assertThat(ground.look(0, 985, 995)).as("its last cell").isFalse();
        assertThat(ground.look(0, 1010, 1025)).as("behind it").isTrue();
        double edge = Math.atan(-5.0 / 500.0);
        double far = -Math.asin(10.0 / 1010);
        assertThat(ground.look(0, 990, 1010)).isTrue();
        assertThat(ground.low()).isCloseTo(edge, within(5e-3 * (far - edge)));
        assertThat(width(ground)).isCloseTo(far - edge, within(0.01 * (far - edge)));
        assertThat(ground.look(Math.PI, 800, 815)).as("on the other side").isTrue();
    }

    /** Of a wall that stands in the cell its whole face is in sight, and nothing of the ground behind it. */
    @Test
    void aWallInTheCellShowsItsFace() {
        World world = World.of(World.merge(List.of(plane(-10, 0), Walls.wall(500, -10, 20))));
        VisibleGround ground = new VisibleGround(world, new Position(0, 0, 0));
        assertThat(ground.look(0, 492, 507)).isTrue();
        assertThat(ground.low()).isCloseTo(-Math.asin(10.0 / 492), within(1e-6));
        assertThat(ground.high()).isCloseTo(Math.atan(20.0 / 500), within(1e-6));
        assertThat(ground.look(0, 507, 522)).isFalse();
        assertThat(ground.look(0, 5000, 5015)).isFalse();
    }

    /** Where the mesh ends, there is nothing; nor in an empty sky, under a ceiling, or on the ground itself. */
    @Test
    void withoutGroundThereIsNothing() {
        VisibleGround edge = new VisibleGround(World.of(plane(-10, 0)), new Position(0, 0, 0));
        assertThat(edge.look(0, 19_000, 19_015)).isTrue();
        assertThat(edge.look(0, 21_000, 21_015)).isFalse();
        VisibleGround sky = new VisibleGround(Walls.open(), new Position(0, 0, 0));
        assertThat(sky.look(0, 1000, 1015)).isFalse();
        VisibleGround room = new VisibleGround(
                World.of(World.merge(List.of(plane(-10, 0), Walls.ceiling(3)))), new Position(0, 0, 0));
        assertThat(room.look(0, 200, 215)).isFalse();
        VisibleGround flat = new VisibleGround(World.of(plane(0, 0)), new Position(0, 0, 0));
        assertThat(flat.look(0, 200, 215)).isFalse();
        VisibleGround high = new VisibleGround(World.of(plane(-100, 0)), new Position(0, 0, 0));
        assertThat(high.look(0, 40, 55)).as("no ground as near as that").isFalse();
        assertThat(high.look(0, -5, 110)).as("from the radar on").isTrue();
        assertThat(high.low()).isEqualTo(-0.5 * Math.PI);
    }

    /** Over random hills: the directions of a dense fan of rays whose first hit lies in the cell. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void overHillsItIsWhatAllRaysSee(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        World world = World.of(hills(random));
        Position radar = new Position(0, 0, world.surfaceHeight(0, 0).orElseThrow() + random.nextDouble(2, 30));
        VisibleGround ground = new VisibleGround(world, radar);
        int seen = 0;
        for (int i = 0; i < 25; i++) {
            double azimuth = random.nextDouble(-Math.PI, Math.PI);
            double near = random.nextDouble(30, 900);
            double far = near + random.nextDouble(3, 60);
            double all = byRays(world, radar, azimuth, near, far);
            double found = ground.look(azimuth, near, far) ? width(ground) : 0.0;
            assertThat(found)
                    .as("seed %d, cell %d: %f to %f m at %f", seed, i, near, far, azimuth)
                    .isCloseTo(all, within(2 * STEP + 0.01 * all));
            seen += all > 10 * STEP ? 1 : 0;
        }
        assertThat(seen).as("seed %d", seed).isBetween(5, 24);
    }

    private static final double STEP = 5e-5;

    private static double byRays(World world, Position radar, double azimuth, double near, double far) {
        RayTracer tracer = world.newRayTracer();
        int hits = 0;
        for (double e = -1.5; e < 0.8; e += STEP) {
            double level = Math.cos(e);
            boolean isHit = tracer.closestHit(
                    radar.x(),
                    radar.y(),
                    radar.z(),
                    level * Math.sin(azimuth),
                    level * Math.cos(azimuth),
                    Math.sin(e),
                    0.0,
                    far);
            hits += isHit && tracer.distance() >= near ? 1 : 0;
        }
        return hits * STEP;
    }

    /** A square of 2 km of random heights 40 m apart, smoothed a little. */
    private static TriangleMesh hills(SplittableRandom random) {
        int side = 51;
        float[] vertices = new float[3 * side * side];
        for (int i = 0; i < side * side; i++) {
            double x = (i % side - 25) * 40.0;
            double y = (i / side - 25) * 40.0;
            vertices[3 * i] = (float) x;
            vertices[3 * i + 1] = (float) y;
            vertices[3 * i + 2] = (float) (20 * Math.sin(x / 170 + 1) * Math.cos(y / 230) + random.nextDouble(0, 8));
        }
        int[] corners = new int[6 * (side - 1) * (side - 1)];
        int at = 0;
        for (int row = 0; row < side - 1; row++) {
            for (int column = 0; column < side - 1; column++) {
                int a = row * side + column;
                for (int corner : new int[] {a, a + 1, a + side + 1, a, a + side + 1, a + side}) {
                    corners[at++] = corner;
                }
            }
        }
        return TriangleMesh.of(vertices, corners);
    }
}
