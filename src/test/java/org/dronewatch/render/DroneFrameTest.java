package org.dronewatch.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Random;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.camera.Shapes;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.sensor.optics.DronePicture;
import org.dronewatch.sensor.optics.DronePixels;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

class DroneFrameTest {
    private static final CameraSettings CAMERA = CameraSettings.at(new Position(0, 0, 2))
            .withLookAt(new Position(0, 10, 2))
            .withResolution(120, 80)
            .withVerticalFov(0.6);

    private final World ground = World.of(Shapes.ground(200, 0));

    private DronePixels pixels(Position at, double radius) {
        Drone drone = Shapes.drone("ball", Shapes.sphere(radius, 3), at);
        return new DronePicture(new CameraObject(CAMERA))
                .pixels(ground, List.of(drone))
                .get(0);
    }

    @Test
    void isCentredOnTheDroneAndLeavesAPixelFree() {
        DronePixels ball = pixels(new Position(0, 10, 2), 1.0);
        Rectangle2D.Double frame = DroneFrame.about(ball, 120, 80, new Rectangle(5, 7, 240, 160), 14.0);
        assertThat(frame.getCenterX()).isCloseTo(5 + 120, within(1e-9));
        assertThat(frame.getCenterY()).isCloseTo(7 + 80, within(1e-9));
        assertThat(frame.width).isCloseTo(2.0 * (ball.columns() + 2), within(1e-9));
        assertThat(frame.height).isCloseTo(2.0 * (ball.rows() + 2), within(1e-9));
        Rectangle2D.Double small =
                DroneFrame.about(pixels(new Position(0, 40, 2), 0.5), 120, 80, new Rectangle(120, 80), 14.0);
        assertThat(small).isEqualTo(new Rectangle2D.Double(53, 33, 14, 14));
    }

    /** Drones at every edge and beyond, and one that fills the image. */
    @Test
    void staysInsideThePictureAndShowsAllOfTheDroneThatIsInIt() {
        long seed = 16_180;
        System.out.println("seed of the drones: " + seed);
        Random random = new Random(seed);
        int atAnEdge = 0;
        for (int i = 0; i < 400; i++) {
            Position at = new Position(random.nextDouble(-6, 6), 10, random.nextDouble(0, 6));
            DronePixels drone = pixels(at, i % 50 == 0 ? 9.0 : random.nextDouble(0.05, 1.0));
            if (drone.count() == 0) {
                continue;
            }
            Rectangle picture = new Rectangle(3, 4, random.nextInt(60, 600), random.nextInt(40, 400));
            double sx = picture.width / 120.0;
            double sy = picture.height / 80.0;
            Rectangle2D.Double frame = DroneFrame.about(drone, 120, 80, picture, 14.0);
            assertThat(new Rectangle2D.Double(
                                    picture.x + 0.999, picture.y + 0.999, picture.width - 1.998, picture.height - 1.998)
                            .contains(frame))
                    .as("%s in %s", frame, picture)
                    .isTrue();
            // The line itself may cover the outermost pixel of the picture.
            Rectangle2D shown = new Rectangle2D.Double(
                            picture.x + drone.left() * sx,
                            picture.y + drone.top() * sy,
                            drone.columns() * sx,
                            drone.rows() * sy)
                    .createIntersection(new Rectangle2D.Double(
                            picture.x + 1.001, picture.y + 1.001, picture.width - 2.002, picture.height - 2.002));
            assertThat(frame.contains(shown)).as("%s about %s", frame, shown).isTrue();
            boolean isAtTheEdge = drone.left() == 0
                    || drone.top() == 0
                    || drone.left() + drone.columns() == 120
                    || drone.top() + drone.rows() == 80;
            atAnEdge += isAtTheEdge ? 1 : 0;
        }
        assertThat(atAnEdge).isGreaterThan(40);
    }
}
