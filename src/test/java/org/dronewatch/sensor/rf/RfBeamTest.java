package org.dronewatch.sensor.rf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dronewatch.sensor.Walls.assess;
import static org.dronewatch.sensor.Walls.behind;
import static org.dronewatch.sensor.Walls.cube;
import static org.dronewatch.sensor.Walls.look;
import static org.dronewatch.sensor.Walls.open;
import static org.dronewatch.sensor.Walls.wall;

import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.RadioLink;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.radio.AntennaPattern;
import org.dronewatch.sensor.radio.LinearPolarisation;
import org.dronewatch.sensor.radio.ReflectingGround;
import org.dronewatch.sensor.radio.TwoRays;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A receiver whose antenna points in one direction. */
class RfBeamTest {
    private static final RfSettings ROUND = RfSettings.at(new Position(0, 0, 0)).withGain(12);
    private static final AntennaPattern BEAM = AntennaPattern.of(Math.toRadians(60), Math.toRadians(20));
    private static final RfSettings EAST =
            ROUND.withBeam(BEAM).withAim(new Aim.Direction(Math.toRadians(90), Math.toRadians(5)));

    private static Drone emitting(Position place, RadioLink link) {
        DroneSettings settings =
                DroneSettings.of(ModelSettings.of("cube.obj"), Hover.at(place)).withRadio(link);
        return cube(settings, place, new Position(0, 0, 0));
    }

    private static Drone at(double azimuth, double elevation, double range) {
        double a = Math.toRadians(azimuth);
        double e = Math.toRadians(elevation);
        return emitting(
                new Position(range * Math.cos(e) * Math.sin(a), range * Math.cos(e) * Math.cos(a), range * Math.sin(e)),
                RadioLink.DEFAULT);
    }

    /** On the axis as without a beam; off it as table 7.3-1 of 3GPP TR 38.901 says; behind, the side lobes. */
    @ParameterizedTest
    @CsvSource({"90, 5, 0", "90, 15, -3", "90, -5, -3", "90, 25, -12", "270, -5, -30", "0, 0, -27", "90, 90, -30"})
    void theSignalPassesThePattern(double azimuth, double elevation, double decibels) {
        Drone drone = at(azimuth, elevation, 800);
        Observation heard = look(EAST, open(), drone, 1);
        double expected = azimuth == 0 ? BEAM.gain(EAST.aim().from(EAST.position()), drone.origin()) : decibels;
        assertThat(heard.value()).isCloseTo(look(ROUND, open(), drone, 1).value() + expected, within(1e-9));
        assertThat(expected).isCloseTo(decibels, within(0.6));
        assertThat(heard.figures())
                .containsEntry("beam_gain_db", BEAM.gain(EAST.aim().from(EAST.position()), drone.origin()));
        assertThat(assess(EAST, open(), drone).quantity()).isEqualTo(heard.value());
    }

    /** Drone and pilot each have their own direction. */
    @Test
    void thePilotIsHeardThroughTheSamePattern() {
        Position drone = new Position(0, 900, 0);
        RadioLink link = RadioLink.DEFAULT.withPilot(new Position(900, 0, 0));
        Observation heard =
                look(EAST.withAim(new Aim.Direction(Math.toRadians(90), 0)), open(), emitting(drone, link), 1);
        assertThat(heard.figures().get("pilot_snr_db") - heard.figures().get("drone_snr_db"))
                .isCloseTo(link.pilotPower() - link.power() + 27, within(1e-9));
        assertThat(heard.value()).isEqualTo(heard.figures().get("pilot_snr_db"));
    }

    /** The reflected wave comes from below, where an antenna that points up hardly receives. */
    @Test
    void aReflectionPassesThePatternToo() {
        World flat = World.of(TriangleMesh.of(
                new float[] {-9000, -9000, -10, 9000, -9000, -10, 9000, 9000, -10, -9000, 9000, -10},
                new int[] {0, 1, 2, 0, 2, 3}));
        ReflectingGround ground = new ReflectingGround(15, 0, 0);
        RfSettings receiver = EAST.withAim(new Aim.Direction(Math.toRadians(90), Math.toRadians(8)))
                .withGroundReflection(ground, LinearPolarisation.HORIZONTAL);
        TwoRays rays = new TwoRays(flat, ground);
        for (double elevation = 3; elevation < 12; elevation += 0.5) {
            Drone drone = at(90, elevation, 300);
            double height = drone.origin().z();
            double width = drone.origin().x();
            Position down = new Position(width * 10 / (20 + height), 0, -10);
            double share = Math.pow(10, (gain(receiver, down) - gain(receiver, drone.origin())) / 20);
            double alone = look(EAST.withAim(receiver.aim()), flat, drone, 1).value();
            assertThat(look(receiver, flat, drone, 1).value() - alone)
                    .isCloseTo(
                            rays.weighted(receiver.position(), drone.origin(), 2.4e9, false, way -> share),
                            within(1e-6))
                    .isNotZero();
        }
    }

    private static double gain(RfSettings receiver, Position way) {
        double across = Math.atan2(-way.y(), way.x()) / BEAM.azimuthBeamwidth();
        double above = Math.atan2(way.z(), way.x()) - Math.toRadians(8);
        double upwards = above / BEAM.elevationBeamwidth();
        assertThat(receiver.beam()).contains(BEAM);
        return -Math.min(30, 12 * (across * across + upwards * upwards));
    }

    /** Too far for any direction: too weak. Near enough on the axis only: out of view. Behind a wall: hidden. */
    @Test
    void aDroneBesideTheBeamIsOutOfView() {
        assertThat(assess(EAST, open(), at(90, 5, 5000)).cause()).isEqualTo(Cause.DETECTED);
        assertThat(assess(EAST, open(), at(270, 5, 5000)).cause()).isEqualTo(Cause.OUT_OF_VIEW);
        assertThat(assess(EAST, open(), at(270, 5, 200)).cause()).isEqualTo(Cause.DETECTED);
        assertThat(assess(EAST, open(), at(90, 5, 50_000)).cause()).isEqualTo(Cause.TOO_WEAK);
        assertThat(assess(EAST, open(), at(270, 5, 50_000)).cause()).isEqualTo(Cause.TOO_WEAK);
        RfSettings north = ROUND.withBeam(BEAM);
        World walled = behind(wall(500, -100, 2000), ModelRole.BUILDING);
        assertThat(assess(north, walled, at(0, 5, 8000)).cause()).isEqualTo(Cause.HIDDEN_BY_BUILDING);
    }

    /** Without a beam neither value nor figures depend on the aim, to the last bit. */
    @Test
    void withoutABeamNothingChanges() {
        Drone drone = at(200, 7, 700);
        RfSettings aimed = ROUND.withAim(new Aim.Direction(1, 1));
        assertThat(look(aimed, open(), drone, 1)).isEqualTo(look(ROUND, open(), drone, 1));
        assertThat(look(ROUND, open(), drone, 1).figures()).containsOnlyKeys("drone_snr_db", "pilot_snr_db");
    }

    @Test
    void settingsThatDoNotFitAreReported() {
        assertThat(EAST.advice()).isEmpty();
        assertThat(ROUND.advice()).isEmpty();
        assertThat(EAST.withGain(16).advice())
                .containsExactly(
                        "an antenna of 16 dBi cannot have a beam of 60 x 20 deg, whose gain is at most 15.3 dBi");
        RfSettings dwelling =
                SettingsForm.with(ROUND, "rate", 4.0).withDwell(Dwell.of(0.05).withCount(5));
        assertThat(dwelling.advice()).isEmpty();
        assertThat(SettingsForm.with(dwelling, "rate", 5.0).advice())
                .containsExactly("5 x 0.05 s of dwell is longer than a look of 0.2 s: set a rate of at most 4 Hz");
        RfSettings slow = dwelling.withDwell(Dwell.of(0.03).withCount(1000));
        assertThat(slow.advice())
                .containsExactly(
                        "1000 x 0.03 s of dwell is longer than a look of 0.25 s: set a rate of at most 0.0333 Hz");
        assertThat(SettingsForm.with(slow, "rate", 0.0333).advice()).isEmpty();
        // Another sensor may hand its aim over to an omnidirectional antenna in its place: that is no mistake.
        assertThat(ROUND.withAim(new Aim.Direction(1, 0)).advice()).isEmpty();
    }
}
