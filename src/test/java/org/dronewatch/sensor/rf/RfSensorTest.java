package org.dronewatch.sensor.rf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dronewatch.sensor.Walls.FAR;
import static org.dronewatch.sensor.Walls.assess;
import static org.dronewatch.sensor.Walls.behind;
import static org.dronewatch.sensor.Walls.block;
import static org.dronewatch.sensor.Walls.cube;
import static org.dronewatch.sensor.Walls.look;
import static org.dronewatch.sensor.Walls.open;
import static org.dronewatch.sensor.Walls.wall;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.TreeMap;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.RadioLink;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Signal;
import org.dronewatch.sensor.radio.AntennaPattern;
import org.dronewatch.sensor.radio.LinearPolarisation;
import org.dronewatch.sensor.radio.ReflectingGround;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.world.SiteModel;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** One receiver at several sites, and drones that are received only just, or in no direction at all. */
class RfSensorTest {
    private static final Position ANTENNA = new Position(0, 0, 0);
    private static final RfSettings RECEIVER = RfSettings.at(ANTENNA);
    private static final AntennaPattern BEAM = AntennaPattern.of(Math.toRadians(60), Math.toRadians(20));

    private static Drone emitting(Position place, Position velocity, RadioLink link) {
        DroneSettings settings =
                DroneSettings.of(ModelSettings.of("cube.obj"), Hover.at(place)).withRadio(link);
        return cube(settings, place, velocity);
    }

    private static Drone emitting(double north, RadioLink link) {
        return emitting(new Position(0, north, 0), ANTENNA, link);
    }

    private static Observation next(RfSensor sensor, World world, Drone drone) {
        return sensor.observe(world, List.of(drone), Look.of(1, "sensor", 0, 10.0))
                .get(0);
    }

    private static Signal signal(RfSensor sensor, World world, Drone drone) {
        return sensor.signal(world, drone, Optional.empty(), new SplittableRandom(1));
    }

    /** What it remembers of a site, walls and the pilot's signal, it forgets at another. */
    @Test
    void atAnotherSiteItReceivesLikeANewReceiver() {
        Drone drone = emitting(600, RadioLink.DEFAULT.withPilot(new Position(10, 400, 0)));
        World field = open();
        World town = behind(block(200, 60), ModelRole.BUILDING);
        assertThat(look(RECEIVER, town, drone, 1)).isNotEqualTo(look(RECEIVER, field, drone, 1));
        RfSensor sensor = RECEIVER.create();
        for (World world : List.of(field, town, town, field, town)) {
            assertThat(next(sensor, world, drone)).isEqualTo(look(RECEIVER, world, drone, 1));
        }
        for (World world : List.of(field, town, town, field)) {
            assertThat(signal(sensor, world, drone))
                    .isEqualTo(assess(RECEIVER, world, drone).signal());
        }
    }

    @Test
    void itExplainsAMissAtASiteWhereItHasNotLookedBefore() {
        Drone drone = emitting(3000, RadioLink.DEFAULT);
        World town = behind(block(500, 99), ModelRole.BUILDING);
        World wood = behind(block(500, 99), ModelRole.VEGETATION);
        RfSensor sensor = RECEIVER.create();
        assertThat(sensor.explainMiss(town, drone, Optional.empty()).cause()).isEqualTo(Cause.HIDDEN_BY_BUILDING);
        assertThat(sensor.explainMiss(wood, drone, Optional.empty()).cause()).isEqualTo(Cause.HIDDEN_BY_VEGETATION);
    }

    /** The threshold is the very signal that arrives in the open; of 0 dBm and 0 dBi, no sum is rounded differently. */
    @Test
    void aWallHidesWhatJustReachesTheThresholdInTheOpen() {
        Drone drone = emitting(300, RadioLink.DEFAULT.withPower(0));
        double just = assess(RECEIVER, open(), drone).quantity();
        RfSettings receiver = RECEIVER.withThreshold(just);
        World town = behind(block(100, 40), ModelRole.BUILDING);
        assertThat(assess(receiver, open(), drone).cause()).isEqualTo(Cause.DETECTED);
        assertThat(assess(receiver, town, drone).cause()).isEqualTo(Cause.HIDDEN_BY_BUILDING);
        RfSettings higher = RECEIVER.withThreshold(Math.nextUp(just));
        assertThat(assess(higher, open(), drone).cause()).isEqualTo(Cause.TOO_WEAK);
        assertThat(assess(higher, town, drone).cause()).isEqualTo(Cause.TOO_WEAK);
    }

    /** Clutter alone takes too much: the wall makes no difference. */
    @Test
    void aWallDoesNotHideWhatClutterTakes() {
        Drone drone = emitting(3000, RadioLink.DEFAULT);
        World town = behind(block(500, 99), ModelRole.BUILDING);
        double spare = assess(RECEIVER, open(), drone).margin();
        assertThat(spare).isBetween(1.0, 6.0);
        assertThat(assess(RECEIVER, town, drone).cause()).isEqualTo(Cause.HIDDEN_BY_BUILDING);
        assertThat(assess(RECEIVER.withClutter(spare - 0.01), town, drone).cause())
                .isEqualTo(Cause.HIDDEN_BY_BUILDING);
        assertThat(assess(RECEIVER.withClutter(spare + 0.01), town, drone).cause())
                .isEqualTo(Cause.TOO_WEAK);
    }

    /** A building before the drone in the north, a wood before the pilot in the south, who is as far away. */
    @Test
    void ofTwoEqualEmissionsThatOfTheDroneSaysWhatHides() {
        TreeMap<Integer, SiteModel> models = new TreeMap<>(Map.of(
                0, new SiteModel("far.obj", ModelRole.OTHER),
                2, new SiteModel("house.obj", ModelRole.BUILDING),
                6, new SiteModel("wood.obj", ModelRole.VEGETATION)));
        World site = World.of(World.merge(List.of(FAR, block(100, 50), wall(-100, -999, 50))))
                .withModels(models);
        RadioLink link = RadioLink.DEFAULT.withPilot(new Position(0, -300, 0));
        RfSettings receiver = RECEIVER.withThreshold(
                assess(RECEIVER, open(), emitting(300, link)).quantity() - 0.1);
        assertThat(assess(receiver, site, emitting(300, link)).cause()).isEqualTo(Cause.HIDDEN_BY_BUILDING);
        RadioLink louder = SettingsForm.with(link, "pilotPower", 20.000001);
        assertThat(assess(receiver, site, emitting(300, louder)).cause()).isEqualTo(Cause.HIDDEN_BY_VEGETATION);
        RadioLink quieter = SettingsForm.with(link, "pilotPower", 19.999999);
        assertThat(assess(receiver, site, emitting(300, quieter)).cause()).isEqualTo(Cause.HIDDEN_BY_BUILDING);
    }

    /** The pilot would be received on the axis of the beam, and stands behind it; the drone is too weak anywhere. */
    @Test
    void aPilotBesideTheBeamIsOutOfView() {
        RfSettings east = RECEIVER.withBeam(BEAM).withAim(new Aim.Direction(Math.toRadians(90), 0));
        RadioLink link = RadioLink.DEFAULT.withPower(-100);
        Drone west = emitting(500, link.withPilot(new Position(-1000, 0, 0)));
        Drone ahead = emitting(500, link.withPilot(new Position(1000, 0, 0)));
        Drone far = emitting(500, link.withPilot(new Position(-100_000, 0, 0)));
        assertThat(assess(east, open(), west).cause()).isEqualTo(Cause.OUT_OF_VIEW);
        assertThat(assess(east, open(), ahead).cause()).isEqualTo(Cause.DETECTED);
        assertThat(assess(east, open(), far).cause()).isEqualTo(Cause.TOO_WEAK);
    }

    /** No direction leads to where the antenna itself is: it counts as the axis, wherever that points. */
    @ParameterizedTest
    @CsvSource({"0, 0", "45, 5", "135, 5", "135, -5", "225, 5", "225, -5", "225, -80", "315, -5", "0, -90", "0, 90"})
    void atTheAntennaABeamHasItsFullGain(double azimuth, double elevation) {
        RfSettings aimed =
                RECEIVER.withBeam(BEAM).withAim(new Aim.Direction(Math.toRadians(azimuth), Math.toRadians(elevation)));
        Drone here = emitting(0, RadioLink.DEFAULT);
        assertThat(look(aimed, open(), here, 1).value())
                .isEqualTo(look(RECEIVER, open(), here, 1).value());
        assertThat(look(aimed, open(), here, 1).figures()).containsEntry("beam_gain_db", 0.0);
    }

    /** Within a metre, as at a metre. */
    @ParameterizedTest
    @CsvSource({"0", "0.3", "0.999999"})
    void nearerThanAMetreTheSignalGrowsNoFurther(double north) {
        double atOneMetre =
                look(RECEIVER, open(), emitting(1.0, RadioLink.DEFAULT), 1).value();
        assertThat(look(RECEIVER, open(), emitting(north, RadioLink.DEFAULT), 1).value())
                .isEqualTo(atOneMetre);
        assertThat(look(RECEIVER, open(), emitting(1.000001, RadioLink.DEFAULT), 1)
                        .value())
                .isLessThan(atOneMetre);
    }

    @ParameterizedTest
    @CsvSource({"20, 0, 0", "0, 20, 0", "-5, -5, 0", "0, 0, -3"})
    void headingAndSpeedMakeNoDifference(double east, double north, double up) {
        Position place = new Position(700, 1500, 60);
        World town = behind(block(500, 30), ModelRole.BUILDING);
        Drone still = emitting(place, ANTENNA, RadioLink.DEFAULT);
        Drone flying = emitting(place, new Position(east, north, up), RadioLink.DEFAULT);
        RfSensor sensor = RECEIVER.create();
        assertThat(sensor.isSameAtAllHeadings(town, flying, Optional.empty())).isTrue();
        Assessment expected = assess(RECEIVER, town, still);
        assertThat(assess(RECEIVER, town, flying)).isEqualTo(expected);
        assertThat(signal(sensor, town, flying)).isEqualTo(expected.signal());
    }

    @Test
    void itsLooksAreThoseOfAnRfSensor() {
        Observation seen = look(RECEIVER, open(), emitting(100, RadioLink.DEFAULT), 1);
        assertThat(seen.kind()).isEqualTo("rf");
        assertThat(seen.unit()).isEqualTo("dB");
        assertThat(seen.range()).isEqualTo(100.0);
        assertThat(next(RECEIVER.create(), open(), emitting(100, RadioLink.DEFAULT)))
                .isEqualTo(seen);
    }

    /**
     * Over flat ground 10 m below, the direct and the reflected wave cancel out at 770 m. A building whose edge is 2 m
     * beside the line weakens the signal a little; it is the ground that makes it too weak.
     */
    @Test
    void aDroneWhoseSignalTheGroundCancelsIsNotHiddenByAnEdgeBesideTheLine() {
        TriangleMesh ground = TriangleMesh.of(
                new float[] {-9000, -9000, -10, 9000, -9000, -10, 9000, 9000, -10, -9000, 9000, -10},
                new int[] {0, 1, 2, 0, 2, 3});
        TriangleMesh building = TriangleMesh.of(
                new float[] {2, 500, -10, 400, 500, -10, 400, 500, 60, 2, 500, 60}, new int[] {0, 1, 2, 0, 2, 3});
        World plain = World.of(ground);
        TreeMap<Integer, SiteModel> models = new TreeMap<>(Map.of(
                0, new SiteModel("ground.obj", ModelRole.TERRAIN), 2, new SiteModel("house.obj", ModelRole.BUILDING)));
        World built = World.of(World.merge(List.of(ground, building))).withModels(models);
        Drone drone = emitting(770, RadioLink.DEFAULT);
        RfSettings overGround =
                RECEIVER.withGroundReflection(new ReflectingGround(15, 0, 0), LinearPolarisation.HORIZONTAL);
        double free = look(RECEIVER, plain, drone, 1).value();
        double cancelled = look(overGround, plain, drone, 1).value();
        double besideTheEdge = look(RECEIVER, built, drone, 1).value();
        assertThat(cancelled).isLessThan(free - 6.0);
        assertThat(besideTheEdge).isBetween(free - 2.0, free - 0.5);

        RfSettings between = overGround.withThreshold(cancelled + 4.0);
        assertThat(between.threshold()).isLessThan(besideTheEdge);
        assertThat(assess(between, plain, drone).cause()).isEqualTo(Cause.TOO_WEAK);
        assertThat(assess(between, built, drone).cause()).isEqualTo(Cause.TOO_WEAK);
        // Where the edge decides, it is still the cause.
        RfSettings above = overGround.withThreshold(cancelled - 0.5);
        assertThat(look(overGround, built, drone, 1).value()).isLessThan(above.threshold());
        assertThat(assess(above, built, drone).cause()).isEqualTo(Cause.HIDDEN_BY_BUILDING);
    }

    /**
     * The antenna looks down at the ground where the wave is reflected, and hardly receives the direct wave. On its
     * axis, the direct and the reflected wave would be equal: the difference off the axis does not count there.
     */
    @Test
    void aDroneThatIsTooWeakEvenOnTheAxisIsNotOutOfView() {
        TriangleMesh ground = TriangleMesh.of(
                new float[] {-9000, -9000, -10, 9000, -9000, -10, 9000, 9000, -10, -9000, 9000, -10},
                new int[] {0, 1, 2, 0, 2, 3});
        World plain = World.of(ground);
        Drone drone = emitting(100, RadioLink.DEFAULT);
        ReflectingGround smooth = new ReflectingGround(15, 0, 0);
        RfSettings omnidirectional = RECEIVER.withGroundReflection(smooth, LinearPolarisation.HORIZONTAL);
        double onAxis = look(omnidirectional, plain, drone, 1).value();
        RfSettings down = omnidirectional
                .withBeam(AntennaPattern.of(Math.toRadians(10), Math.toRadians(10)))
                .withAim(new Aim.Direction(0.0, Math.toRadians(-30)));
        assertThat(look(down, plain, drone, 1).value()).isLessThan(onAxis - 6.0);

        assertThat(assess(down.withThreshold(onAxis + 1.0), plain, drone).cause())
                .isEqualTo(Cause.TOO_WEAK);
        assertThat(assess(down.withThreshold(onAxis - 1.0), plain, drone).cause())
                .isEqualTo(Cause.OUT_OF_VIEW);
    }
}
