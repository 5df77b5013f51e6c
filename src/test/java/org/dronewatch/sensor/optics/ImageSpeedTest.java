package org.dronewatch.sensor.optics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.junit.jupiter.api.Test;

class ImageSpeedTest {
    private static final Position CAMERA = new Position(10, 20, 5);
    private static final Position STILL = new Position(0, 0, 0);

    private static double turning(Position drone, Position velocity) {
        return ImageSpeed.turning(CAMERA, drone, velocity, Optional.empty());
    }

    /** The speed across the line of sight over the range. */
    @Test
    void theLineOfSightTurnsAsFastAsTheDroneCrossesIt() {
        Position ahead = CAMERA.plus(new Position(30, 40, 0));
        assertThat(turning(ahead, new Position(3, 4, 0))).as("straight away").isCloseTo(0.0, within(1e-12));
        assertThat(turning(ahead, new Position(-4, 3, 0))).as("sideways").isCloseTo(0.1, within(1e-12));
        assertThat(turning(ahead, new Position(-4, 3, 12))).as("and up").isCloseTo(0.26, within(1e-12));
        assertThat(turning(CAMERA.plus(new Position(0, 0, 50)), new Position(3, 4, 0)))
                .as("above")
                .isCloseTo(0.1, within(1e-12));
    }

    /** There the line of sight has no direction. */
    @Test
    void atTheLensItIsANumber() {
        assertThat(turning(CAMERA, STILL)).isZero();
        assertThat(turning(CAMERA, new Position(1, 1, 1))).isNotNegative();
    }
}
