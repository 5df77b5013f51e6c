package org.dronewatch.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.dronewatch.geometry.Position;
import org.dronewatch.world.Ground;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What is commanded is flown: between two commands velocity is constant, and the position is its integral. */
class SteeredFlightTest {
    private static final Position START = new Position(3, -4, 50);
    private static final double SPEED = 20.0;

    private final SteeredFlight flight = Steered.from(START).create(SPEED, 2.5, Ground.NONE);

    @Test
    void itHoversUntilTheFirstCommand() {
        flight.advance(5.0);
        assertThat(flight.at(5.0)).isEqualTo(new FlightState(START, new Position(0, 0, 0), 0.0));
    }

    /** Twenty random velocities at random times, against their integral added up here. */
    @Test
    void thePositionIsTheIntegralOfTheVelocities() {
        long seed = 20261;
        Random random = new Random(seed);
        double time = 0.0;
        double x = START.x();
        double y = START.y();
        double z = START.z();
        Position velocity = new Position(0, 0, 0);
        for (int i = 0; i < 20; i++) {
            double next = time + random.nextDouble();
            x += velocity.x() * (next - time);
            y += velocity.y() * (next - time);
            z += velocity.z() * (next - time);
            time = next;
            velocity = new Position(random.nextDouble() * 10, random.nextDouble() * 10, random.nextDouble());
            flight.fly(time, velocity);
            assertThat(flight.at(time).position().distance(new Position(x, y, z)))
                    .as("seed " + seed)
                    .isLessThan(1e-9);
            assertThat(flight.at(time).velocity()).isEqualTo(velocity);
        }
        flight.advance(100.0);
        Position expected = new Position(x, y, z).plus(velocity.times(100.0 - time));
        assertThat(flight.at(100.0).position().distance(expected)).isLessThan(1e-9);
    }

    /** A run may be as short as the smallest number: a quotient of two differences over it is not a number. */
    @Test
    void withinTheFirstNanosecondNothingAccelerates() {
        flight.fly(0.0, new Position(10, 0, 1));
        assertThat(flight.acceleration(Double.MIN_VALUE)).isEqualTo(new Position(0, 0, 0));
        RecordedFlight recorded = new RecordedFlight(flight.legs());
        assertThat(recorded.acceleration(Double.MIN_VALUE)).isEqualTo(new Position(0, 0, 0));
    }

    @Test
    void thePastStaysAsItWasFlown() {
        flight.fly(0.0, new Position(10, 0, 0));
        flight.fly(2.0, new Position(0, 10, 0));
        flight.fly(4.0, new Position(0, 0, -5));
        assertThat(flight.at(1.0).position()).isEqualTo(START.plus(new Position(10, 0, 0)));
        assertThat(flight.at(1.0).heading()).isCloseTo(0.5 * Math.PI, within(1e-15));
        assertThat(flight.at(3.0).position()).isEqualTo(START.plus(new Position(20, 10, 0)));
        assertThat(flight.at(4.0).heading()).as("straight down the nose stays").isZero();
        assertThat(flight.legs()).hasSize(3);
    }

    @Test
    void theLastCommandOfATimeCounts() {
        flight.fly(1.0, new Position(10, 0, 0));
        flight.fly(1.0, new Position(0, 5, 0), new Attitude(1.0, 0.2, -0.3));
        flight.advance(3.0);
        assertThat(flight.at(3.0))
                .isEqualTo(new FlightState(
                        START.plus(new Position(0, 10, 0)), new Position(0, 5, 0), new Attitude(1.0, 0.2, -0.3)));
        assertThat(flight.legs()).hasSize(2);
    }

    @Test
    void itReachesAPointAtATimeAndHoversThere() {
        Position target = new Position(33, 36, 40);
        flight.flyTo(1.0, target, 6.0);
        flight.advance(9.0);
        assertThat(flight.at(3.5).position().distance(START.plus(target).times(0.5)))
                .isLessThan(1e-12);
        assertThat(flight.at(3.5).velocity()).isEqualTo(target.minus(START).times(0.2));
        assertThat(flight.at(6.0).position().distance(target)).isLessThan(1e-12);
        assertThat(flight.at(6.0).velocity()).isEqualTo(new Position(0, 0, 0));
        assertThat(flight.at(9.0)).isEqualTo(flight.at(6.0));
    }

    @Test
    void anotherCommandEndsTheWayToAPoint() {
        flight.flyTo(0.0, START.plus(new Position(100, 0, 0)), 10.0);
        flight.fly(2.0, new Position(0, 0, 1));
        flight.advance(20.0);
        assertThat(flight.at(20.0).position()).isEqualTo(START.plus(new Position(20, 0, 18)));
    }

    @Test
    void fasterThanItsSpeedItCannotFly() {
        flight.fly(0.0, new Position(SPEED, 0, 0));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> flight.fly(1.0, new Position(15, 15, 0)))
                .withMessage("speed 21.213203 m/s must be at most the drone's 20.0 m/s");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> flight.flyTo(1.0, START.plus(new Position(20, 0, 41)), 3.0))
                .withMessage("speed 20.5 m/s must be at most the drone's 20.0 m/s");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> flight.flyTo(1.0, START, 1.0))
                .withMessage("arrival at 1.0 s must be after the command, at 1.0 s");
        flight.advance(2.0);
        assertThat(flight.at(2.0).position()).as("nothing was changed").isEqualTo(START.plus(new Position(40, 0, 0)));
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
    void aTimeThatIsNotFiniteIsRefusedAndChangesNothing(double value) {
        flight.fly(0.0, new Position(1, 0, 0));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> flight.flyTo(1.0, START, value))
                .withMessageContaining("arrival at " + value + " s");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> flight.fly(value, new Position(1, 0, 0)))
                .withMessage("a command at " + value + " s: its time must be a finite number");
        flight.advance(2.0);
        assertThat(flight.at(2.0).position()).isEqualTo(START.plus(new Position(2, 0, 0)));
        assertThat(flight.legs()).hasSize(1);
    }

    @Test
    void anArrivalTooSoonIsRefusedByItsSpeed() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> flight.flyTo(0.0, START.plus(new Position(1, 0, 0)), Double.MIN_VALUE))
                .withMessageStartingWith("speed Infinity m/s must be at most ");
        flight.flyTo(0.0, START, Double.MIN_VALUE);
        flight.advance(1.0);
        assertThat(flight.at(1.0).position()).isEqualTo(START);
    }

    /** Commands at every millisecond, each of which discards a plan for later: the time for one must not grow. */
    @Test
    void manyCommandsKeepOnlyWhatWasFlown() {
        for (int i = 1; i <= 200_000; i++) {
            flight.flyTo(1e-3 * i, START, 1e3);
        }
        flight.advance(200.0);
        assertThat(flight.legs()).hasSize(200_001);
        assertThat(flight.at(200.0).position()).isEqualTo(START);
    }

    @Test
    void theFutureIsNotKnown() {
        flight.fly(2.0, new Position(1, 0, 0));
        assertThatIllegalStateException()
                .isThrownBy(() -> flight.at(2.1))
                .withMessage("where a steered drone will be at 2.1 s is not known at 2.0 s");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> flight.fly(1.9, new Position(1, 0, 0)))
                .withMessageContaining("1.9 s must not be before 2.0 s");
        flight.end();
        assertThatIllegalStateException().isThrownBy(() -> flight.fly(3.0, new Position(1, 0, 0)));
    }

    @Test
    void whatSensorsHaveSeenIsNotChangedByTheAnswerToIt() {
        flight.fly(0.0, new Position(10, 0, 0));
        flight.look(1.0);
        FlightState seen = flight.at(1.0);
        flight.fly(1.0, new Position(0, 10, 0));
        assertThat(flight.at(1.0)).isEqualTo(seen);
        flight.fly(1.0, new Position(0, -10, 0));
        flight.advance(2.0);
        assertThat(flight.at(1.0)).isEqualTo(seen);
        assertThat(flight.at(2.0).position().distance(START.plus(new Position(10, -10, 0))))
                .isLessThan(1e-12);
        assertThat(flight.legs()).hasSize(2);
        assertThat(flight.legs().get(1).time()).isEqualTo(Math.nextUp(1.0));
    }
}
