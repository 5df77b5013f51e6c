package org.dronewatch.sensor.radar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Direction;
import org.dronewatch.positioner.Sighting;
import org.junit.jupiter.api.Test;

/** The errors of a radar's measurements. */
class AccuracyTest {
    private static final long SEED = 20_261_201;
    private static final int LOOKS = 20_000;
    private static final Position RADAR = new Position(7, -5, 3);
    private static final Direction WAY = new Direction(0.5, 0.2);
    private static final double RANGE = 800;
    private static final Position PLACE = RADAR.plus(WAY.unit().times(RANGE));

    /** Mean and root mean square of normal errors, which 20,000 looks show to one in fifty. */
    private static void assertNormal(Accuracy accuracy, double deviation, ToDoubleFunction<Sighting> error) {
        SplittableRandom random = new SplittableRandom(SEED);
        double sum = 0;
        double squares = 0;
        for (int i = 0; i < LOOKS; i++) {
            double one = error.applyAsDouble(accuracy.sighting(RADAR, PLACE, 0, random));
            sum += one;
            squares += one * one;
        }
        assertThat(sum / LOOKS).as("seed %d", SEED).isCloseTo(0, within(4 * deviation / Math.sqrt(LOOKS)));
        assertThat(Math.sqrt(squares / LOOKS))
                .as("seed %d", SEED)
                .isCloseTo(deviation, within(4 * deviation / Math.sqrt(2.0 * LOOKS)));
    }

    @Test
    void eachErrorHasItsStandardDeviation() {
        Accuracy accuracy = new Accuracy(12, 0.03, 0.01, true);
        assertNormal(accuracy, 12, seen -> seen.range().orElseThrow() - RANGE);
        assertNormal(accuracy, 0.03, seen -> seen.direction().azimuth() - WAY.azimuth());
        assertNormal(accuracy, 0.01, seen -> seen.direction().elevation() - WAY.elevation());
    }

    @Test
    void withoutErrorsThePlaceIsFound() {
        Position found = new Accuracy(0, 0, 0, true)
                .sighting(RADAR, PLACE, 0, new SplittableRandom(SEED))
                .position()
                .orElseThrow();
        assertThat(found.distance(PLACE)).isCloseTo(0, within(1e-9));
    }
}
