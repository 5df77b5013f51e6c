package org.dronewatch.drone;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.SplittableRandom;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.mesh.io.ModelSettings;
import org.jogamp.vecmath.Matrix4d;
import org.junit.jupiter.api.Test;

/** The radius of a drone against the distances of all corners of its mesh. */
class DroneRadiusTest {
    private static final int POSES = 200;

    private final Drone quadrotor = DroneSettings.of(
                    ModelSettings.packaged("quadrotor.obj"), Hover.at(new Position(0, 0, 0)))
            .create("drone", Path.of(""));

    private static double farthest(Drone drone) {
        TriangleMesh mesh = drone.tree().mesh();
        double farthest = 0.0;
        for (int triangle = 0; triangle < mesh.triangleCount(); triangle++) {
            for (int corner = 0; corner < 3; corner++) {
                Position point = new Position(
                        mesh.coordinate(triangle, corner, 0),
                        mesh.coordinate(triangle, corner, 1),
                        mesh.coordinate(triangle, corner, 2));
                farthest = Math.max(farthest, drone.toWorld(point).distance(drone.origin()));
            }
        }
        return farthest;
    }

    @Test
    void itIsTheSameOnAllHeadings() {
        SplittableRandom random = new SplittableRandom(System.nanoTime());
        Position still = new Position(0, 0, 0);
        double radius = quadrotor.radius();
        for (int i = 0; i < POSES; i++) {
            Drone turned = quadrotor.at(new FlightState(still, still, 7.0 * random.nextDouble()));
            assertThat(turned.radius()).isEqualTo(radius);
        }
        assertThat(radius).isCloseTo(farthest(quadrotor), within(1e-7));
        assertThat(radius).isGreaterThanOrEqualTo(farthest(quadrotor));
    }

    @Test
    void nothingReachesFartherHoweverItIsStretched() {
        long seed = System.nanoTime();
        System.out.println("DroneRadiusTest: seed " + seed);
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < POSES; i++) {
            Matrix4d matrix = new Matrix4d();
            boolean isSheared = i % 2 == 0;
            matrix.rotZ(7.0 * random.nextDouble());
            Matrix4d tilt = new Matrix4d();
            tilt.rotX(random.nextDouble());
            matrix.mul(tilt);
            matrix.setScale(0.1 + 3.0 * random.nextDouble());
            if (isSheared) {
                matrix.m01 += random.nextDouble() - 0.5;
                matrix.m20 += random.nextDouble() - 0.5;
            }
            if (Math.abs(matrix.determinant()) < 1e-6) {
                continue;
            }
            Drone drone = quadrotor.withModelMatrix(matrix);
            double farthest = farthest(drone);
            assertThat(drone.radius()).as("seed %d, %s", seed, matrix).isGreaterThanOrEqualTo(farthest);
            if (!isSheared) {
                assertThat(drone.radius()).as("seed %d, %s", seed, matrix).isCloseTo(farthest, within(1e-6 * farthest));
            }
        }
    }
}
