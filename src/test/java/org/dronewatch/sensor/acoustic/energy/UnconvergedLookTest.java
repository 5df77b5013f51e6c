package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
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
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

/**
 * Three rooms in a row with small openings that do not face each other: in the third, a thousand rays bring a
 * microphone little of a drone in the first.
 */
class UnconvergedLookTest {
    private static final Position MICROPHONE = new Position(28, 2, 1.5);
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
        Position place = new Position(2, 2, 1.5);
        TriangleMesh any = TriangleMesh.of(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, new int[] {0, 1, 2});
        DroneSettings settings = DroneSettings.of(ModelSettings.of("none.obj"), new Hover(place, 0.0));
        return new Drone("drone", settings, KDTree.of(any)).move(place.toVector3d());
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
            double error = heard.figures().get("standard_error_db");
            assertThat(assessed.quantity()).isEqualTo(heard.value());
            assertThat(assessed.standardError()).isEqualTo(error);
            if (heard.figures().get("converged") == 0.0) {
                assertThat(heard.isDetected()).isFalse();
                assertThat(heard.value()).isEqualTo(Double.NEGATIVE_INFINITY);
                assertThat(error).isPositive();
                assertThat(assessed.isEstimated()).isTrue();
                unconverged++;
                loud += heard.figures().get("reverberant_db") >= heard.threshold() ? 1 : 0;
            }
        }
        assertThat(unconverged).isGreaterThan(3);
        assertThat(loud).as("looks whose rays alone would be loud enough").isGreaterThan(2);
    }
}
