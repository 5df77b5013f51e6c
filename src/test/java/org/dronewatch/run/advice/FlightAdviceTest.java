package org.dronewatch.run.advice;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.FlightLimits;
import org.dronewatch.drone.FlightPerformance;
import org.dronewatch.flight.Airframe;
import org.dronewatch.flight.Attitude;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.flight.FlightPathSettings.Orbit;
import org.dronewatch.flight.FlightPathSettings.Waypoints;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.world.Ground;
import org.junit.jupiter.api.Test;

/** Flights that exceed what their drones can fly, with values worked out by hand. */
class FlightAdviceTest {
    private static final Position START = new Position(0, 0, 100);
    private static final Ground SLOPE = (x, y) -> x > 1000 ? OptionalDouble.empty() : OptionalDouble.of(0.1 * x);

    private static FlightPath straight(Position velocity, OptionalDouble gliding) {
        return time -> new FlightState(START.plus(velocity.times(time)), velocity, Attitude.level(0.0), gliding);
    }

    private static FlightPath straight(Position velocity) {
        return straight(velocity, OptionalDouble.empty());
    }

    private static FlightLimits limits(FlightPerformance stated) {
        return drone(Airframe.MULTIROTOR, 10.0).withPerformance(stated).flightLimits();
    }

    private static DroneSettings drone(Airframe airframe, double speed) {
        return DroneSettings.of(ModelSettings.of("none.obj"), FlightPathSettings.Hover.at(START))
                .withAirframe(airframe)
                .withSpeed(speed);
    }

    private static List<String> advice(FlightPerformance stated, Ground ground, double duration, FlightPath path) {
        List<String> lines = new ArrayList<>();
        new FlightAdvice("d", limits(stated), ground, duration).giveTo(path, lines::add);
        return lines;
    }

    @Test
    void climbAndSinkAreLimitsOfPoweredFlight() {
        FlightPerformance stated = FlightPerformance.TYPICAL.withClimb(3.0).withSink(2.0);
        assertThat(advice(stated, Ground.NONE, 10.0, straight(new Position(0, 9, 4))))
                .containsExactly("drone 'd' climbs at 4 m/s, 0.0 s after the start, at (0.0, 0.0, 100.0) m:"
                        + " its performance allows 3 m/s");
        assertThat(advice(stated, Ground.NONE, 10.0, straight(new Position(0, 9, -2.5))))
                .containsExactly("drone 'd' descends at 2.5 m/s, 0.0 s after the start, at (0.0, 0.0, 100.0) m:"
                        + " its performance allows 2 m/s");
        assertThat(advice(stated, Ground.NONE, 10.0, straight(new Position(0, 9, 3))))
                .as("exactly the limit")
                .isEmpty();
        assertThat(advice(
                        stated.withGlide(5.0, 9.0),
                        Ground.NONE,
                        10.0,
                        straight(new Position(0, 9, -2.5), OptionalDouble.of(1.0))))
                .as("gliding, by 3.6 to 1")
                .isEmpty();
    }

    @Test
    void whatGlidesTooFlatIsNamed() {
        FlightPath flat = straight(new Position(0, 10, -0.5), OptionalDouble.of(1.0));
        assertThat(advice(FlightPerformance.TYPICAL.withGlide(12.0, 10.0), Ground.NONE, 4.0, flat))
                .containsExactly("drone 'd' has a glide ratio of 20, 0.0 s after the start, at (0.0, 0.0, 100.0) m:"
                        + " its performance allows 12");
        assertThat(advice(FlightPerformance.TYPICAL, Ground.NONE, 4.0, flat))
                .as("a multirotor does not glide")
                .singleElement()
                .asString()
                .endsWith("its performance allows 0");
    }

    @Test
    void onACircleTheCourseTurnsBySpeedOverRadius() {
        FlightPath circle = Orbit.about(new Position(0, 0, 50), 50.0).create(10.0, 2.5, Ground.NONE);
        assertThat(advice(FlightPerformance.TYPICAL.withTurnRate(0.199), Ground.NONE, 60.0, circle))
                .singleElement()
                .asString()
                .as("0.2 rad/s, by the mean over half a second")
                .startsWith("drone 'd' turns at 11.4")
                .endsWith("its performance allows 11.4 deg/s");
        assertThat(advice(FlightPerformance.TYPICAL.withTurnRate(0.201), Ground.NONE, 60.0, circle))
                .isEmpty();
    }

    @Test
    void theCeilingIsAboveTheSurfaceBelow() {
        FlightPath level = straight(new Position(-10, 0, 0));
        assertThat(advice(FlightPerformance.TYPICAL.withCeiling(120.0), SLOPE, 30.0, level))
                .containsExactly("drone 'd' is at a height of 130 m, 30.0 s after the start, at (-300.0, 0.0, 100.0) m:"
                        + " its performance allows 120 m");
        assertThat(advice(FlightPerformance.TYPICAL.withCeiling(131.0), SLOPE, 30.0, level))
                .isEmpty();
        assertThat(advice(FlightPerformance.TYPICAL.withCeiling(1.0), Ground.NONE, 30.0, level))
                .as("without ground there is no height above it")
                .isEmpty();
    }

    @Test
    void whatHoversUsesItsEnduranceAndWhatHasLandedDoesNot() {
        FlightPerformance stated = FlightPerformance.TYPICAL.withEndurance(600.0);
        FlightPath hovering = time -> new FlightState(START, new Position(0, 0, 0), 0.0);
        FlightPath landed = time -> new FlightState(new Position(0, 0, 0.1), new Position(0, 0, 0), 0.0);
        assertThat(advice(stated, SLOPE, 700.0, hovering))
                .containsExactly("drone 'd' has flown under power for 700 s, 700.0 s after the start,"
                        + " at (0.0, 0.0, 100.0) m: its performance allows 600 s");
        assertThat(advice(stated, SLOPE, 600.0, hovering)).isEmpty();
        assertThat(advice(stated, SLOPE, 700.0, landed)).isEmpty();
    }

    @Test
    void aWingDoesNotStopAtACorner() {
        FlightPath corner = new Waypoints(
                        List.of(new Position(0, 0, 50), new Position(0, 50, 50), new Position(50, 50, 50)))
                .create(10.0, 2.5, Ground.NONE);
        FlightPerformance agile = FlightPerformance.TYPICAL.withTurnRate(50.0);
        assertThat(advice(agile, Ground.NONE, 60.0, corner)).isEmpty();
        assertThat(advice(agile.withHover(false), Ground.NONE, 60.0, corner))
                .as("at the corner, not where it starts and ends")
                .singleElement()
                .asString()
                .startsWith("drone 'd' hovers for 0.")
                .contains(", at (0.0, 50.0, 50.0) m");
    }

    @Test
    void unstatedLimitsAreTypicalOfTheAirframe() {
        FlightLimits quadrotor = drone(Airframe.MULTIROTOR, 10.0).flightLimits();
        assertThat(quadrotor.climb()).isEqualTo(3.0);
        assertThat(quadrotor.sink()).isEqualTo(1.5);
        assertThat(quadrotor.turnRate()).as("g tan(45 deg) / v").isCloseTo(0.980665, within(1e-12));
        assertThat(quadrotor.hover()).isTrue();
        assertThat(quadrotor.glideRatio()).isZero();

        FlightLimits wing = drone(Airframe.FIXED_WING, 20.0)
                .withPerformance(FlightPerformance.TYPICAL.withClimb(8.0))
                .flightLimits();
        assertThat(wing.climb()).as("stated").isEqualTo(8.0);
        assertThat(wing.sink()).isEqualTo(5.0);
        assertThat(wing.turnRate()).as("g tan(50 deg) / v").isCloseTo(0.5843555, within(1e-6));
        assertThat(wing.hover()).isFalse();
        assertThat(wing.leastSpeed()).as("two thirds of the cruise speed").isCloseTo(40.0 / 3.0, within(1e-12));
        assertThat(drone(Airframe.FIXED_WING, 20.0)
                        .withPerformance(FlightPerformance.TYPICAL.withLeastSpeed(16.0))
                        .flightLimits()
                        .leastSpeed())
                .isEqualTo(16.0);
        assertThat(wing.glideSpeed()).as("cruise speed").isEqualTo(20.0);
        assertThat(drone(Airframe.HYBRID, 20.0).flightLimits().hover()).isTrue();
    }
}
