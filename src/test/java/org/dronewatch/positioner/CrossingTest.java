package org.dronewatch.positioner;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.dronewatch.geometry.Position;
import org.junit.jupiter.api.Test;

/** The range at which two lines of sight cross. */
class CrossingTest {
    private static final Position HERE = new Position(0, 0, 10);
    private static final Position THERE = new Position(60, 0, 10);
    private static final Position DRONE = new Position(-20, 300, 80);

    private static Bearing bearing(Position from, Position to, double error) {
        return bearing(from, Direction.of(to.minus(from)), error);
    }

    private static Bearing bearing(Position from, Direction direction, double error) {
        return new Bearing(
                new Sighting(from, direction, OptionalDouble.empty(), true, error, OptionalDouble.empty()), 0.0);
    }

    @Test
    void twoDirectionsGiveTheRange() {
        Optional<Crossing> found = Crossing.of(bearing(HERE, DRONE, 0.0), bearing(THERE, DRONE, 0.0), 0.0);

        assertThat(found.orElseThrow().range()).isCloseTo(HERE.distance(DRONE), within(1e-6));
    }

    /** Many measurements with errors scatter as much as is said of one. */
    @Test
    void itsErrorIsThatOfManyMeasurements() {
        long seed = 20261124;
        System.out.println("seed " + seed);
        SplittableRandom random = new SplittableRandom(seed);
        double error = 0.004;
        double sum = 0.0;
        double squares = 0.0;
        int count = 20_000;
        for (int i = 0; i < count; i++) {
            Direction one = shaken(HERE, error, random);
            Direction other = shaken(THERE, 2.0 * error, random);
            double range = Crossing.of(bearing(HERE, one, error), bearing(THERE, other, 2.0 * error), 0.0)
                    .orElseThrow()
                    .range();
            sum += range;
            squares += range * range;
        }
        double deviation = Math.sqrt(squares / count - sum / count * (sum / count));
        double said = Crossing.of(bearing(HERE, DRONE, error), bearing(THERE, DRONE, 2.0 * error), 0.0)
                .orElseThrow()
                .error();
        assertThat(said).isGreaterThan(10.0);
        assertThat(deviation).isCloseTo(said, within(0.06 * said));
    }

    private static Direction shaken(Position from, double error, SplittableRandom random) {
        Direction exact = Direction.of(DRONE.minus(from));
        return exact.turned(error * random.nextGaussian() / Math.cos(exact.elevation()), error * random.nextGaussian());
    }

    /** Closed form for a right angle at the drone: the error across the other line is that along the first. */
    @Test
    void atARightAngleTheErrorIsThatOfTheOtherSensor() {
        Bearing north = bearing(new Position(0, 0, 0), new Position(0, 400, 0), 0.01);
        Bearing west = bearing(new Position(500, 400, 0), new Position(0, 400, 0), 0.02);

        Crossing crossing = Crossing.of(north, west, 0.0).orElseThrow();
        assertThat(crossing.range()).isCloseTo(400.0, within(1e-9));
        assertThat(crossing.error()).isCloseTo(500.0 * 0.02, within(1e-9));
    }

    @Test
    void parallelLinesAndThoseFromOnePlaceGiveNone() {
        Direction north = new Direction(0, 0.1);
        assertThat(Crossing.of(bearing(HERE, north, 0.0), bearing(THERE, north, 0.0), 0.0))
                .isEmpty();
        assertThat(Crossing.of(bearing(HERE, DRONE, 0.01), bearing(HERE, DRONE, 0.01), 0.0))
                .isEmpty();
        // Two directions from one place that differ by their errors do not meet there.
        assertThat(Crossing.of(bearing(HERE, DRONE, 0.02), bearing(HERE, shifted(0.03), 0.02), 0.0))
                .isEmpty();
        // 60 m apart at 5 km, 0.7 degrees, with errors of 0.3 degrees.
        Position far = new Position(0, 5000, 10);
        assertThat(Crossing.of(bearing(HERE, far, 0.005), bearing(THERE, far, 0.005), 0.0))
                .isEmpty();
    }

    private static Direction shifted(double angle) {
        return Direction.of(DRONE.minus(HERE)).turned(angle, 0.0);
    }

    @Test
    void linesThatWouldMeetBehindASensorOrMissEachOtherGiveNone() {
        Bearing away = bearing(HERE, new Position(-100, 300, 10), 0.0);
        Bearing apart = bearing(THERE, new Position(200, 300, 10), 0.0);
        assertThat(Crossing.of(away, apart, 0.0)).isEmpty();
        // The first would meet the line of the second beyond the second's back.
        Bearing back = bearing(THERE, THERE.plus(THERE.minus(DRONE)), 0.0);
        assertThat(Crossing.of(bearing(HERE, DRONE, 0.0), back, 0.0)).isEmpty();
        Position above = DRONE.plus(new Position(0, 0, 40));
        assertThat(Crossing.of(bearing(HERE, DRONE, 0.0), bearing(THERE, above, 0.0), 0.0))
                .isEmpty();
    }

    /** Both directions are taken at the same time, although one of them is older. */
    @Test
    void anOlderDirectionIsPredicted() {
        Position velocity = new Position(20, 0, 0);
        Bearing one = bearing(HERE, DRONE, 0.0);
        Bearing other = bearing(THERE, DRONE, 0.0);
        for (int look = 1; look <= 40; look++) {
            Position at = DRONE.plus(velocity.times(0.1 * look));
            one.add(sighting(HERE, at), 0.1 * look, 3.5);
            Position later = at.plus(velocity.times(0.05));
            other.add(sighting(THERE, later), 0.1 * look + 0.05, 3.5);
        }
        Position now = DRONE.plus(velocity.times(4.5));
        // Half a second after the last of them the drone is 10 m farther on.
        assertThat(Crossing.of(one, other, 4.5).orElseThrow().range()).isCloseTo(HERE.distance(now), within(2.0));
    }

    private static Sighting sighting(Position from, Position to) {
        return new Sighting(from, Direction.of(to.minus(from)), OptionalDouble.empty());
    }
}
