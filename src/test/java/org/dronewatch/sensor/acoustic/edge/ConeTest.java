package org.dronewatch.sensor.acoustic.edge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import java.util.concurrent.ThreadLocalRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The directions in which surfaces leave a point of an outline. */
class ConeTest {
    private static void add(Cone cone, double degrees) {
        cone.add(Math.cos(Math.toRadians(degrees)), Math.sin(Math.toRadians(degrees)));
    }

    /** Two surfaces at an angle to each other bend the outline by what that angle lacks of 180 degrees. */
    @ParameterizedTest
    @CsvSource({"0, 90, 90", "0, 179, 1", "350, 10, 160", "90, 0, 90", "200, 260, 120", "-1, 1, 178"})
    void twoSurfacesBendTheOutline(double one, double other, double bend) {
        Cone cone = new Cone();
        add(cone, one);
        add(cone, other);

        assertThat(cone.isCorner()).isTrue();
        assertThat(Math.toDegrees(cone.bend())).isCloseTo(bend, within(1e-9));
        double middle = Math.toRadians(0.5 * (one + other) + (Math.abs(one - other) > 180 ? 180 : 0));
        assertThat(cone.middleU()).isCloseTo(Math.cos(middle), within(1e-12));
        assertThat(cone.middleV()).isCloseTo(Math.sin(middle), within(1e-12));
    }

    /** The edge of a sheet bends by half a turn; nothing at all, a straight outline and a star are no corners. */
    @Test
    void whatIsNoCorner() {
        Cone cone = new Cone();
        assertThat(cone.isCorner()).isFalse();
        add(cone, 30);
        assertThat(cone.isCorner()).isTrue();
        assertThat(cone.bend()).isCloseTo(Math.PI, within(1e-12));
        add(cone, 210);
        assertThat(cone.isCorner()).isFalse();
        cone.clear();
        add(cone, 0);
        add(cone, 120);
        add(cone, 240);
        assertThat(cone.isCorner()).isFalse();
    }

    /** Whatever their order, the cone is the narrowest one that contains all directions. */
    @Test
    void theOrderOfDirectionsDoesNotMatter() {
        long seed = ThreadLocalRandom.current().nextLong();
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < 1000; i++) {
            double start = random.nextDouble(360);
            double width = random.nextDouble(5, 175);
            int count = random.nextInt(1, 6);
            double[] degrees = new double[count + 2];
            for (int k = 0; k < count; k++) {
                degrees[k] = start + random.nextDouble(width);
            }
            degrees[count] = start;
            degrees[count + 1] = start + width;
            for (int k = degrees.length - 1; k > 0; k--) {
                int other = random.nextInt(k + 1);
                double swap = degrees[k];
                degrees[k] = degrees[other];
                degrees[other] = swap;
            }
            Cone cone = new Cone();
            for (double direction : degrees) {
                add(cone, direction);
            }
            assertThat(cone.isCorner()).as("seed %d, cone %d", seed, i).isTrue();
            assertThat(Math.toDegrees(cone.bend()))
                    .as("seed %d, cone %d", seed, i)
                    .isCloseTo(180 - width, within(1e-6));
        }
    }
}
