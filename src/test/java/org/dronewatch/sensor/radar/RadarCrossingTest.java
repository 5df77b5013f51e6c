package org.dronewatch.sensor.radar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dronewatch.sensor.Walls.assess;
import static org.dronewatch.sensor.Walls.behind;
import static org.dronewatch.sensor.Walls.cube;
import static org.dronewatch.sensor.Walls.look;
import static org.dronewatch.sensor.Walls.open;
import static org.dronewatch.sensor.Walls.wall;

import java.util.OptionalDouble;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.RadarSignature;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.radar.DopplerFilter.Canceller;
import org.dronewatch.sensor.radar.DopplerFilter.HighPass;
import org.dronewatch.sensor.radar.LinkBudget.Hardware;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Where a notch hides drones that cross or hover, and what their rotors show. */
class RadarCrossingTest {
    private static final Hardware BUDGET = new Hardware(0.1, 25, 0.02, 10e6, 5, 6);
    private static final RadarSettings RADAR = RadarSettings.at(new Position(0, 0, 0), BUDGET)
            .withFieldOfView(2 * Math.PI, Math.PI)
            .withNotch(new HighPass(2.0, 2));

    private static double free(double range) {
        return BUDGET.signalToNoise(10e9, 0.01, range);
    }

    private static Drone withRotors(double level, Position place, Position velocity) {
        DroneSettings settings = DroneSettings.of(ModelSettings.of("cube.obj"), Hover.at(place));
        return cube(settings.withRadar(settings.radar().withRotorLevel(level)), place, velocity);
    }

    /** All round on a circle the radial speed is 0: nothing is left, however near and fast. */
    @ParameterizedTest
    @ValueSource(doubles = {100, 400})
    void onACircleItIsNeverSeen(double radius) {
        for (double bearing = 0; bearing < 2 * Math.PI; bearing += 0.1) {
            Position place = new Position(radius * Math.sin(bearing), radius * Math.cos(bearing), 0);
            Drone drone = cube(place, new Position(30 * Math.cos(bearing), -30 * Math.sin(bearing), 0));
            Assessment one = assess(RADAR, open(), drone);
            // Rounding leaves 1e-15 m/s.
            assertThat(one.quantity()).isLessThan(-500.0);
            assertThat(one.cause()).isEqualTo(Cause.TOO_SLOW);
            assertThat(look(RADAR, open(), drone, 0).isDetected()).isFalse();
        }
    }

    /**
     * A straight pass at b = 300 m with v = 10 m/s: the radial speed is {@code v x / sqrt(x^2 + b^2)}, and the echo
     * fades by {@code 10 lg(1 + (w / vr)^4)}. It is lost where that exceeds what the radar equation leaves over 15 dB.
     */
    @ParameterizedTest
    @CsvSource({"300, 10", "150, 4", "250, 40"})
    void aPassFadesAboutItsClosestPoint(double closest, double speed) {
        double edge = edge(closest, speed);
        int lost = 0;
        for (double x = -600; x <= 600; x += 1.0) {
            double range = Math.hypot(x, closest);
            Drone drone = cube(new Position(x, closest, 0), new Position(speed, 0, 0));
            Observation seen = look(RADAR, open(), drone, 0);
            double radial = speed * x / range;
            double expected = free(range) - 10 * Math.log10(1 + Math.pow(2.0 / radial, 4));
            if (x != 0.0) {
                assertThat(seen.value()).isCloseTo(expected, within(1e-9));
                assertThat(seen.figures().get("notch_db")).isCloseTo(expected - free(range), within(1e-9));
            }
            assertThat(seen.isDetected()).as("at %f m, edge %f m", x, edge).isEqualTo(Math.abs(x) > edge);
            lost += seen.isDetected() ? 0 : 1;
        }
        assertThat(lost).isEqualTo(2 * (int) edge + 1).isGreaterThan(5);
    }

    /** Where the echo of a pass falls below 15 dB, m before and behind the closest point, by halving. */
    private static double edge(double closest, double speed) {
        double blind = 0;
        double seen = 590;
        for (int i = 0; i < 60; i++) {
            double x = 0.5 * (blind + seen);
            double range = Math.hypot(x, closest);
            double ratio = free(range) - 10 * Math.log10(1 + Math.pow(2.0 * range / (speed * x), 4));
            blind = ratio < 15.0 ? x : blind;
            seen = ratio < 15.0 ? seen : x;
        }
        return seen;
    }

    /** The explanation names the radial speed from which on it would be seen. */
    @Test
    void aMissNamesTheSpeedThatWouldDo() {
        Position place = new Position(0, 300, 0);
        Assessment slow = assess(RADAR, open(), cube(place, new Position(0, -0.4, 0)));
        assertThat(slow.cause()).isEqualTo(Cause.TOO_SLOW);
        double limit = slow.limit().orElseThrow();
        assertThat(assess(RADAR, open(), cube(place, new Position(0, -1.001 * limit, 0)))
                        .cause())
                .isEqualTo(Cause.DETECTED);
        assertThat(assess(RADAR, open(), cube(place, new Position(0, -0.999 * limit, 0)))
                        .cause())
                .isEqualTo(Cause.TOO_SLOW);
        RadarSettings canceller = RADAR.withNotch(new Canceller(3, 30));
        Assessment blind = assess(canceller, open(), cube(place, new Position(0, -29.9, 0)));
        assertThat(blind.cause()).isEqualTo(Cause.TOO_FAST);
        double highest = blind.limit().orElseThrow();
        assertThat(assess(canceller, open(), cube(place, new Position(0, -0.999 * highest, 0)))
                        .cause())
                .isEqualTo(Cause.DETECTED);
    }

    /** Too slow only if it would be detected without the notch: otherwise too weak, or hidden. */
    @Test
    void otherCausesStay() {
        Drone far = cube(new Position(0, 3000, 0), new Position(0, -0.1, 0));
        assertThat(assess(RADAR, open(), far).cause()).isEqualTo(Cause.TOO_WEAK);
        Drone hidden = cube(new Position(0, 300, 0), new Position(0, -0.1, 0));
        assertThat(assess(RADAR, behind(wall(200, -99, 99), ModelRole.BUILDING), hidden)
                        .cause())
                .isEqualTo(Cause.HIDDEN_BY_BUILDING);
        Drone fast = cube(new Position(0, 300, 0), new Position(0, -210, 0));
        assertThat(assess(RADAR, open(), fast).cause()).isEqualTo(Cause.TOO_FAST);
        Drone low = cube(new Position(0, 5, 0), new Position(0, -0.1, 0));
        assertThat(assess(RADAR, open(), low).cause()).isEqualTo(Cause.OUT_OF_RANGE);
    }

    /** The notch takes the place of the minimum radial speed, which stays a hard limit where there is none. */
    @Test
    void theNotchReplacesTheHardLimit() {
        Drone slow = cube(new Position(0, 100, 0), new Position(0, -0.9, 0));
        assertThat(look(RADAR, open(), slow, 0).isDetected()).isTrue();
        RadarSettings hard = RadarSettings.at(new Position(0, 0, 0), BUDGET).withFieldOfView(2 * Math.PI, Math.PI);
        assertThat(look(hard, open(), slow, 0).value()).isEqualTo(Double.NEGATIVE_INFINITY);
        assertThat(assess(hard, open(), slow).limit()).isEqualTo(OptionalDouble.of(1.0));
    }

    /** Rotors 20 dB below the body: hovering, 0.01 / 101 m2 are left; moving fast, all of it, whatever their level. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 10, 20, 40})
    void aHoveringDroneIsSeenByItsRotors(double level) {
        Position place = new Position(0, 300, 0);
        double rotors = 1 / (1 + Math.pow(10, level / 10));
        double hovering = look(RADAR, open(), withRotors(level, place, new Position(0, 0, 0)), 0)
                .value();
        assertThat(hovering).isCloseTo(free(300) + 10 * Math.log10(rotors), within(1e-9));
        double fast = look(RADAR, open(), withRotors(level, place, new Position(0, -150, 0)), 0)
                .value();
        assertThat(fast).isCloseTo(free(300), within(1e-6));
        double both = look(RADAR, open(), withRotors(level, place, new Position(0, -2, 0)), 0)
                .value();
        assertThat(both).isCloseTo(free(300) + 10 * Math.log10(rotors + 0.5 * (1 - rotors)), within(1e-9));
    }

    /** Rotors shorten the range to a fourth root, and take the limit of speed along. */
    @Test
    void rotorsAreSeenToAFourthRootOfTheRange() {
        double reach = BUDGET.range(10e9, 0.01 / 101, 15.0);
        Position still = new Position(0, 0, 0);
        Assessment near = assess(RADAR, open(), withRotors(20, new Position(0, 0.999 * reach, 0), still));
        assertThat(near.cause()).isEqualTo(Cause.DETECTED);
        Assessment beyond = assess(RADAR, open(), withRotors(20, new Position(0, 1.001 * reach, 0), still));
        assertThat(beyond.cause()).isEqualTo(Cause.TOO_SLOW);
        // 0.1 % farther takes 0.017 dB: the body must bring 0.4 % of the rotors' share, (v / 2 m/s)^4 = 0.004 / 100.
        assertThat(beyond.limit().orElseThrow()).isCloseTo(2 * Math.pow(0.004 / 100, 0.25), within(0.002));
    }

    /** Rotors as strong as the body leave the body less to bring: the speed that is named is the one that it needs. */
    @Test
    void aMissNamesTheSpeedThatTheBodyNeedsBesideStrongRotors() {
        double reach = BUDGET.range(10e9, 0.5 * 0.01, 15.0);
        Position place = new Position(0, 1.1 * reach, 0);
        Assessment hovering = assess(RADAR, open(), withRotors(0, place, new Position(0, 0, 0)));
        assertThat(hovering.cause()).isEqualTo(Cause.TOO_SLOW);
        double limit = hovering.limit().orElseThrow();
        assertThat(assess(RADAR, open(), withRotors(0, place, new Position(0, -1.001 * limit, 0)))
                        .cause())
                .isEqualTo(Cause.DETECTED);
        assertThat(assess(RADAR, open(), withRotors(0, place, new Position(0, -0.999 * limit, 0)))
                        .cause())
                .isEqualTo(Cause.TOO_SLOW);
    }

    /** With its motors off it shows no rotors; a radar without a notch has no use for them. */
    @Test
    void aGlidingDroneHasNoRotors() {
        Position place = new Position(0, 200, 0);
        Position across = new Position(10, 0, 0);
        Drone powered = withRotors(20, place, across);
        assertThat(look(RADAR, open(), powered, 0).isDetected()).isTrue();
        Drone gliding = powered.at(new FlightState(place, across, 0.0, OptionalDouble.of(5.0)));
        assertThat(gliding.isPowered()).isFalse();
        assertThat(assess(RADAR, open(), gliding).cause()).isEqualTo(Cause.TOO_SLOW);
        RadarSettings hard = RadarSettings.at(new Position(0, 0, 0), BUDGET).withFieldOfView(2 * Math.PI, Math.PI);
        assertThat(assess(hard, open(), powered).cause()).isEqualTo(Cause.TOO_SLOW);
        Drone coming = withRotors(20, place, new Position(0, -10, 0));
        assertThat(look(hard, open(), coming, 0).value()).isCloseTo(free(200), within(1e-9));
    }

    @Test
    void aSignatureKeepsItsCrossSection() {
        RadarSignature signature = RadarSignature.DEFAULT.withRotorLevel(10);
        assertThat(signature.rotorFraction()).isCloseTo(1.0 / 11, within(1e-15));
        assertThat(signature.mean()).isEqualTo(0.01);
        assertThat(RadarSignature.DEFAULT.rotorFraction()).isZero();
    }
}
