package org.dronewatch.sensor.radar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dronewatch.sensor.Walls.assess;
import static org.dronewatch.sensor.Walls.behind;
import static org.dronewatch.sensor.Walls.cube;
import static org.dronewatch.sensor.Walls.look;
import static org.dronewatch.sensor.Walls.open;
import static org.dronewatch.sensor.Walls.wall;

import java.util.Optional;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.radar.LinkBudget.Hardware;
import org.dronewatch.sensor.radar.Rain.Polarisation;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Echoes of drones behind walls, with the loss at edges after ITU-R P.526 on both ways. */
class RadarShadowTest {
    private static final double FREQUENCY = 2.4e9;
    private static final Hardware STRONG = new Hardware(1e6, 33, 0.02, 10e6, 0, 0);
    private static final RadarSettings RADAR = RadarSettings.at(new Position(0, 0, 20), STRONG)
            .withFieldOfView(Math.toRadians(60), Math.toRadians(40))
            .withWave(FREQUENCY, Polarisation.HORIZONTAL)
            .withDiffraction(true);

    private static Drone coming(double north, double height) {
        return cube(new Position(0, north, height), new Position(0, -10, 0));
    }

    /** Twice what is lost one way: 34.0 dB over a sheet of 60 m at 501 m, 6.03 dB where the edge touches the line. */
    @ParameterizedTest
    @CsvSource({"60, 10, 68.0, 0.1", "20, 20, 12.06, 0.05", "-20, 10, 0, 1e-9"})
    void anEdgeTakesItsShareOnBothWays(float top, double height, double loss, double tolerance) {
        World world = World.of(TriangleMesh.of(
                new float[] {-5000, 501, -50, 5000, 501, -50, 5000, 501, top, -5000, 501, top},
                new int[] {0, 1, 2, 0, 2, 3}));
        Observation shadow = look(RADAR, world, coming(1000, height), 0);
        double free = look(RADAR, open(), coming(1000, height), 0).value();
        assertThat(free - shadow.value()).isCloseTo(loss, within(tolerance));
        assertThat(shadow.figures().get("diffraction_loss_db")).isCloseTo(free - shadow.value(), within(1e-9));
    }

    /** Rising out of the shadow, the echo grows without a step; without diffraction it is all or nothing. */
    @Test
    void theEchoGrowsAsTheDroneRises() {
        World world = behind(wall(501, -50, 60), ModelRole.BUILDING);
        double before = Double.NEGATIVE_INFINITY;
        for (double height = 40; height <= 110; height += 0.5) {
            double echo = look(RADAR, world, coming(1000, height), 0).value();
            if (height > 40) {
                assertThat(echo - before).as("height %f", height).isBetween(-0.5, 1.5);
            }
            before = echo;
        }
        RadarSettings sharp = RADAR.withDiffraction(false);
        assertThat(look(sharp, world, coming(1000, 90), 0).value()).isEqualTo(Double.NEGATIVE_INFINITY);
        assertThat(look(sharp, world, coming(1000, 110), 0).value()).isFinite();
        assertThat(look(sharp, world, coming(1000, 110), 0).figures()).doesNotContainKey("diffraction_loss_db");
    }

    @Test
    void aMissInTheShadowNamesWhatHides() {
        World world = behind(wall(501, -50, 60), ModelRole.BUILDING);
        Drone drone = coming(1000, 10);
        assertThat(assess(RADAR, world, drone).cause()).isEqualTo(Cause.DETECTED);
        RadarSettings weaker = RADAR.withBudget(new Hardware(4, 33, 0.02, 10e6, 0, 0));
        Assessment hidden = assess(weaker, world, drone);
        assertThat(hidden.cause()).isEqualTo(Cause.HIDDEN_BY_BUILDING);
        assertThat(hidden.quantity())
                .isEqualTo(look(weaker, world, drone, 0).value())
                .isFinite();
        RadarSettings weak = RADAR.withBudget(new Hardware(1e-6, 20, 0.02, 10e6, 0, 0));
        assertThat(assess(weak, world, drone).cause()).isEqualTo(Cause.TOO_WEAK);
    }

    /**
     * An edge 1 m below the line in the middle of 1 km takes 3.9 dB each way (ITU-R P.526, v = -0.25): because of it, a
     * drone that is in sight is missed.
     */
    @Test
    void aDroneInSightIsHiddenByTheEdgeThatTakesItsEcho() {
        Drone drone = coming(1000, 20);
        World world = behind(wall(501, -50, 19), ModelRole.BUILDING);
        RadarSettings weaker = RADAR.withBudget(new Hardware(4, 33, 0.02, 10e6, 0, 0));
        double open = look(weaker, open(), drone, 0).value();
        Observation beside = look(weaker, world, drone, 0);
        assertThat(beside.figures()).containsEntry("visible_share", 1.0);
        assertThat(open - beside.value()).isCloseTo(7.8, within(0.1));
        RadarSettings radar = weaker.withDetection(new RadarDetection.FixedThreshold(open - 2));
        Assessment missed = assess(radar, world, drone);
        assertThat(missed.cause()).isEqualTo(Cause.HIDDEN_BY_BUILDING);
        assertThat(missed.obstacle().orElseThrow().model().file()).isEqualTo("wall.obj");
        assertThat(assess(radar, open(), drone).cause()).isEqualTo(Cause.DETECTED);
    }

    /** The share that is in sight is a figure of its own; there is none of a drone that the radar does not look for. */
    @Test
    void theVisibleShareIsGivenThoughTheEchoGoesRoundEdges() {
        World world = behind(wall(501, -50, 60), ModelRole.BUILDING);
        Observation hidden = look(RADAR, world, coming(1000, 10), 0);
        assertThat(hidden.value()).isFinite();
        assertThat(hidden.figures()).containsEntry("visible_share", 0.0);
        Observation standing = look(RADAR, open(), cube(new Position(0, 1000, 20)), 0);
        assertThat(standing.figures()).containsEntry("visible_share", 0.0).containsEntry("in_field", 1.0);
    }

    /** Where nothing is in the way, chance alone is left as the reason for a miss: the echo is too weak for it. */
    @Test
    void aMissByChanceInTheOpenIsTooWeak() {
        RadarSensor sensor = RADAR.create();
        assertThat(sensor.explainMiss(open(), coming(1000, 20), Optional.empty())
                        .cause())
                .isEqualTo(Cause.TOO_WEAK);
    }
}
