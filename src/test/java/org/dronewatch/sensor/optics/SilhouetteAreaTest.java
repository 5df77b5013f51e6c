package org.dronewatch.sensor.optics;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

class SilhouetteAreaTest {
    private static final Position REST = new Position(0, 0, 0);
    private static final int STATES = 300;

    /** A triangle behind the camera. */
    private static final World BEHIND = World.of(new TriangleMesh(
            new float[] {-9, -9, -9, 9, -9, -9, 9, -9, 9},
            new int[] {0, 1, 2},
            new int[1],
            new int[1],
            List.of("ground")));

    /** Whatever the question, narrowed bounds hold; if none is answered, they meet at the area itself. */
    @Test
    void narrowedBoundsMeetAtTheArea() {
        long seed = System.nanoTime();
        System.out.println("SilhouetteAreaTest: seed " + seed);
        SplittableRandom random = new SplittableRandom(seed);
        Drone quadrotor = DroneSettings.of(ModelSettings.packaged("quadrotor.obj"), Hover.at(REST))
                .create("drone", Path.of(""));
        CameraObject camera = new CameraObject(
                CameraSettings.at(REST).withLookAt(new Position(0, 60, 10)).withResolution(640, 480));
        VisibleArea area = new VisibleArea(camera, BEHIND);
        SilhouetteArea silhouette = new SilhouetteArea(area);
        int inDoubt = 0;
        int early = 0;
        for (int i = 0; i < STATES; i++) {
            double range = 5.0 * Math.exp(4.0 * random.nextDouble());
            // At the border of the image, too.
            Position at =
                    new Position(1.2 * range * (random.nextDouble() - 0.5), range, (random.nextDouble() - 0.3) * range);
            FlightState state = new FlightState(at, REST, 6.0 * random.nextDouble());
            Drone there = quadrotor.at(state);
            String as = "seed %d, %s".formatted(seed, state);
            // A mask is made once it has been asked for twice.
            silhouette.bound(there, state);
            if (!silhouette.bound(there, state)) {
                continue;
            }
            double exact = area.of(there);
            double most = silhouette.most();
            assertThat(exact).as(as).isBetween(silhouette.least(), silhouette.most());
            if (most - silhouette.least() <= 1e-6 * most) {
                continue;
            }
            inDoubt++;
            assertThat(silhouette.likely()).as(as).isBetween(silhouette.least(), most);
            double limit = silhouette.least() + random.nextDouble() * (most - silhouette.least());
            boolean isDecided = silhouette.narrow(
                    there, silhouette.likely() > limit, () -> silhouette.least() > limit || silhouette.most() < limit);
            assertThat(isDecided).as(as).isTrue();
            assertThat(exact).as(as).isBetween(silhouette.least(), silhouette.most());
            early += silhouette.most() - silhouette.least() > 1e-6 * most ? 1 : 0;

            assertThat(silhouette.bound(there, state)).isTrue();
            assertThat(silhouette.narrow(there, i % 2 == 0, () -> false)).as(as).isFalse();
            assertThat(exact).as(as).isBetween(silhouette.least(), silhouette.most());
            assertThat(silhouette.most() - silhouette.least()).as(as).isLessThan(1e-8 * most);
        }
        assertThat(inDoubt).as("states in doubt").isGreaterThan(STATES / 10);
        assertThat(early).as("decided before all rays were traced").isGreaterThan(inDoubt / 2);
    }
}
