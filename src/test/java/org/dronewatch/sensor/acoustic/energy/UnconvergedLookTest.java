package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.RotorTones;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.RaySensor;
import org.dronewatch.sensor.acoustic.AcousticSensor;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sensor.acoustic.propagation.Diffraction;
import org.dronewatch.sound.Directivity;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.world.NoiseSource;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

/**
 * Three rooms in a row with small openings that do not face each other: in the third, a thousand rays bring a
 * microphone little of a drone in the first.
 */
class UnconvergedLookTest {
    private static final Position MICROPHONE = new Position(28, 2, 1.5);
    private static final Position PLACE = new Position(2, 2, 1.5);
    private static final double THRESHOLD = -5;

    private static World rooms() {
        TriangleMesh mesh = World.merge(List.of(
                Sites.room(30, 8, 4),
                Sites.wall(0, 10, 0, 7, 0, 4),
                Sites.wall(0, 10, 7.7, 8, 0, 4),
                Sites.wall(0, 20, 0, 0.3, 0, 4),
                Sites.wall(0, 20, 1, 8, 0, 4)));
        return Sites.world(mesh, SurfaceMaterial.uniform("rough", 0.5, 0.8));
    }

    private static Drone drone() {
        return drone(DroneSettings.of(ModelSettings.of("none.obj"), new Hover(PLACE, 0.0)));
    }

    private static Drone drone(RotorTones tones) {
        return drone(DroneSettings.of(ModelSettings.of("none.obj"), new Hover(PLACE, 0.0))
                .withTones(tones));
    }

    private static Drone drone(DroneSettings settings) {
        TriangleMesh any = TriangleMesh.of(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, new int[] {0, 1, 2});
        return new Drone("drone", settings, KDTree.of(any)).move(PLACE.toVector3d());
    }

    /** A line's figure is that on which the look is based; that of the octave says what the rays brought. */
    @Test
    void figuresOfTonesAreThoseOfTheDecision() {
        World rooms = rooms();
        Drone drone = drone(RotorTones.of(100));
        AcousticSensor sensor = AcousticSettings.at(MICROPHONE)
                .withPropagation(EnergyModel.DEFAULT
                        .withRays(1000)
                        .withDiffraction(Diffraction.OFF)
                        .withCriterion(EnergyModel.Criterion.NARROW_BAND))
                .create();
        int unconverged = 0;
        for (int seed = 0; seed < 12; seed++) {
            Observation heard = sensor.observe(rooms, List.of(drone), Look.of(seed, "sensor", 0, 10.0))
                    .get(0);
            double best = heard.figures().entrySet().stream()
                    .filter(figure -> figure.getKey().matches("tone_\\d+_snr_db"))
                    .mapToDouble(Map.Entry::getValue)
                    .max()
                    .orElseThrow();
            assertThat(best).as("seed %d", seed).isEqualTo(heard.value());
            unconverged += heard.figures().get("converged") == 0.0 ? 1 : 0;
        }
        assertThat(unconverged).isGreaterThan(0);
    }

    /** The sound of a noise source that few rays reach is marked, in the background of every look. */
    @Test
    void aNoiseSourceThatHasNotConvergedMarksTheBackground() {
        AcousticSensor sensor = AcousticSettings.at(MICROPHONE)
                .withPropagation(EnergyModel.DEFAULT.withRays(1000).withDiffraction(Diffraction.OFF))
                .create();
        Look look = Look.of(1, "sensor", 0, 10.0);
        int unconverged = 0;
        for (int i = 0; i < 12; i++) {
            // The rays depend on the name.
            String name = "engine" + i;
            World far = rooms().withNoiseSources(Map.of(name, NoiseSource.at(PLACE, 100)));
            World near = rooms().withNoiseSources(Map.of(name, NoiseSource.at(new Position(27, 4, 1.5), 100)));
            unconverged += mark(sensor, far, look) == 0.0 ? 1 : 0;
            assertThat(mark(sensor, near, look)).isEqualTo(1.0);
        }

        assertThat(unconverged).isPositive();
        assertThat(sensor.observe(rooms(), List.of(drone()), look).get(0).figures())
                .doesNotContainKey("background_converged");
    }

    private static double mark(AcousticSensor sensor, World world, Look look) {
        return sensor.observe(world, List.of(drone()), look).get(0).figures().get("background_converged");
    }

    /** Rays that find no way at all do not prove silence; a drone without a sound is silent. */
    @Test
    void silenceIsNotKnown() {
        World world = Sites.world(Sites.room(10, 8, 4), SurfaceMaterial.uniform("rough", 0.5, 0.8));
        EnergyModel model = EnergyModel.DEFAULT.withRays(1000).withDiffraction(Diffraction.OFF);
        Position outside = new Position(5, 4, 6);
        EnergyReading nothing = Sites.read(model, world, Sites.broadband(outside), PLACE, 1);
        assertThat(nothing.totalLevel()).isEqualTo(Double.NEGATIVE_INFINITY);
        assertThat(nothing.isConverged()).isFalse();

        SoundSource silent = new SoundSource(
                PLACE, Collections.nCopies(OctaveBands.COUNT, Double.NEGATIVE_INFINITY), Directivity.OMNIDIRECTIONAL);
        EnergyReading silence = Sites.read(model, world, silent, new Position(7, 5, 1.5), 1);
        assertThat(silence.totalLevel()).isEqualTo(Double.NEGATIVE_INFINITY);
        assertThat(silence.isConverged()).isTrue();
    }

    /** However loud the few rays were: the exact paths decide, here none, and the look says how uncertain it is. */
    @Test
    void whatFewRaysBringDoesNotDecideALook() {
        World rooms = rooms();
        Drone drone = drone();
        AcousticSensor sensor = AcousticSettings.at(MICROPHONE)
                .withThreshold(THRESHOLD)
                .withPropagation(EnergyModel.DEFAULT.withRays(1000).withDiffraction(Diffraction.OFF))
                .create();
        int unconverged = 0;
        int loud = 0;
        for (int seed = 0; seed < 12; seed++) {
            Look look = Look.of(seed, "sensor", 0, 10.0);
            Observation heard = sensor.observe(rooms, List.of(drone), look).get(0);
            Assessment assessed = sensor.assess(rooms, drone, Optional.empty(), look.random("drone", RaySensor.RAYS));
            double byRays = heard.figures().get("reverberant_db");
            Double stated = heard.figures().get("standard_error_db");
            assertThat(stated == null)
                    .as("no error of nothing: %s", heard.figures())
                    .isEqualTo(byRays == Double.NEGATIVE_INFINITY);
            double error = stated == null ? 0 : stated;
            assertThat(assessed.quantity()).isEqualTo(heard.value());
            assertThat(assessed.standardError()).isEqualTo(error);
            if (heard.figures().get("converged") == 0.0 && byRays > Double.NEGATIVE_INFINITY) {
                assertThat(heard.isDetected()).isFalse();
                assertThat(heard.value()).isEqualTo(Double.NEGATIVE_INFINITY);
                assertThat(error).isPositive();
                assertThat(assessed.isEstimated()).isTrue();
                unconverged++;
                loud += byRays >= heard.threshold() ? 1 : 0;
            }
        }
        assertThat(unconverged).isGreaterThan(3);
        assertThat(loud).as("looks whose rays alone would be loud enough").isGreaterThan(2);
    }
}
