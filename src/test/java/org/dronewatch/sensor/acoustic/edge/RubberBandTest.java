package org.dronewatch.sensor.acoustic.edge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.concurrent.ThreadLocalRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The taut string round an outline in a plane. */
class RubberBandTest {
    private static final double DISTANCE = 100;

    private final CutOutline outline = new CutOutline(1e-4);
    private final RubberBand band = new RubberBand();

    private void polyline(double... coordinates) {
        for (int i = 0; i + 3 < coordinates.length; i += 2) {
            outline.add(
                    outline.point(coordinates[i], coordinates[i + 1]),
                    outline.point(coordinates[i + 2], coordinates[i + 3]));
        }
    }

    private boolean find(double limit) {
        outline.finish();
        return band.find(outline, DISTANCE, limit);
    }

    @Test
    void withNothingBetweenItIsStraight() {
        outline.clear(10);
        polyline(20, 3, 80, 3);
        assertThat(find(200)).isTrue();
        assertThat(band.length()).isEqualTo(DISTANCE);
        assertThat(band.corners()).isZero();
    }

    @Test
    void roundTheNearerEndOfASheet() {
        outline.clear(10);
        polyline(40, -7, 40, 30);
        assertThat(find(200)).isTrue();
        assertThat(band.length()).isCloseTo(Math.hypot(40, 7) + Math.hypot(60, 7), within(1e-9));
        assertThat(band.corners()).isEqualTo(1);
        assertThat(band.v(0)).isEqualTo(-7);
        assertThat(band.bend(0)).isCloseTo(Math.PI, within(1e-9));
    }

    /** A limit is one of length, and a closed wall has no way round. */
    @Test
    void noWayWithinALimitOrThroughAClosedRoom() {
        outline.clear(10);
        polyline(40, -7, 40, 30);
        assertThat(find(101)).isFalse();
        outline.clear(10);
        polyline(-5, -5, 5, -5, 5, 5, -5, 5, -5, -5);
        assertThat(find(10_000)).isFalse();
    }

    /** In and out of two chicanes. */
    @Test
    void zigzag() {
        outline.clear(10);
        polyline(30, -1000, 30, 10);
        polyline(70, -10, 70, 1000);
        double length = Math.hypot(30, 10) + Math.hypot(40, 20) + Math.hypot(30, 10);
        assertThat(find(200)).isTrue();
        assertThat(band.length()).isCloseTo(length, within(1e-9));
        assertThat(band.corners()).isEqualTo(2);
    }

    /** Over random roofs on the ground the way is their upper convex hull. */
    @Test
    void overRoofsItIsTheConvexHull() {
        long seed = ThreadLocalRandom.current().nextLong();
        SplittableRandom random = new SplittableRandom(seed);
        for (int round = 0; round < 200; round++) {
            int count = random.nextInt(1, 12);
            double[] corners = new double[2 * count];
            for (int i = 0; i < count; i++) {
                corners[2 * i] = (i + 0.5 + 0.4 * random.nextDouble(-1, 1)) * DISTANCE / count;
                corners[2 * i + 1] = random.nextDouble(-1, 25);
            }
            double[] coordinates = Stream.of(
                            new double[] {-2000, -1, 0, -1}, corners, new double[] {DISTANCE, -1, 2000, -1})
                    .flatMapToDouble(Arrays::stream)
                    .toArray();
            outline.clear(20);
            polyline(coordinates);
            // Ends of the ground are sheets' ends: far below nothing leads round them within the limit.
            assertThat(find(400)).as("seed %d, round %d", seed, round).isTrue();
            assertThat(band.length()).as("seed %d, round %d", seed, round).isCloseTo(hull(corners), within(1e-6));
        }
    }

    /** The length of the upper hull of both ends and the corners, by gift wrapping. */
    private static double hull(double[] corners) {
        double u = 0;
        double v = 0;
        double length = 0;
        while (u < DISTANCE) {
            double nextU = DISTANCE;
            double nextV = 0;
            for (int i = 0; i < corners.length; i += 2) {
                double cu = corners[i];
                double cv = corners[i + 1];
                if (cu > u && (cv - v) * (nextU - u) > (nextV - v) * (cu - u)) {
                    nextU = cu;
                    nextV = cv;
                }
            }
            length += Math.hypot(nextU - u, nextV - v);
            u = nextU;
            v = nextV;
        }
        return length;
    }
}
